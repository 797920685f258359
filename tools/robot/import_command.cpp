// `gaitway robot import`: a maker's URDF becomes a folder that loads; nothing is overwritten unasked.
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "gaitway/importer/import.hpp"
#include "tools/robot/bring_robot.hpp"
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

// A folder beside `place` that is gone again unless it is given its name.
class FolderInTheMaking {
 public:
  explicit FolderInTheMaking(const std::filesystem::path& place) : place_(place) {
    const std::filesystem::path parent = std::filesystem::absolute(place).lexically_normal().parent_path();
    std::filesystem::create_directories(parent);
    std::string pattern = (parent / ".import-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) {
      throw std::system_error(errno, std::generic_category(), "cannot make a folder in " + parent.string());
    }
    path_ = pattern;
    std::filesystem::permissions(path_, std::filesystem::perms(0755));
  }
  ~FolderInTheMaking() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  FolderInTheMaking(const FolderInTheMaking&) = delete;
  FolderInTheMaking& operator=(const FolderInTheMaking&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  // What it holds replaces what has the same name there; everything else there stays.
  void take_its_place() const {
    std::filesystem::create_directories(place_);
    for (const auto& entry : std::filesystem::directory_iterator(path_)) {
      const std::filesystem::path target = place_ / entry.path().filename();
      std::filesystem::remove_all(target);
      std::filesystem::rename(entry.path(), target);
    }
  }

 private:
  std::filesystem::path place_, path_;
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
  if (!options.force && std::filesystem::exists(out) &&
      (!std::filesystem::is_directory(out) || !std::filesystem::is_empty(out))) {
    throw std::invalid_argument(fmt::format(
        "{}: is there already. Give another --out, or --force to replace what an import writes there",
        out.string()));
  }
  const FolderInTheMaking folder(out);
  const BroughtRobot brought = bring_robot(std::move(imported), folder.path());
  const ImportSummary summary{brought.imported, brought.robot, brought.bus};
  const std::string without_picture = write_import_page(summary, folder.path());
  folder.take_its_place();
  if (!without_picture.empty()) fmt::print(stderr, "gaitway robot import: no picture: {}\n", without_picture);
  if (!options.quiet) {
    fmt::print("{}  {:<14}{} in {:.1f} s\n  {:<14}gaitway robot check {}\n", import_text(summary), "written",
               (out / "import.html").string(),
               std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count(), "next",
               out.string());
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
  command.option("--hold", options.hold, "Joints that shall not move");
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
