# Installs the libraries, their headers, the apps, the CMake package and the pkg-config files. Four install
# components, one Debian package each: core, delaunay, dev, tools. Everything is found relative to itself, so
# that an installed tree may be moved.
include (CMakePackageConfigHelpers)

set (PCL_MANIFOLD_CMAKE_DIR "${CMAKE_INSTALL_LIBDIR}/cmake/pcl_manifold")
set (PCL_MANIFOLD_PC_DIR "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
set (PCL_MANIFOLD_DOC_DIR "${CMAKE_INSTALL_DATADIR}/doc/pcl_manifold")

# Installs a library with its own export set, so that each package is whole without the other.
function (pcl_manifold_install_library name)
  set (target pcl_manifold_${name})
  set_target_properties (${target} PROPERTIES INSTALL_RPATH "$ORIGIN")
  install (TARGETS ${target} EXPORT ${target}Targets
    LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT ${name} NAMELINK_COMPONENT dev
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT dev
    RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT ${name})
  install (EXPORT ${target}Targets NAMESPACE pcl_manifold::
    DESTINATION "${PCL_MANIFOLD_CMAKE_DIR}" COMPONENT dev)
  configure_file ("${PROJECT_SOURCE_DIR}/cmake/${target}.pc.in" "${PROJECT_BINARY_DIR}/${target}.pc" @ONLY)
  install (FILES "${PROJECT_BINARY_DIR}/${target}.pc" DESTINATION "${PCL_MANIFOLD_PC_DIR}" COMPONENT dev)
endfunction ()

# Every executable in a folder and below it is an app of the project. Installs them so that they find the
# libraries.
function (pcl_manifold_install_apps folder)
  file (RELATIVE_PATH lib_from_bin "${CMAKE_INSTALL_FULL_BINDIR}" "${CMAKE_INSTALL_FULL_LIBDIR}")
  get_property (targets DIRECTORY "${folder}" PROPERTY BUILDSYSTEM_TARGETS)
  foreach (target ${targets})
    get_target_property (type ${target} TYPE)
    if (type STREQUAL "EXECUTABLE")
      set_target_properties (${target} PROPERTIES INSTALL_RPATH "$ORIGIN/${lib_from_bin}")
      install (TARGETS ${target} RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT tools)
    endif ()
  endforeach ()
  get_property (folders_below DIRECTORY "${folder}" PROPERTY SUBDIRECTORIES)
  foreach (folder_below ${folders_below})
    pcl_manifold_install_apps ("${folder_below}")
  endforeach ()
endfunction ()

file (RELATIVE_PATH PCL_MANIFOLD_PC_PREFIX "/${PCL_MANIFOLD_PC_DIR}" "/")
string (REGEX REPLACE "/$" "" PCL_MANIFOLD_PC_PREFIX "${PCL_MANIFOLD_PC_PREFIX}")
list (TRANSFORM PCL_MANIFOLD_PCL_COMPONENTS PREPEND "pcl_" OUTPUT_VARIABLE PCL_MANIFOLD_PC_REQUIRES)
list (APPEND PCL_MANIFOLD_PC_REQUIRES eigen3)
list (JOIN PCL_MANIFOLD_PC_REQUIRES " " PCL_MANIFOLD_PC_REQUIRES)

pcl_manifold_install_library (core)
install (FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${PCL_MANIFOLD_DOC_DIR}" COMPONENT core)
if (TARGET pcl_manifold_delaunay)
  pcl_manifold_install_library (delaunay)
  install (FILES "${PROJECT_SOURCE_DIR}/LICENSE.GPL" DESTINATION "${PCL_MANIFOLD_DOC_DIR}" COMPONENT delaunay)
endif ()

# A header of the Delaunay family would only promise what the core alone cannot link.
set (headers_of_delaunay "")
if (NOT TARGET pcl_manifold_delaunay)
  set (names cocone_shape complex_reconstruction delaunay_complex delaunay_computation detect_dimensions
             dimension_detection fixed_point_complex fixed_point_reconstruction mesh_pieces reconstruct_fixed_point
             reconstruct_shape sample_dimensions scale_dimensions)
  list (JOIN names "|" names)
  set (headers_of_delaunay REGEX "/(${names})\\.(h|hpp)$" EXCLUDE)
endif ()
install (DIRECTORY "${PROJECT_SOURCE_DIR}/include/" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT dev
  PATTERN "*.dox" EXCLUDE PATTERN "pages" EXCLUDE ${headers_of_delaunay})

list (JOIN PCL_MANIFOLD_PCL_COMPONENTS " " PCL_MANIFOLD_PCL_COMPONENTS_SPACED)
configure_package_config_file (
  "${PROJECT_SOURCE_DIR}/cmake/pcl_manifoldConfig.cmake.in" "${PROJECT_BINARY_DIR}/pcl_manifoldConfig.cmake"
  INSTALL_DESTINATION "${PCL_MANIFOLD_CMAKE_DIR}" NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file ("${PROJECT_BINARY_DIR}/pcl_manifoldConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install (FILES "${PROJECT_BINARY_DIR}/pcl_manifoldConfig.cmake"
  "${PROJECT_BINARY_DIR}/pcl_manifoldConfigVersion.cmake"
  DESTINATION "${PCL_MANIFOLD_CMAKE_DIR}" COMPONENT dev)

if (PCL_MANIFOLD_BUILD_SAMPLES)
  pcl_manifold_install_apps ("${PROJECT_SOURCE_DIR}/samples")
endif ()

include (PclManifoldPackage)
