#pragma once

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <variant>
#include <vector>

namespace generate {

struct Ray
{
  Eigen::Vector3d origin;
  Eigen::Vector3d direction; ///< unit
};

/** \brief The truth about a thing in a scene. */
struct Truth
{
  std::uint32_t label;  ///< manifold dimension
  std::uint32_t object; ///< class
};

struct RayHit
{
  double range;
  Truth truth;
  bool partial; ///< the thing is smaller than the beam, and part of the light goes on
};

/** \brief Things in space that a ray can hit: triangles, discs, round rods and rolling ground. */
class RayScene
{
public:
  /** \param[in] beam_radius half the width of a pulse of light, not negative. A rod thinner than that answers
   * when the pulse touches it. */
  explicit RayScene (double beam_radius) : beam_radius_ (beam_radius) {}

  void addTriangle (const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                    Truth truth);

  /** \brief A disc that lets part of the light pass, such as a leaf. */
  void addDisc (const Eigen::Vector3d& centre, const Eigen::Vector3d& normal, double radius, Truth truth);

  /** \brief A round rod without caps. */
  void addRod (const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius, Truth truth);

  /** \brief Ground of the given height above each point of the plane.
   * \param[in] steepest upper bound of its slope */
  void setGround (std::function<double (double x, double y)> height, double steepest, Truth truth);

  /** \brief Makes the scene ready for rays; to be called once all is added. */
  void build ();

  /** \brief The nearest thing between two distances along a ray. */
  std::optional<RayHit> cast (const Ray& ray, double from, double to) const;

private:
  struct Triangle
  {
    Eigen::Vector3d a, b, c;
  };

  struct Disc
  {
    Eigen::Vector3d centre, normal;
    double radius;
  };

  struct Rod
  {
    Eigen::Vector3d from, axis; ///< axis of unit length
    double length, radius;
  };

  struct Thing
  {
    std::variant<Triangle, Disc, Rod> form;
    Truth truth;
    bool partial;
    Eigen::AlignedBox3d bounds;
  };

  struct Node
  {
    Eigen::AlignedBox3d bounds;
    std::size_t first, count; ///< its things if count is not 0; otherwise first is its right child
  };

  void buildNode (std::size_t first, std::size_t last);

  std::optional<double> hit (const Triangle& triangle, const Ray& ray, double from) const;
  std::optional<double> hit (const Disc& disc, const Ray& ray, double from) const;
  std::optional<double> hit (const Rod& rod, const Ray& ray, double from) const;

  std::optional<double> hitGround (const Ray& ray, double from, double to) const;

  double beam_radius_;
  std::vector<Thing> things_;
  std::vector<Node> nodes_; ///< a left child comes right after its parent
  std::function<double (double x, double y)> ground_;
  double steepest_ = 0.0;
  Truth ground_truth_{0, 0};
};

} // namespace generate
