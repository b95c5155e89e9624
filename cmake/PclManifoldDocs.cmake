# The target docs: the reference of the public headers, in docs/html of the build folder. A public name without
# documentation is an error.
find_package (Doxygen QUIET OPTIONAL_COMPONENTS dot)
if (DOXYGEN_FOUND)
  set (PCL_MANIFOLD_HAVE_DOT NO)
  if (DOXYGEN_DOT_FOUND)
    set (PCL_MANIFOLD_HAVE_DOT YES)
  endif ()
  configure_file ("${PROJECT_SOURCE_DIR}/cmake/Doxyfile.in" "${PROJECT_BINARY_DIR}/Doxyfile" @ONLY)
  add_custom_target (docs COMMAND Doxygen::doxygen "${PROJECT_BINARY_DIR}/Doxyfile"
    COMMENT "Reference of the public headers" VERBATIM)
endif ()
