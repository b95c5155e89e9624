// What VTK's own readers make of the files in VTK's formats.
#include "test_complex_io_formats.h"
#include "test_vtk_loader.h"

#include <pcl/conversions.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>

namespace {

using namespace complex_io_formats;

INSTANTIATE_TEST_SUITE_P (ComplexIoVtk, EveryFormat,
                          testing::Values (FormatCase{".vtk", false, loadByVtk},
                                           FormatCase{".vtk", true, loadByVtk},
                                           FormatCase{".vtu", false, loadByVtk},
                                           FormatCase{".vtu", true, loadByVtk}),
                          nameOf);

pcl::PCLPointCloud2
coloredCloud ()
{
  pcl::PointCloud<pcl::PointXYZRGBL> cloud (10, 1);
  for (std::size_t i = 0; i < cloud.size (); ++i) {
    cloud[i].getVector3fMap () = Eigen::Vector3f (0.1f, 1.f / 3, 1e-7f) * static_cast<float> (i + 1);
    cloud[i].rgba = 0xff102030u + static_cast<std::uint32_t> (i);
    cloud[i].label = 1000 + static_cast<std::uint32_t> (i);
  }
  pcl::PCLPointCloud2 blob;
  pcl::toPCLPointCloud2 (cloud, blob);
  return blob;
}

void
expectGrid (vtkUnstructuredGrid* grid)
{
  ASSERT_NE (nullptr, grid);
  ASSERT_EQ (10, grid->GetNumberOfPoints ());
  ASSERT_EQ (6, grid->GetNumberOfCells ());
  const int types[] = {VTK_LINE, VTK_LINE, VTK_TRIANGLE, VTK_TRIANGLE, VTK_TETRA, VTK_TETRA};
  for (vtkIdType c = 0; c < 6; ++c)
    EXPECT_EQ (types[c], grid->GetCellType (c));
  vtkNew<vtkIdList> cell;
  grid->GetCellPoints (5, cell);
  ASSERT_EQ (4, cell->GetNumberOfIds ());
  EXPECT_EQ (9, cell->GetId (3));
  EXPECT_EQ (0.1f * 3, static_cast<float> (grid->GetPoint (2)[0]));
  vtkDataArray* rgba = grid->GetPointData ()->GetArray ("rgba");
  ASSERT_NE (nullptr, rgba);
  EXPECT_EQ (VTK_UNSIGNED_CHAR, rgba->GetDataType ());
  ASSERT_EQ (4, rgba->GetNumberOfComponents ());
  EXPECT_EQ (0x10, rgba->GetComponent (4, 0));
  EXPECT_EQ (0x34, rgba->GetComponent (4, 2));
  vtkDataArray* label = grid->GetPointData ()->GetArray ("label");
  ASSERT_NE (nullptr, label);
  EXPECT_EQ (1009, label->GetComponent (9, 0));
}

TEST (ComplexIoVtk, VtkReadsOurPolygons)
{
  pcl::PolygonMesh mesh;
  mesh.cloud = coloredCloud ();
  mesh.polygons.resize (2);
  mesh.polygons[0].vertices = {0, 1, 2};
  mesh.polygons[1].vertices = {2, 3, 4, 5, 6};
  const TestFolder folder;
  std::string error;
  for (const bool ascii : {false, true}) {
    ASSERT_TRUE (pcl::manifold::savePolygonMesh (folder / "mesh.vtk", mesh, error, ascii)) << error;
    ASSERT_TRUE (pcl::manifold::savePolygonMesh (folder / "mesh.vtu", mesh, error, ascii)) << error;
    for (const auto& grid : {readGrid (folder / "mesh.vtk"), readGrid (folder / "mesh.vtu")}) {
      ASSERT_EQ (2, grid->GetNumberOfCells ());
      EXPECT_EQ (VTK_POLYGON, grid->GetCellType (1));
      vtkNew<vtkIdList> cell;
      grid->GetCellPoints (1, cell);
      ASSERT_EQ (5, cell->GetNumberOfIds ());
      EXPECT_EQ (6, cell->GetId (4));
    }
  }
}

TEST (ComplexIoVtk, VtkReadsOurs)
{
  const TestFolder folder;
  for (const bool ascii : {false, true}) {
    std::string error;
    ASSERT_TRUE (saveComplex (folder / "a.vtk", coloredCloud (), mixedComplex (), error, ascii)) << error;
    expectGrid (readGrid (folder / "a.vtk"));

    ASSERT_TRUE (saveComplex (folder / "a.vtu", coloredCloud (), mixedComplex (), error, ascii)) << error;
    expectGrid (readGrid (folder / "a.vtu"));
  }
}

TEST (ComplexIoVtk, VtkReadsOurEmptyFiles)
{
  const TestFolder folder;
  std::string error;
  for (const bool ascii : {false, true}) {
    ASSERT_TRUE (saveComplex (folder / "a.vtk", pcl::PCLPointCloud2 (), SimplicialComplex (), error, ascii));
    EXPECT_EQ (0, readGrid (folder / "a.vtk")->GetNumberOfPoints ());
    ASSERT_TRUE (saveComplex (folder / "a.vtu", pcl::PCLPointCloud2 (), SimplicialComplex (), error, ascii));
    EXPECT_EQ (0, readGrid (folder / "a.vtu")->GetNumberOfPoints ());
  }
}

TEST (ComplexIoVtk, KeepsWideIntegersAndNamesWithBlanks)
{
  const TestFolder folder;
  PCLPointCloud2 cloud = blankCloud ({{"x", PCLPointField::FLOAT32, 1},
                                      {"y", PCLPointField::FLOAT32, 1},
                                      {"z", PCLPointField::FLOAT32, 1},
                                      {"a <b> & \"c\" 100%", PCLPointField::UINT64, 1},
                                      {"d", PCLPointField::INT64, 2}},
                                     2);
  put<std::uint64_t> (cloud, cloud.fields[3].name, 1, 0, std::numeric_limits<std::uint64_t>::max ());
  put<std::int64_t> (cloud, "d", 1, 1, std::numeric_limits<std::int64_t>::min ());
  for (const char* const extension : {".vtk", ".vtu"})
    for (const bool ascii : {false, true}) {
      const std::string file = folder / (std::string ("a") + extension);
      std::string error;
      ASSERT_TRUE (saveComplex (file, cloud, SimplicialComplex (), error, ascii)) << error;
      PCLPointCloud2 read;
      SimplicialComplex complex;
      ASSERT_TRUE (loadByVtk (file, read, complex, error)) << error;
      for (const PCLPointField& field : cloud.fields)
        EXPECT_EQ (bytesOf (cloud, field.name), bytesOf (read, field.name)) << field.name;
    }
}

} // namespace
