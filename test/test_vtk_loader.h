#pragma once

#include "files/cloud_fields.h"

#include <pcl/manifold/simplicial_complex.h>

#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

inline vtkSmartPointer<vtkUnstructuredGrid>
readGrid (const std::string& file)
{
  if (file.substr (file.size () - 4) == ".vtk") {
    const vtkNew<vtkUnstructuredGridReader> legacy;
    legacy->SetFileName (file.c_str ());
    legacy->Update ();
    return legacy->GetOutput ();
  }
  const vtkNew<vtkXMLUnstructuredGridReader> xml;
  xml->SetFileName (file.c_str ());
  xml->Update ();
  return xml->GetOutput ();
}

inline pcl::manifold::CloudColumn
columnOf (vtkDataArray& array, const std::string& name, int component = -1)
{
  static const std::map<int, std::uint8_t> types = {{VTK_SIGNED_CHAR, pcl::PCLPointField::INT8},
                                                    {VTK_CHAR, pcl::PCLPointField::INT8},
                                                    {VTK_UNSIGNED_CHAR, pcl::PCLPointField::UINT8},
                                                    {VTK_SHORT, pcl::PCLPointField::INT16},
                                                    {VTK_UNSIGNED_SHORT, pcl::PCLPointField::UINT16},
                                                    {VTK_INT, pcl::PCLPointField::INT32},
                                                    {VTK_UNSIGNED_INT, pcl::PCLPointField::UINT32},
                                                    {VTK_LONG, pcl::PCLPointField::INT64},
                                                    {VTK_LONG_LONG, pcl::PCLPointField::INT64},
                                                    {VTK_UNSIGNED_LONG, pcl::PCLPointField::UINT64},
                                                    {VTK_UNSIGNED_LONG_LONG, pcl::PCLPointField::UINT64},
                                                    {VTK_FLOAT, pcl::PCLPointField::FLOAT32},
                                                    {VTK_DOUBLE, pcl::PCLPointField::FLOAT64}};
  const auto components = static_cast<std::size_t> (array.GetNumberOfComponents ());
  const auto tuples = static_cast<std::size_t> (array.GetNumberOfTuples ());
  pcl::manifold::CloudColumn column{
    name, types.at (array.GetDataType ()), component < 0 ? components : 1, {}};
  const std::size_t size = pcl::manifold::sizeOf (column.type);
  const auto* from = static_cast<const std::uint8_t*> (array.GetVoidPointer (0));
  for (std::size_t i = 0; i < tuples; ++i) {
    const std::uint8_t* tuple =
      from + (i * components + static_cast<std::size_t> (std::max (component, 0))) * size;
    column.data.insert (column.data.end (), tuple, tuple + column.count * size);
  }
  return column;
}

/** \brief What VTK reads, as a cloud and a complex; larger polygons are cut into triangles from their first vertex on. */
inline bool
loadByVtk (const std::string& file, pcl::PCLPointCloud2& cloud, pcl::SimplicialComplex& complex, std::string&)
{
  const auto grid = readGrid (file);
  const auto points = static_cast<std::size_t> (grid->GetNumberOfPoints ());
  std::vector<pcl::manifold::CloudColumn> columns;
  for (int axis = 0; axis < 3 && points > 0; ++axis)
    columns.push_back (columnOf (*grid->GetPoints ()->GetData (), std::string (1, "xyz"[axis]), axis));
  for (int i = 0; i < grid->GetPointData ()->GetNumberOfArrays (); ++i) {
    vtkDataArray* const array = grid->GetPointData ()->GetArray (i);
    columns.push_back (columnOf (*array, array->GetName ()));
  }
  cloud = pcl::manifold::makeCloud (columns, points);
  complex = pcl::SimplicialComplex ();
  const vtkNew<vtkIdList> cell;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells (); ++c) {
    grid->GetCellPoints (c, cell);
    const auto vertex = [&] (vtkIdType i) { return static_cast<pcl::index_t> (cell->GetId (i)); };
    if (grid->GetCellType (c) == VTK_LINE)
      complex.edges.push_back ({vertex (0), vertex (1)});
    else if (grid->GetCellType (c) == VTK_TRIANGLE || grid->GetCellType (c) == VTK_POLYGON)
      for (vtkIdType i = 2; i < cell->GetNumberOfIds (); ++i)
        complex.triangles.push_back ({vertex (0), vertex (i - 1), vertex (i)});
    else if (grid->GetCellType (c) == VTK_TETRA)
      complex.tetrahedra.push_back ({vertex (0), vertex (1), vertex (2), vertex (3)});
    else
      return false;
  }
  return true;
}
