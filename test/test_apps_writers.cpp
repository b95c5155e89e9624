// Writing clouds and reports: fields kept, nothing half-written.
#include "app_error.h"
#include "app_files.h"
#include "cloud_reader.h"
#include "files/cloud_fields.h"
#include "report.h"
#include "test_apps_folder.h"

#include <json/reader.h>
#include <pcl/manifold/complex_io.h>

#include <csignal>
#include <cstring>
#include <limits>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <vector>

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace pcl::manifold;
using namespace pcl::manifold::apps;

namespace {

pcl::PCLPointCloud2
someCloud (std::uint32_t points)
{
  pcl::PCLPointCloud2 cloud;
  cloud.width = points;
  cloud.height = 1;
  for (const char* const name : {"x", "y", "z", "intensity"})
    appendField (cloud, name, pcl::PCLPointField::FLOAT32);
  allocatePoints (cloud);
  for (std::size_t i = 0; i < cloud.data.size (); ++i)
    cloud.data[i] = static_cast<std::uint8_t> (i * 37 % 120);
  return cloud;
}

/** \brief Root may write anywhere: as long as this lives, root is nobody and owns the folder as such. */
class AsNormalUser
{
public:
  explicit AsNormalUser (const TestFolder& folder)
  {
    if (geteuid () != 0)
      return;
    was_root_ = true;
    for (const auto& entry : std::filesystem::recursive_directory_iterator (folder / ""))
      EXPECT_EQ (chown (entry.path ().c_str (), nobody, nobody), 0);
    EXPECT_EQ (chown ((folder / "").c_str (), nobody, nobody), 0);
    is_ = seteuid (nobody) == 0;
  }

  AsNormalUser (const AsNormalUser&) = delete;
  AsNormalUser& operator= (const AsNormalUser&) = delete;

  ~AsNormalUser ()
  {
    if (was_root_) {
      EXPECT_EQ (seteuid (0), 0);
    }
  }

  bool is () const { return is_; }

private:
  static constexpr uid_t nobody = 65534;
  bool was_root_ = false;
  bool is_ = true;
};

} // namespace

TEST (Fields, AreAddedAndReplacedWithoutTouchingOthers)
{
  const pcl::PCLPointCloud2 before = someCloud (10);
  pcl::PCLPointCloud2 cloud = before;
  setField (cloud, "dimension", std::vector<std::uint8_t> (10, 2));
  setField (cloud, "confidence", std::vector<float> (10, 0.5f));
  setField (cloud, "label", std::vector<std::uint32_t> (10, 70000));
  setField (cloud, "dimension", std::vector<std::uint32_t> (10, 3));
  setField (cloud, "y", std::vector<double> (10, 0.1));
  std::string names;
  for (const pcl::PCLPointField& field : cloud.fields)
    names += field.name + " ";
  EXPECT_EQ (names, "x y z intensity dimension confidence label ");
  EXPECT_EQ (cloud.point_step, 4u * 3 + 8 + 4 * 3);
  for (std::size_t i = 0; i < 10; ++i)
    for (const char* const name : {"x", "z", "intensity"})
      EXPECT_EQ (std::memcmp (&before.data[i * 16 + findField (before, name)->offset],
                              &cloud.data[i * cloud.point_step + findField (cloud, name)->offset], 4),
                 0);
  EXPECT_THROW (setField (cloud, "dimension", std::vector<std::uint8_t> (9, 2)), std::invalid_argument);
}

TEST (Writer, ReplacesAFileAndKeepsItsMode)
{
  const TestFolder folder;
  const std::string file = folder.write ("a.pcd", "old");
  chmod (file.c_str (), 0640);
  const pcl::PCLPointCloud2 cloud = someCloud (100);
  writePcd (file, cloud, {1, 2, 3, 1, 0, 0, 0});
  const InputCloud again = readCloud (file);
  EXPECT_EQ (again.cloud.data, cloud.data);
  EXPECT_EQ (again.viewpoint, (std::array<double, 7>{1, 2, 3, 1, 0, 0, 0}));
  EXPECT_EQ (folder.count (), 1);
  struct stat status = {};
  stat (file.c_str (), &status);
  EXPECT_EQ (status.st_mode & 0777, 0640u);

  // So it is for meshes.
  const std::string mesh = folder.write ("a.ply", "old");
  chmod (mesh.c_str (), 0604);
  std::string why;
  EXPECT_TRUE (saveComplex (mesh, someCloud (5), pcl::SimplicialComplex (), why)) << why;
  stat (mesh.c_str (), &status);
  EXPECT_EQ (status.st_mode & 0777, 0604u);
  std::filesystem::remove (mesh);

  std::filesystem::create_symlink (file, folder / "link.pcd");
  writePcd (folder / "link.pcd", someCloud (5));
  EXPECT_TRUE (std::filesystem::is_symlink (folder / "link.pcd"));
  EXPECT_EQ (readCloud (file).size (), 5u);
}

