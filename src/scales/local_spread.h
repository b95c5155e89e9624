#pragma once

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

namespace pcl {
namespace manifold {

/** How a point and those around it spread: the principal components of their positions. */
class LocalSpread
{
public:
  /** \param[in] to from the point to one around it */
  void add (const Eigen::Vector3d& to)
  {
    sum_ += to;
    moments_ += to * to.transpose ();
    ++count_;
  }

  /** How many were added. */
  int count () const { return count_; }

  void solve ()
  {
    const Eigen::Vector3d mean = sum_ / (count_ + 1);
    const Eigen::Matrix3d covariance = moments_ / (count_ + 1) - mean * mean.transpose ();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver (covariance);
    sigma_ = solver.eigenvalues ().cwiseMax (0.0).cwiseSqrt ();
    direction_ = solver.eigenvectors ().col (2);
  }

  /** Standard deviations in ascending order, once solved. */
  const Eigen::Vector3d& sigma () const { return sigma_; }

  /** Unit vector along the largest. */
  const Eigen::Vector3d& direction () const { return direction_; }

  /** (sigma1 - sigma2) / sigma1 of the two largest: 1 on a line; 0 where all are at the point. */
  double linearity () const { return sigma_[2] > 0.0 ? (sigma_[2] - sigma_[1]) / sigma_[2] : 0.0; }

private:
  Eigen::Vector3d sum_ = Eigen::Vector3d::Zero ();
  Eigen::Matrix3d moments_ = Eigen::Matrix3d::Zero ();
  int count_ = 0;
  Eigen::Vector3d sigma_ = Eigen::Vector3d::Zero (), direction_ = Eigen::Vector3d::Zero ();
};

} // namespace manifold
} // namespace pcl
