# What the libraries link. The components of PCL are named once: the package configuration and the pkg-config
# files ask for the same. Its io is not among them: that one looks for VTK, OpenNI and MPI in every user's
# project.
set (PCL_MANIFOLD_PCL_COMPONENTS common search kdtree)

# Gives in VARIABLE the imported targets of components of PCL, whose names differ between its versions
# (pcl_common, PCL::common).
function (pcl_manifold_pcl_targets variable)
  foreach (component ${ARGN})
    if (TARGET PCL::${component})
      list (APPEND targets PCL::${component})
    else ()
      list (APPEND targets pcl_${component})
    endif ()
  endforeach ()
  set (${variable} "${targets}" PARENT_SCOPE)
endfunction ()

find_package (Boost 1.71 REQUIRED)
find_package (Eigen3 REQUIRED)
find_package (TBB REQUIRED)
find_package (PCL 1.12 REQUIRED COMPONENTS ${PCL_MANIFOLD_PCL_COMPONENTS})
pcl_manifold_pcl_targets (PCL_MANIFOLD_PCL_TARGETS ${PCL_MANIFOLD_PCL_COMPONENTS})

# FLANN's headers call lz4, which its own target does not link where lz4 is a library of its own.
set (PCL_MANIFOLD_FLANN_TARGETS FLANN::FLANN)
find_library (PCL_MANIFOLD_LZ4 lz4)
mark_as_advanced (PCL_MANIFOLD_LZ4)
if (PCL_MANIFOLD_LZ4)
  list (APPEND PCL_MANIFOLD_FLANN_TARGETS "${PCL_MANIFOLD_LZ4}")
endif ()

# The apps and the tests read and write files through PCL, whose io finds VTK, which looks for MPI with the C
# compiler.
if (PCL_MANIFOLD_BUILD_SAMPLES OR PCL_MANIFOLD_BUILD_TESTS OR PCL_MANIFOLD_BUILD_BENCHMARKS OR PCL_MANIFOLD_BUILD_FUZZERS)
  enable_language (C)
  find_package (PCL 1.12 REQUIRED COMPONENTS io)
  pcl_manifold_pcl_targets (PCL_MANIFOLD_PCL_IO_TARGET io)
endif ()

if (PCL_MANIFOLD_WITH_DELAUNAY)
  find_package (CGAL 5.0 REQUIRED)
  # FindTBB of older CGAL versions needs this helper before CGAL::TBB_support exists.
  include (CGAL_TBB_support OPTIONAL)
endif ()