TEST (Writer, SaysWhyAFileCannotBeWritten)
{
  const TestFolder folder;
  const auto error = [] (const std::string& file) {
    return messageOf<AppError> ([&] { checkWritable (file); });
  };
  EXPECT_EQ (error (folder / "new.pcd"), "");
  EXPECT_EQ (folder.count (), 0);
  EXPECT_TRUE (contains (error (folder / "none/a.pcd"), "there is no folder "));
  EXPECT_TRUE (contains (error (folder.write ("file", "") + "/a.pcd"), "there is no folder "));
  std::filesystem::create_directory (folder / "folder.pcd");
  EXPECT_TRUE (contains (error (folder / "folder.pcd"), "cannot be written: it is a folder"));
  EXPECT_TRUE (contains (error (folder / "folder.pcd/"), "cannot be written: it is a folder"));
  EXPECT_TRUE (contains (error ("/dev/full"), "/dev/full: cannot be written: it is no regular file"));
  if (std::filesystem::exists ("/proc/self")) {
    EXPECT_TRUE (contains (error ("/proc/a.pcd"), "/proc/a.pcd: cannot be written: "));
  }
  std::filesystem::create_directory (folder / "locked");
  chmod ((folder / "locked").c_str (), 0555);
  const std::string locked = folder.write ("locked.pcd", "old");
  chmod (locked.c_str (), 0444);
  const AsNormalUser user (folder);
  if (!user.is ())
    GTEST_SKIP () << "root may write anywhere";
  EXPECT_TRUE (contains (error (folder / "locked/a.pcd"), "cannot be written: Permission denied"));
  EXPECT_EQ (error (locked), locked + ": cannot be written: Permission denied");
}

TEST (Writer, RefusesAFileThatIsReadOnly)
{
  const TestFolder folder;
  const std::string file = folder.write ("a.pcd", "old");
  const std::string mesh = folder.write ("a.ply", "old");
  for (const std::string& name : {file, mesh})
    chmod (name.c_str (), 0444);
  const AsNormalUser user (folder);
  if (!user.is ())
    GTEST_SKIP () << "root may write anywhere";
  EXPECT_EQ (messageOf<AppError> ([&] { writePcd (file, someCloud (5)); }),
             file + ": cannot be written: Permission denied");
  std::string why;
  EXPECT_FALSE (canSaveComplex (mesh, why));
  EXPECT_EQ (why, "cannot be written: Permission denied");
  EXPECT_FALSE (saveComplex (mesh, someCloud (5), pcl::SimplicialComplex (), why));
  EXPECT_EQ (why, "cannot be written: Permission denied");
  EXPECT_EQ (folder.read ("a.pcd") + folder.read ("a.ply"), "oldold");
  EXPECT_EQ (folder.count (), 2);
}

TEST (Writer, LeavesNothingBehindOnAFullDisk)
{
  const TestFolder folder;
  const std::string file = folder.write ("a.pcd", "old");
  // A limit on the size of files stands in for the full disk.
  std::signal (SIGXFSZ, SIG_IGN);
  rlimit before = {};
  getrlimit (RLIMIT_FSIZE, &before);
  rlimit limit = before;
  limit.rlim_cur = 10000;
  setrlimit (RLIMIT_FSIZE, &limit);
  const std::string error = messageOf<AppError> ([&] { writePcd (file, someCloud (100000)); });
  setrlimit (RLIMIT_FSIZE, &before);
  EXPECT_EQ (error, file + ": cannot be written: File too large");
  EXPECT_EQ (folder.read ("a.pcd"), "old");
  EXPECT_EQ (folder.count (), 1);
}

TEST (Writer, LeavesNothingBehindIfWritingThrows)
{
  const TestFolder folder;
  const std::string name = std::string (250, 'a') + ".ply"; // as long as names can be
  EXPECT_THROW (
    {
      OutputFile file (folder / name);
      file.write ("half");
      EXPECT_EQ (folder.count (), 1);
      throw std::runtime_error ("broken");
    },
    std::runtime_error);
  EXPECT_EQ (folder.count (), 0);
  writeFile (folder / name, "whole");
  EXPECT_EQ (folder.read (name), "whole");
  EXPECT_EQ (folder.count (), 1);
}

TEST (Report, HoldsWhatWasToldAtFullPrecision)
{
  const TestFolder folder;
  Report report ("some_app");
  report.input ("file", "in \"1\".pcd");
  report.input ("points", Json::Value::UInt64 (5000000000));
  report.parameter ("rho", 0.1 + 0.2);
  Json::Value components (Json::arrayValue);
  components.append (std::numeric_limits<double>::infinity ());
  components.append (2);
  report.result ("genus", components);
  {
    const StageTimer timer (report, "triangulation");
  }
  report.stage ("poles", 1.25, 77);
  report.write (folder / "r.json");

  Json::Value root;
  std::istringstream text (folder.read ("r.json"));
  std::string errors;
  ASSERT_TRUE (Json::parseFromStream (Json::CharReaderBuilder (), text, &root, &errors)) << errors;
  EXPECT_EQ (root["app"].asString (), "some_app");
  EXPECT_EQ (root["input"]["file"].asString (), "in \"1\".pcd");
  EXPECT_EQ (root["input"]["points"].asUInt64 (), 5000000000u);
  EXPECT_EQ (root["parameters"]["rho"].asDouble (), 0.1 + 0.2);
  EXPECT_TRUE (root["result"]["genus"][0].isNull ());
  EXPECT_EQ (root["result"]["genus"][1].asInt (), 2);
  EXPECT_EQ (root["stages"][0]["name"].asString (), "triangulation");
  EXPECT_GE (root["stages"][0]["seconds"].asDouble (), 0);
  EXPECT_GT (root["stages"][0]["peak_bytes"].asUInt64 (), 1000000u);
  EXPECT_EQ (root["stages"][1]["seconds"].asDouble (), 1.25);
  EXPECT_EQ (root["stages"][1]["peak_bytes"].asUInt64 (), 77u);
}
