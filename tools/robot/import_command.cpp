// `gaitway robot import`: a maker's URDF becomes a folder that loads; nothing is overwritten unasked.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "gaitway/importer/import.hpp"
#include "tools/robot/bring_robot.hpp"
#include "tools/robot/import_folder.hpp"
#include "tools/robot/import_page.hpp"
#include "tools/robot/robot_commands.hpp"

namespace gaitway::tools {
namespace {

struct ImportCommandOptions {
  std::filesystem::path file, out;
  bool force = false, quiet = false;
  std::vector<std::filesystem::path> packages;
  std::optional<std::string> forward;
  std::vector<std::string> hold;
};

Eigen::Vector3d axis_of(const std::string& word) {
  const bool negative = word.starts_with('-');
  const std::size_t axis = std::string_view("xyz").find(word.substr(negative ? 1 : 0));
  return Eigen::Vector3d::Unit(static_cast<Eigen::Index>(axis)) * (negative ? -1.0 : 1.0);
}

std::string folder_name(std::string name) {
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-' && c != '_') c = '_';
  }
  return name.empty() ? "robot" : name;
}

int import_urdf(const ImportCommandOptions& options) {
  const auto started = std::chrono::steady_clock::now();
  importer::ImportOptions how;
  how.read.package_folders = options.packages;
  how.held_still = options.hold;
  if (options.forward) how.plan.forward = axis_of(*options.forward);
  importer::ImportedRobot imported = importer::import_robot(options.file, how);
  const std::filesystem::path out =
      options.out.empty() ? std::filesystem::path(folder_name(imported.robot.name)) : options.out;
  ImportFolder folder(out, imported, options.force);
  const BroughtRobot brought = bring_robot(std::move(imported), folder.path());
  const ImportSummary summary{brought.imported, brought.robot, brought.bus};
  const std::string without_picture = write_import_page(summary, folder.path());
  const std::vector<std::string> kept = folder.kept();
  folder.take_its_place();
  if (!without_picture.empty()) fmt::print(stderr, "gaitway robot import: no picture: {}\n", without_picture);
  if (!options.quiet) {
    const std::string kept_text =
        kept.empty() ? "" : fmt::format("  {:<14}{}\n", "kept", fmt::join(kept, ", "));
    fmt::print("{}{}  {:<14}{} in {:.1f} s\n  {:<14}gaitway robot check {}\n", import_text(summary),
               kept_text, "written", (folder.place() / "import.html").string(),
               std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count(), "next",
               folder.place().string());
  }
  return kExitFine;
}

}  // namespace

void add_robot_import(const CommandLine& robot) {
  const CommandLine command = robot.subcommand("import", "Make a robot's folder of its maker's URDF");
  ImportCommandOptions& options = command.runs(import_urdf);
  command.option("file", options.file, "The URDF (expanded, no xacro)").required();
  command.option("--out", options.out, "Folder to write (default: the robot's name)");
  command.option("--force", options.force, "Replace what an import wrote there before");
  command.repeated("--packages", options.packages,
                   "Folder in which package:// is looked for; may be given again");
  command.option("--forward", options.forward, "Which way the robot looks: an axis of the root link")
      .one_of({"x", "-x", "y", "-y", "z", "-z"});
  command.repeated("--hold", options.hold, "Joint that shall not move; may be given again");
  command.option("--quiet", options.quiet, "Print nothing");
  command.footer(
      "Examples:\n"
      "  gaitway robot import talos.urdf\n"
      "  gaitway robot import g1.urdf --out robots/g1 --packages ~/ros/src --hold waist_yaw_joint\n"
      "Fixed joints are merged, meshes become convex hulls; legs, soles, home posture, IMU and motors are "
      "found or\n"
      "guessed, and each guess has a comment in robot.yaml. Then: gaitway robot check DIR.\n"
      "Exit code: 0 the folder is written, 1 the URDF cannot be brought (why is told), and nothing is.");
}

}  // namespace gaitway::tools
