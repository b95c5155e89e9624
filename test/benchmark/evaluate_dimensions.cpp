#include <chrono>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <pcl/conversions.h>
#include <pcl/io/pcd_io.h>
#include <pcl/manifold/scale_dimensions.h>
#include <pcl/point_types.h>
#include <set>
// prototype of the command: FILE [-truth 14,15] [-out prefix]
int
main (int c, char** v)
{
  pcl::PCLPointCloud2 b;
  if (pcl::io::loadPCDFile (v[1], b) < 0)
    return 1;
  pcl::PointCloud<pcl::PointXYZ> cl;
  pcl::fromPCLPointCloud2 (b, cl);
  std::vector<double> truth;
  for (const auto& f : b.fields)
    if (f.name == "label")
      for (std::size_t i = 0; i < cl.size (); ++i) {
        const std::uint8_t* p = &b.data[i * b.point_step + f.offset];
        double x = 0;
        switch (f.datatype) {
          case 2:
            x = *p;
            break;
          case 4: {
            std::uint16_t y;
            memcpy (&y, p, 2);
            x = y;
            break;
          }
          case 6: {
            std::uint32_t y;
            memcpy (&y, p, 4);
            x = y;
            break;
          }
          case 5: {
            std::int32_t y;
            memcpy (&y, p, 4);
            x = y;
            break;
          }
          case 7: {
            float y;
            memcpy (&y, p, 4);
            x = y;
            break;
          }
        }
        truth.push_back (x);
      }
  std::set<double> want;
  const char* out = nullptr;
  pcl::manifold::ScaleParameters sp;
  for (int i = 2; i < c; ++i)
    if (!strcmp (v[i], "-truth")) {
      for (char* t = strtok (v[++i], ","); t; t = strtok (nullptr, ","))
        want.insert (atof (t));
    } else if (!strcmp (v[i], "-out"))
      out = v[++i];
    else if (!strcmp (v[i], "-scale")) {
      sp.from = atof (v[++i]);
      sp.to = atof (v[++i]);
    }
  Eigen::Matrix3Xd P (3, cl.size ());
  for (std::size_t i = 0; i < cl.size (); ++i)
    P.col (i) = cl[i].getVector3fMap ().cast<double> ();
  auto t0 = std::chrono::steady_clock::now ();
  pcl::manifold::StageLog log;
  pcl::manifold::DimensionParameters dp;
  std::shared_ptr<const pcl::manifold::ScaleDimensions> r;
  auto s = pcl::manifold::detectScales (P, {}, pcl::manifold::FLOAT_RESOLUTION, dp, sp, log, r);
  double dt = std::chrono::duration<double> (std::chrono::steady_clock::now () - t0).count ();
  if (s != pcl::manifold::Status::OK) {
    printf ("status %s\n", pcl::manifold::toString (s));
    return 2;
  }
  printf ("%-40s %7zu points %.2f s sensor %d curves %zu", v[1], cl.size (), dt,
          r->sensor_origin.has_value (), r->curves.size ());
  std::size_t n[4] = {}, tp = 0, fp = 0, fn = 0, vtp = 0, vfp = 0, vfn = 0, right = 0, solid_wall = 0,
              wall = 0, road = 0, road1 = 0;
  std::vector<int> lab (cl.size ()), cur (cl.size (), -1);
  for (std::size_t i = 0; i < cl.size (); ++i) {
    int q = r->samples->sample_of[i];
    int l = q < 0 ? 0 : r->manifold_dimension[q];
    lab[i] = l;
    if (q >= 0)
      cur[i] = r->curve[q];
    ++n[l];
    if (truth.empty ())
      continue;
    bool t = want.count (truth[i]);
    tp += t && l == 1;
    fp += !t && l == 1;
    fn += t && l != 1;
    bool ve =
      l == 1 && (cur[i] >= 0 ? r->curves[cur[i]].verticality > .9 : std::abs (r->tangents (2, q)) > .9);
    vtp += t && ve;
    vfp += !t && ve;
    vfn += t && !ve;
    right += truth[i] == l;
    if (truth[i] == 50) {
      ++wall;
      solid_wall += l == 3;
    }
    if (truth[i] == 40) {
      ++road;
      road1 += l == 1;
    }
  }
  auto F = [] (double a, double wrong, double d) {
    double p = a / std::max (1., a + wrong), q = a / std::max (1., a + d);
    return std::array<double, 3>{p, q, 2 * p * q / std::max (1e-9, p + q)};
  };
  auto A = F (tp, fp, fn), V = F (vtp, vfp, vfn);
  printf (" shares %.3f %.3f %.3f", n[1] / double (cl.size ()), n[2] / double (cl.size ()),
          n[3] / double (cl.size ()));
  if (!truth.empty ())
    printf (" | P %.3f R %.3f F1 %.3f | vertical P %.3f R %.3f F1 %.3f | right %.5f | road1 %.4f wall3 %.4f",
            A[0], A[1], A[2], V[0], V[1], V[2], right / double (cl.size ()),
            road1 / std::max (1., double (road)), solid_wall / std::max (1., double (wall)));
  printf ("\n");
  for (auto& st : log.stages ())
    printf ("  %s %.2f;", st.name.c_str (), st.seconds);
  printf ("\n");
  if (out) {
    std::ofstream f (out, std::ios::binary);
    for (std::size_t i = 0; i < cl.size (); ++i) {
      int q = r->samples->sample_of[i];
      float w[9] = {(float)lab[i],
                    (float)cur[i],
                    q < 0 ? 0 : r->scale[q],
                    q < 0 ? 0 : r->persistence[q],
                    q < 0 ? 0 : r->confidence[q],
                    q < 0 ? 0 : r->tangents (0, q),
                    q < 0 ? 0 : r->tangents (1, q),
                    q < 0 ? 0 : r->tangents (2, q),
                    0};
      f.write ((char*)w, sizeof w);
    }
  }
}
