# Language level, default build type, warnings and sanitizers, for our own targets only: nothing here is
# exported, because a flag that changes alignment or instruction sets would break Eigen in a user's program.
if (NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set (CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif ()

set (CMAKE_CXX_STANDARD 17)
set (CMAKE_CXX_STANDARD_REQUIRED ON)
set (CMAKE_CXX_EXTENSIONS OFF)
set (CMAKE_CXX_VISIBILITY_PRESET hidden)
set (CMAKE_VISIBILITY_INLINES_HIDDEN ON)
set (CMAKE_POSITION_INDEPENDENT_CODE ON)
set (CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
set (CMAKE_LIBRARY_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/lib")
set (CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/lib")

find_program (PCL_MANIFOLD_CCACHE ccache)
if (PCL_MANIFOLD_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set (CMAKE_CXX_COMPILER_LAUNCHER "${PCL_MANIFOLD_CCACHE}")
endif ()

# Contracted to fused multiply-add, as compilers do by default for aarch64 and with -mfma, the same expression is
# rounded in two ways, and what is said to be exact (distances to boxes and to points, predicates) is not.
include (CheckCXXCompilerFlag)
check_cxx_compiler_flag (-ffp-contract=off PCL_MANIFOLD_HAS_FP_CONTRACT)

# Applies the project's arithmetic, warnings and sanitizers to one of its own targets.
function (pcl_manifold_configure target)
  if (PCL_MANIFOLD_HAS_FP_CONTRACT)
    target_compile_options (${target} PRIVATE -ffp-contract=off)
  endif ()
  target_compile_options (${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual)
  # Compiler notes about the ABI of earlier compilers say nothing about the code.
  target_compile_options (${target} PRIVATE -Wno-psabi)
  if (PCL_MANIFOLD_WERROR)
    target_compile_options (${target} PRIVATE -Werror)
  endif ()
  if (PCL_MANIFOLD_SANITIZE)
    target_compile_options (${target} PRIVATE -fsanitize=${PCL_MANIFOLD_SANITIZE} -fno-omit-frame-pointer
                            -fno-sanitize-recover=all)
    target_link_options (${target} PRIVATE -fsanitize=${PCL_MANIFOLD_SANITIZE})
  endif ()
endfunction ()
