#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/PolygonMesh.h>
#include <pcl/manifold/export.h>
#include <pcl/manifold/simplicial_complex.h>

#include <string>

/** \file
 * Files of complexes: PLY, OBJ, legacy VTK and VTU, told apart by their extensions in lower or upper case.
 * All are written, PLY and OBJ are read as well.
 *
 * | | .ply | .obj | .vtk, .vtu |
 * |---|---|---|---|
 * | points | all fields | x, y, z | all fields |
 * | edges | element `edge` | `l` | lines |
 * | triangles | element `face` | `f` | triangles |
 * | tetrahedra | their boundary, in `face` | their boundary, `f` | tetrahedra |
 *
 * Numbers are written such that reading them gives the same bits again. Fields of the cloud keep their names,
 * types and counts but for these: a field `rgb` or `rgba` that packs a colour into 4 bytes is written as
 * `red`, `green`, `blue` (and `alpha` for `rgba`) in PLY, where it is packed again when it is read, the
 * unused fourth byte of `rgb` being 255 then, and as an array of 3 or 4 bytes in VTK's formats. BOOL comes
 * back as UINT8. The rows and columns of an organised cloud are kept in PLY, as PCL's own writer does it. PLY
 * has no 64-bit integers: they are written as `double`, and a value that no double can hold is an error.
 * Padding (fields named `_`) is not written. A field of several values is a list property in PLY, as PCL
 * writes it. */

namespace pcl {
namespace manifold {

/** \brief Can this file be written, as far as can be told now? For asking before a long computation: checks
 * the extension, that the folder exists and can be written to, and that the file, if there, is a regular one
 * that may be written.
 * \param[in] file the file's name
 * \param[out] error one line, without the file's name, when the answer is no
 * \return true if saveComplex () has a chance
 * \ingroup manifold */
PCL_MANIFOLD_CORE_EXPORTS bool canSaveComplex (const std::string& file, std::string& error);

/** \brief Write a complex and its cloud. An existing file is replaced once the new one is complete, and stays
 * as it is when anything fails; the new one has its mode. One that may not be written is not replaced.
 * \param[in] file the extension says which format
 * \param[in] cloud the points; for OBJ and VTK's formats with fields x, y, z
 * \param[in] complex must be valid for the cloud, see isValid ()
 * \param[out] error one line, without the file's name, on failure
 * \param[in] ascii write text where the format has binary numbers otherwise (default: binary)
 * \return false on failure: unknown extension, indices out of range, a full disk, ...
 * \ingroup manifold */
PCL_MANIFOLD_CORE_EXPORTS bool saveComplex (const std::string& file, const pcl::PCLPointCloud2& cloud,
                                            const SimplicialComplex& complex, std::string& error,
                                            bool ascii = false);

/** \brief Write a mesh of polygons of any sizes, as they are: polygons of two vertices as edges, larger ones
 * as faces of PLY and OBJ and as cells of VTK's formats. Otherwise as saveComplex (); loadComplex () reads
 * the file with larger polygons cut into triangles.
 * \param[in] file the extension says which format
 * \param[in] mesh its polygons must have two vertices or more, all of them points of its cloud
 * \param[out] error one line, without the file's name, on failure
 * \param[in] ascii write text where the format has binary numbers otherwise (default: binary)
 * \return false on failure, a polygon with too few or wrong vertices among others
 * \ingroup manifold */
PCL_MANIFOLD_CORE_EXPORTS bool savePolygonMesh (const std::string& file, const pcl::PolygonMesh& mesh,
                                                std::string& error, bool ascii = false);

/** \brief Read a complex and its cloud, from files of saveComplex () and of other programs.
 *
 * PLY: ASCII and binary of either byte order; elements and properties that mean nothing here are skipped. A
 * list property of the vertices becomes a field of several values if all lists are of one length, and is
 * skipped otherwise. OBJ: `v`, `vn`, `l` and `f`, with or without texture and normal indices, counted from
 * the start or, negative, from the end; other statements are skipped. Coordinates become FLOAT64 if one of
 * them is written with more than nine digits, FLOAT32 otherwise. Colours behind the coordinates become a
 * field `rgb`, normals `normal_x`, `normal_y` and `normal_z`, where every point has one.
 *
 * Polygons of more than three vertices are cut into triangles from their first vertex on, polylines into
 * edges; polygons of two vertices are taken for edges. Simplices with a repeated vertex are left out. The
 * direction of faces and tetrahedra is that of the file. Points may have coordinates that are not finite.
 * \param[in] file the extension says which format: .ply or .obj
 * \param[out] cloud the points, in the order of the file; empty on failure
 * \param[out] complex indices are valid for the cloud; empty on failure
 * \param[out] error on failure one line with the line or the byte of the file, without the file's name
 * \return false on failure
 * \ingroup manifold */
PCL_MANIFOLD_CORE_EXPORTS bool loadComplex (const std::string& file, pcl::PCLPointCloud2& cloud,
                                            SimplicialComplex& complex, std::string& error);

} // namespace manifold
} // namespace pcl
