#include "test_apps_folder.h"

#include <pcl/manifold/complex_io.h>

#include <pcl/conversions.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridReader.h>
#include <vtkUnstructuredGridWriter.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <filesystem>
#include <random>

namespace {

using pcl::SimplicialComplex;
using pcl::manifold::loadComplex;
using pcl::manifold::saveComplex;

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

SimplicialComplex
mixedComplex ()
{
  SimplicialComplex complex;
  complex.edges = {{0, 1}, {1, 2}};
  complex.triangles = {{2, 3, 4}, {4, 3, 5}};
  complex.tetrahedra = {{5, 6, 7, 8}, {6, 7, 8, 9}};
  return complex;
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
    vtkNew<vtkUnstructuredGridReader> legacy;
    legacy->SetFileName ((folder / "mesh.vtk").c_str ());
    legacy->Update ();
    vtkNew<vtkXMLUnstructuredGridReader> xml;
    xml->SetFileName ((folder / "mesh.vtu").c_str ());
    xml->Update ();
    for (vtkUnstructuredGrid* grid : {legacy->GetOutput (), xml->GetOutput ()}) {
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
    vtkNew<vtkUnstructuredGridReader> legacy;
    legacy->SetFileName ((folder / "a.vtk").c_str ());
    legacy->Update ();
    expectGrid (legacy->GetOutput ());

    ASSERT_TRUE (saveComplex (folder / "a.vtu", coloredCloud (), mixedComplex (), error, ascii)) << error;
    vtkNew<vtkXMLUnstructuredGridReader> xml;
    xml->SetFileName ((folder / "a.vtu").c_str ());
    xml->Update ();
    expectGrid (xml->GetOutput ());
  }
}

TEST (ComplexIoVtk, VtkReadsOurEmptyFiles)
{
  const TestFolder folder;
  std::string error;
  for (const bool ascii : {false, true}) {
    ASSERT_TRUE (saveComplex (folder / "a.vtk", pcl::PCLPointCloud2 (), SimplicialComplex (), error, ascii));
    vtkNew<vtkUnstructuredGridReader> legacy;
    legacy->SetFileName ((folder / "a.vtk").c_str ());
    legacy->Update ();
    EXPECT_EQ (0, legacy->GetOutput ()->GetNumberOfPoints ());
    ASSERT_TRUE (saveComplex (folder / "a.vtu", pcl::PCLPointCloud2 (), SimplicialComplex (), error, ascii));
    vtkNew<vtkXMLUnstructuredGridReader> xml;
    xml->SetFileName ((folder / "a.vtu").c_str ());
    xml->Update ();
    EXPECT_EQ (0, xml->GetOutput ()->GetNumberOfPoints ());
  }
}

/** \brief A grid as VTK itself reads our file. */
vtkSmartPointer<vtkUnstructuredGrid>
gridOf (const TestFolder& folder)
{
  std::string error;
  EXPECT_TRUE (saveComplex (folder / "ours.vtu", coloredCloud (), mixedComplex (), error)) << error;
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName ((folder / "ours.vtu").c_str ());
  reader->Update ();
  return reader->GetOutput ();
}

void
expectOurs (const std::string& file)
{
  pcl::PCLPointCloud2 cloud;
  SimplicialComplex complex;
  std::string error;
  ASSERT_TRUE (loadComplex (file, cloud, complex, error)) << error;
  pcl::PointCloud<pcl::PointXYZRGBL> expected, points;
  pcl::fromPCLPointCloud2 (coloredCloud (), expected);
  pcl::fromPCLPointCloud2 (cloud, points);
  ASSERT_EQ (expected.size (), points.size ());
  for (std::size_t i = 0; i < points.size (); ++i) {
    // VTK's text has fewer digits than the numbers.
    EXPECT_TRUE (expected[i].getVector3fMap ().isApprox (points[i].getVector3fMap (), 1e-5f));
    EXPECT_EQ (expected[i].rgba, points[i].rgba);
    EXPECT_EQ (expected[i].label, points[i].label);
  }
  EXPECT_EQ (mixedComplex ().edges, complex.edges);
  EXPECT_EQ (mixedComplex ().triangles, complex.triangles);
  EXPECT_EQ (mixedComplex ().tetrahedra, complex.tetrahedra);
}

TEST (ComplexIoVtk, OursReadsVtksLegacyFiles)
{
  const TestFolder folder;
  const auto grid = gridOf (folder);
  for (const int version :
       {vtkDataWriter::VTK_LEGACY_READER_VERSION_4_2, vtkDataWriter::VTK_LEGACY_READER_VERSION_5_1})
    for (const int encoding : {VTK_ASCII, VTK_BINARY}) {
      vtkNew<vtkUnstructuredGridWriter> writer;
      writer->SetInputData (grid);
      writer->SetFileVersion (version);
      writer->SetFileType (encoding);
      writer->SetFileName ((folder / "a.vtk").c_str ());
      ASSERT_EQ (1, writer->Write ());
      SCOPED_TRACE (std::to_string (version) + " " + std::to_string (encoding));
      expectOurs (folder / "a.vtk");
    }
}

TEST (ComplexIoVtk, OursReadsVtksXmlFiles)
{
  const TestFolder folder;
  const auto grid = gridOf (folder);
  const auto expectReadable = [&] (const std::string& what, const auto& configure) {
    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    writer->SetInputData (grid);
    writer->SetFileName ((folder / "a.vtu").c_str ());
    configure (*writer);
    ASSERT_EQ (1, writer->Write ());
    SCOPED_TRACE (what);
    expectOurs (folder / "a.vtu");
  };
  for (const int mode : {vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended})
    for (const int compressor : {vtkXMLWriter::NONE, vtkXMLWriter::ZLIB})
      for (const int header : {vtkXMLWriter::UInt32, vtkXMLWriter::UInt64})
        for (const int order : {vtkXMLWriter::LittleEndian, vtkXMLWriter::BigEndian})
          for (const bool base64 : {false, true})
            expectReadable ("mode " + std::to_string (mode) + " compressor " + std::to_string (compressor) +
                              " header " + std::to_string (header) + " order " + std::to_string (order) +
                              (base64 ? " base64" : " raw"),
                            [&] (vtkXMLUnstructuredGridWriter& writer) {
                              writer.SetDataMode (mode);
                              writer.SetCompressorType (compressor);
                              writer.SetBlockSize (64); // several blocks an array
                              writer.SetHeaderType (header);
                              writer.SetByteOrder (order);
                              writer.SetEncodeAppendedData (base64);
                            });
}

TEST (ComplexIoVtk, CorruptCompressedFiles)
{
  const TestFolder folder;
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData (gridOf (folder));
  writer->SetFileName ((folder / "a.vtu").c_str ());
  writer->SetBlockSize (64);
  std::mt19937_64 random (13);
  for (const bool base64 : {false, true}) {
    writer->SetEncodeAppendedData (base64);
    ASSERT_EQ (1, writer->Write ());
    const std::string good = folder.read ("a.vtu");
    const std::size_t data = good.find ("<AppendedData");
    for (int round = 0; round < 1000; ++round) {
      std::string bad = good;
      // Every other time within the arrays.
      const std::size_t begin = round % 2 == 0 ? 0 : data;
      for (int i = 0; i < 2; ++i)
        bad[begin + random () % (bad.size () - begin)] = static_cast<char> (random ());
      std::filesystem::remove (folder / "b.vtu");
      pcl::PCLPointCloud2 cloud;
      SimplicialComplex complex;
      std::string error;
      if (loadComplex (folder.write ("b.vtu", bad), cloud, complex, error))
        EXPECT_TRUE (pcl::manifold::isValid (complex, cloud.width));
      else
        EXPECT_TRUE (complex.empty () && cloud.data.empty () && !error.empty ());
    }
  }
}

} // namespace
