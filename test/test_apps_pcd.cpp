// PCD files: every field of every encoding, every kind of bad header, truncated and corrupt data.
#include "app_files.h"
#include "test_apps_clouds.h"

#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <utility>
#include <vector>

using namespace pcl::manifold;
using namespace pcl::manifold::apps;

namespace {

/** \brief A cloud with fields of several types, one of them with two values a point. */
pcl::PCLPointCloud2
someCloud (std::uint32_t points)
{
  pcl::PCLPointCloud2 cloud;
  cloud.width = points;
  cloud.height = 1;
  for (const char* const axis : {"x", "y", "z"})
    appendField (cloud, axis, pcl::PCLPointField::FLOAT32);
  appendField (cloud, "label", pcl::PCLPointField::UINT32);
  appendField (cloud, "pair", pcl::PCLPointField::INT16, 2);
  appendField (cloud, "flag", pcl::PCLPointField::UINT8);
  appendField (cloud, "time", pcl::PCLPointField::FLOAT64);
  allocatePoints (cloud);
  std::mt19937 random (7);
  for (std::size_t i = 0; i < points; ++i) {
    const float xyz[3] = {static_cast<float> (random () % 1000) / 7,
                          static_cast<float> (random () % 1000) / 7, 1};
    std::uint8_t* to = &cloud.data[i * cloud.point_step];
    std::memcpy (to, xyz, sizeof (xyz));
    for (std::size_t byte = sizeof (xyz); byte < cloud.point_step - sizeof (double); ++byte)
      to[byte] = static_cast<std::uint8_t> (random ());
    const double time = static_cast<double> (random ()) / 3;
    std::memcpy (to + cloud.point_step - sizeof (double), &time, sizeof (time));
  }
  return cloud;
}

const std::string ascii_header = "# comment\nVERSION 0.7\nFIELDS x y z label\nSIZE 4 4 4 4\nTYPE F F F U\n"
                                 "COUNT 1 1 1 1\nWIDTH 2\nHEIGHT 1\nVIEWPOINT 1 2 3 1 0 0 0\nPOINTS 2\n";

} // namespace

TEST (Pcd, KeepsEveryFieldOfEveryEncoding)
{
  const TestFolder folder;
  const pcl::PCLPointCloud2 cloud = someCloud (500);
  pcl::PCDWriter ().writeBinary (folder / "binary.pcd", cloud);
  pcl::PCDWriter ().writeBinaryCompressed (folder / "compressed.pcd", cloud);
  pcl::PCDWriter ().writeASCII (folder / "ascii.pcd", cloud, Eigen::Vector4f::Zero (),
                                Eigen::Quaternionf::Identity (), 17);
  writePcd (folder / "own.pcd", cloud);
  for (const char* const name : {"binary.pcd", "compressed.pcd", "ascii.pcd", "own.pcd"}) {
    SCOPED_TRACE (name);
    expectSameFields (cloud, readCloud (folder / name).cloud);
  }
}

TEST (Pcd, IsReadAsByPcl)
{
  const TestFolder folder;
  pcl::PointCloud<pcl::PointNormal> points (4, 3); // organised, with padding between the fields
  for (std::size_t i = 0; i < points.size (); ++i) {
    points[i].x = static_cast<float> (i);
    points[i].normal_y = -static_cast<float> (i);
    points[i].curvature = static_cast<float> (i * 1000);
  }
  points[5].x = std::numeric_limits<float>::quiet_NaN ();
  points.is_dense = false;
  pcl::PCLPointCloud2 padded;
  pcl::toPCLPointCloud2 (points, padded);
  pcl::PCDWriter ().writeBinary (folder / "padded.pcd", padded);
  writePcd (folder / "packed.pcd", padded);
  for (const char* const name : {"padded.pcd", "packed.pcd"}) {
    const InputCloud input = readCloud (folder / name);
    EXPECT_EQ (findField (input.cloud, "_"), nullptr);
    EXPECT_EQ (input.cloud.width, 4u);
    EXPECT_EQ (input.cloud.height, 3u);
    pcl::PointCloud<pcl::PointNormal> again;
    pcl::fromPCLPointCloud2 (input.cloud, again);
    ASSERT_EQ (again.size (), points.size ());
    for (std::size_t i = 0; i < points.size (); ++i) {
      EXPECT_EQ (std::isnan (again[i].x), i == 5);
      EXPECT_EQ (again[i].normal_y, points[i].normal_y);
      EXPECT_EQ (again[i].curvature, points[i].curvature);
    }
  }
}

