#pragma once

/** \file
 * Visibility of the two libraries' symbols. Everything else in them is hidden. */

/** \def PCL_MANIFOLD_SYMBOL_EXPORT
 * \brief A symbol that the library which is being compiled gives.
 * \def PCL_MANIFOLD_SYMBOL_IMPORT
 * \brief A symbol of another library.
 * \def PCL_MANIFOLD_CORE_EXPORTS
 * \brief A symbol of pcl_manifold::core.
 * \def PCL_MANIFOLD_DELAUNAY_EXPORTS
 * \brief A symbol of pcl_manifold::delaunay. */

#if defined(_WIN32)
#define PCL_MANIFOLD_SYMBOL_EXPORT __declspec(dllexport)
#define PCL_MANIFOLD_SYMBOL_IMPORT __declspec(dllimport)
#else
#define PCL_MANIFOLD_SYMBOL_EXPORT __attribute__ ((visibility ("default")))
#define PCL_MANIFOLD_SYMBOL_IMPORT __attribute__ ((visibility ("default")))
#endif

#ifdef pcl_manifold_core_EXPORTS
#define PCL_MANIFOLD_CORE_EXPORTS PCL_MANIFOLD_SYMBOL_EXPORT
#else
#define PCL_MANIFOLD_CORE_EXPORTS PCL_MANIFOLD_SYMBOL_IMPORT
#endif

#ifdef pcl_manifold_delaunay_EXPORTS
#define PCL_MANIFOLD_DELAUNAY_EXPORTS PCL_MANIFOLD_SYMBOL_EXPORT
#else
#define PCL_MANIFOLD_DELAUNAY_EXPORTS PCL_MANIFOLD_SYMBOL_IMPORT
#endif
