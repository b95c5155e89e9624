#include "app_error.h"
#include "app_files.h"
#include "app_main.h"
#include "display_check.h"
#include "graph_options.h"
#include "graph_viewer_model.h"
#include "graph_viewer_window.h"
#include "picture.h"
#include "sample_input.h"

#include <pcl/manifold/complex_io.h>

#include <filesystem>
#include <iterator>
#include <sstream>
#include <vector>

using namespace pcl::manifold;
using namespace pcl::manifold::apps;

int
main (int argc, char** argv)
{
  std::string help =
    "Shows how a surface is reconstructed from the neighbourhoods of points, step by step, and "
    "what\nthe parameters do. Keys:";
  for (const std::string& line : GraphViewerModel::help ())
    help += "\n  " + line;
  CommandLine command_line ("pcl_graph_reconstruction_viewer", help);
  std::string input_file;
  std::string screenshot;
  std::string keys;
  GraphOptions options;
  GraphViewerWindow::Outputs outputs{"graph_mesh.ply", "graph_picture.png"};
  command_line.positional (
    "INPUT", std::string ("cloud: ") + cloud_file_types + "; a .ply without header is read as text",
    input_file);
  options.declare (command_line);
  command_line.option ("threads", "n", "0 = all", options.common.threads, {0, 1024})
    .option ("mesh", "file", "where F2 saves the mesh: .ply .obj .vtk .vtu", outputs.mesh)
    .option ("picture", "file", "where F3 saves the picture: .png", outputs.picture)
    .option ("keys", "keys", "pressed at the beginning, separated by blanks: \"Right Right A\"", keys)
    .option ("screenshot", "file", "write what the window shows to a .png instead of opening it", screenshot)
    .flag ("quiet", "print nothing but errors", options.common.quiet)
    .writes ("-mesh", outputs.mesh)
    .writes ("-picture", outputs.picture)
    .writes ("-screenshot", screenshot)
    .example ("pcl_graph_reconstruction_viewer scan.pcd -mesh mesh.ply")
    .example (
      "pcl_graph_reconstruction_viewer scan.pcd -keys \"Right Right Up\" -screenshot adjacencies.png");

  return runApp (argc, argv, command_line, [&] {
    options.complete ();
    std::istringstream words (keys);
    const std::vector<std::string> pressed{std::istream_iterator<std::string> (words), {}};
    for (const std::string& key : pressed)
      if (!GraphViewerModel::knows (key))
        throw UsageError ("-keys", "there is no key '" + key + "', see -h");
    requireType ("-picture", outputs.picture, {".png"});
    requireType ("-mesh", outputs.mesh, {".ply", ".obj", ".vtk", ".vtu"});
    if (!screenshot.empty ())
      requireType ("-screenshot", screenshot, {".png"});
    else if (!canOpenWindow ())
      throw AppError (input_file, "a window needs a display with OpenGL: set DISPLAY, or use -screenshot");
    const Picture is_possible (screenshot);
    const InputCloud input = readCloud (input_file, Reading::LAX);
    printNotes (input, options.common.quiet);

    GraphViewerModel model (input, options.parameters);
    if (model.status () != Status::OK && model.status () != Status::DIMENSION_TOO_LOW)
      requireOk (input_file, model.status ());
    GraphViewerWindow window (model, std::filesystem::path (input_file).filename ().string (), outputs,
                              screenshot.empty ());
    for (const std::string& key : pressed)
      window.press (key);
    if (screenshot.empty ())
      window.run ();
    else
      window.saveScreenshot (screenshot);
  });
}