TEST (Pcd, ReadsTextWithNanAndViewpoint)
{
  const TestFolder folder;
  const InputCloud input =
    readCloud (folder.write ("a.pcd", ascii_header + "DATA ascii\n0.1 nan 3 5\r\n\n4 5 6e-1 4294967295"));
  EXPECT_EQ (valueAt (input.cloud, "x", 0), static_cast<double> (0.1f));
  EXPECT_TRUE (std::isnan (valueAt (input.cloud, "y", 0)));
  EXPECT_EQ (valueAt (input.cloud, "label", 1), 4294967295.0);
  EXPECT_EQ (input.viewpoint, (std::array<double, 7>{1, 2, 3, 1, 0, 0, 0}));
  EXPECT_EQ (input.origin, (std::array<double, 3>{}));
  EXPECT_TRUE (input.notes.empty ());
}

TEST (Pcd, ReadsWhatOldWindowsRuntimesWriteForNan)
{
  const TestFolder folder;
  const InputCloud input =
    readCloud (folder.write ("a.pcd", ascii_header + "DATA ascii\n1.#QNAN -1.#IND 1.#INF 5\n4 5 6 7\n"));
  EXPECT_TRUE (std::isnan (valueAt (input.cloud, "x", 0)));
  EXPECT_TRUE (std::isnan (valueAt (input.cloud, "y", 0)));
  EXPECT_EQ (valueAt (input.cloud, "z", 0), HUGE_VAL);
  EXPECT_EQ (valueAt (input.cloud, "z", 1), 6);
  EXPECT_TRUE (
    contains (readingError (folder.write ("b.pcd", ascii_header + "DATA ascii\n1 2 3 1.#QNAN\n4 5 6 7\n")),
              "line 12: '1.#QNAN' is no value for field 'label'"));
}

TEST (Pcd, KeepsTheSensorAndTheLayoutOfAnOrganisedCloud)
{
  const TestFolder folder;
  pcl::PCLPointCloud2 cloud = someCloud (1200);
  cloud.width = 40;
  cloud.height = 30;
  cloud.row_step = cloud.point_step * cloud.width;
  const Viewpoint viewpoint{12345.678, -234.56789, 381.5272, 0.70710678118654757, 0, 0.1 + 0.2, 1e-300};
  writePcd (folder / "a.pcd", cloud, viewpoint);
  EXPECT_TRUE (contains (folder.read ("a.pcd"), "WIDTH 40\nHEIGHT 30\nVIEWPOINT 12345.678 -234.56789 "));
  const InputCloud again = readCloud (folder / "a.pcd");
  EXPECT_EQ (again.viewpoint, viewpoint);
  expectSameFields (cloud, again.cloud);
  Eigen::Vector4f origin;
  Eigen::Quaternionf orientation;
  pcl::PCLPointCloud2 by_pcl;
  ASSERT_EQ (pcl::io::loadPCDFile (folder / "a.pcd", by_pcl, origin, orientation), 0);
  expectSameFields (cloud, by_pcl);
  EXPECT_EQ (origin[0], 12345.678f);
  EXPECT_EQ (orientation.w (), 0.70710678f);
}

TEST (Pcd, SaysWhatIsWrongWithAHeader)
{
  const TestFolder folder;
  const auto with = [] (const std::string& old, const std::string& now) {
    std::string text = ascii_header + "DATA ascii\n1 2 3 4\n5 6 7 8\n";
    return text.replace (text.find (old), old.size (), now);
  };
  const std::vector<std::pair<std::string, std::string>> cases = {
    {with ("SIZE 4 4 4 4", "SIZE 4 4 4"), "line 4: SIZE has 3 entries for 4 fields"},
    {with ("SIZE 4 4 4 4", "SIZE 4 4 4 -4"), "line 4: SIZE holds '-4', no number from 1 to 1048576"},
    {with ("SIZE 4 4 4 4", "SIZE 4 4 4 3"), "the header gives field 'label' the unknown type U of 3 bytes"},
    {with ("TYPE F F F U", "TYPE F F F X"), "line 5: TYPE holds 'X', none of I, U, F, B"},
    {with ("COUNT 1 1 1 1", "COUNT 1 1 1 0"), "line 6: COUNT holds '0', no number from 1 to 1048576"},
    {with ("COUNT 1 1 1 1", "COUNT 3 1 1 1"), "only 16 follow it"},
    {with ("WIDTH 2", "WIDTH 3"), "the header says WIDTH 3 and HEIGHT 1, but POINTS 2"},
    {with ("WIDTH 2", "WIDTH two"), "line 7: WIDTH is not followed by one whole number"},
    {with ("POINTS 2", "POINTS 99999999999"), "line 10: POINTS is 99999999999, more than PCL can hold"},
    {with ("WIDTH 2\nHEIGHT 1", "WIDTH 2000000000\nHEIGHT 2000000000"), "but POINTS 2"},
    {with ("WIDTH 2\nHEIGHT 1\nVIEWPOINT 1 2 3 1 0 0 0\nPOINTS 2", "WIDTH 2000000000\nHEIGHT 2000000000"),
     "the header says 4000000000000000000 points, more than PCL can hold"},
    {with ("WIDTH 2\nHEIGHT 1\nVIEWPOINT 1 2 3 1 0 0 0\nPOINTS 2", "POINTS 2000000000"),
     "truncated or corrupt"},
    {with ("WIDTH 2\nHEIGHT 1\nVIEWPOINT 1 2 3 1 0 0 0\nPOINTS 2", "POINTS 0"), "holds no point"},
    {with ("VIEWPOINT 1 2 3", "VIEWPOINT 1 2"), "line 9: VIEWPOINT has 6 entries instead of 7"},
    {with ("DATA ascii", "DATA"), "line 11: DATA is none of ascii, binary, binary_compressed"},
    {with ("DATA ascii", "DAtA ascii"), "line 11: not a line of a PCD header: 'DAtA'"},
    {with ("FIELDS x y z label", "FIELDS x y w label"), "has no field 'z'"},
    {with ("1 2 3 4", "11 12 3"), "line 12: 3 numbers instead of 4"},
    {with ("1 2 3 4", "1 2 3 4.5"), "line 12: '4.5' is no value for field 'label'"},
    {with ("5 6 7 8\n", ""), "truncated or corrupt"},
    {with ("5 6 7 8\n", "          "), "truncated: the file ends after line 13, with 1 of 2 lines of points"},
    {"\x01\x02\x03\nFIELDS x", "line 1: not a line of a PCD header: '"},
    {"", "the file is empty"},
    {"FIELDS x y z\n", "the header has no DATA line"},
    {"SIZE 4\n", "line 1: SIZE comes before FIELDS"},
    {"POINTS 1\nDATA ascii\n1", "the header has no FIELDS line"},
    {"POINTS 1\nFIELDS x y z\nTYPE F F F\nDATA ascii\n1 2 3", "the header has no SIZE line"},
    {"FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nDATA ascii\n1 2 3", "the header has neither WIDTH nor POINTS"},
  };
  for (const auto& [text, message] : cases) {
    const std::string file = folder.write ("bad.pcd", text);
    const std::string error = readingError (file);
    EXPECT_TRUE (contains (error, message)) << error << "\nshould be: " << message;
    EXPECT_TRUE (contains (error, file + ": ")) << error;
  }
}

TEST (Pcd, SaysWhatIsWrongWithCompressedData)
{
  const TestFolder folder;
  const pcl::PCLPointCloud2 cloud = someCloud (500);
  pcl::PCDWriter ().writeBinaryCompressed (folder / "good.pcd", cloud);
  const std::string good = folder.read ("good.pcd");
  const std::size_t words = good.find ("DATA binary_compressed\n") + 23;
  const auto with = [&] (std::size_t offset, std::uint32_t word) {
    std::string bad = good;
    std::memcpy (&bad[words + offset], &word, sizeof (word));
    return bad;
  };
  std::uint32_t packed_size = 0;
  std::memcpy (&packed_size, &good[words], sizeof (packed_size));
  EXPECT_TRUE (contains (readingError (folder.write ("a.pcd", with (0, 0xffffffff))),
                         "should have 4294967295 bytes, but only"));
  EXPECT_TRUE (contains (readingError (folder.write ("a.pcd", with (4, 0xffffffff))),
                         "should unpack to 4294967295 bytes, but the points of the header have 14500"));
  EXPECT_TRUE (contains (readingError (folder.write ("a.pcd", with (0, 20))), "cannot hold the 14500 bytes"));
  EXPECT_TRUE (
    contains (readingError (folder.write ("a.pcd", with (0, packed_size / 2))), "cannot be unpacked"));
  EXPECT_TRUE (contains (readingError (folder.write ("a.pcd", good.substr (0, words + 6))),
                         "the sizes of the compressed block"));
}

TEST (Pcd, SurvivesEveryTruncationAndManyFlippedBits)
{
  const TestFolder folder;
  const pcl::PCLPointCloud2 cloud = someCloud (40);
  pcl::PCDWriter ().writeBinary (folder / "binary.pcd", cloud);
  pcl::PCDWriter ().writeBinaryCompressed (folder / "compressed.pcd", cloud);
  pcl::PCDWriter ().writeASCII (folder / "ascii.pcd", cloud);
  std::mt19937 random (11);
  for (const char* const name : {"binary.pcd", "compressed.pcd", "ascii.pcd"}) {
    std::string good = folder.read (name);
    // PCL pads binary files with zeros; a number of a text file is still one without its last digits.
    good.resize (name == std::string ("ascii.pcd") ? good.rfind (' ') : good.find_last_not_of ('\0') + 1);
    for (std::size_t size = 0; size < good.size (); size += 3)
      EXPECT_NE (readingError (folder.write ("bad.pcd", good.substr (0, size))), "") << name << " " << size;
    for (int i = 0; i < 700; ++i) {
      std::string bad = good;
      for (int flips = i % 4; flips >= 0; --flips) // every second one in the header
        bad[random () % (i % 2 == 0 ? 250 : bad.size ())] ^= static_cast<char> (1 << random () % 8);
      readingError (folder.write ("bad.pcd", bad));
    }
  }
}
