// `gaitway robot import`: a maker's URDF becomes a folder that loads; nothing is overwritten unasked.
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "gaitway/importer/import.hpp"
#include "gaitway/msgcontroller/network_profile.hpp"
#include "gaitway/trajectory/robot_gait.hpp"
#include "gaitway/urdf/robot_model.hpp"
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

  void empty() const {
    for (const auto& entry : std::filesystem::directory_iterator(path_))
      std::filesystem::remove_all(entry.path());
  }
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

struct Brought {
  importer::ImportedRobot imported;
  urdf::RobotModel robot;
  std::string bus;
};

// How many of a robot's joints, from the first on, its bus is proven for.
std::size_t joints_on_bus(urdf::RobotModel robot) {
  while (!robot.joints.empty() && !msgcontroller::complaint_about_network(robot).empty())
    robot.joints.pop_back();
  return robot.joints.size();
}

// How fast the gait is that is chosen for a robot in this stand.
double fastest_m_per_s(urdf::RobotModel robot, const importer::HomePosture& home) {
  for (std::size_t i = 0; i < robot.joints.size(); ++i) robot.joints[i].home_rad = home.angle_rad[i];
  robot.hip_height_m = home.hip_height_m;
  const trajectory::GaitParameters gait = trajectory::gait_of(robot);
  return gait.max_step_forward_m / gait.step_time_s;
}

// Straighter knees leave ankles more room and legs less reach: the stand from which the robot walks fastest;
// the usual one, if it walks as fast as a robot needs.
importer::ImportedRobot with_best_stand(const importer::ImportedRobot& imported,
                                        const urdf::RobotModel& robot) {
  constexpr double kStraightest_rad = 0.35, kStep_rad = 0.08;
  constexpr double kFastEnough_m_per_s = 0.455;  // of a body as large as humanoid22: Froude's number 0.06
  constexpr double kWorthwhile = 1.03;
  importer::ImportedRobot best = imported;
  double fastest = fastest_m_per_s(robot, imported.home);
  const double enough = kFastEnough_m_per_s * robot.body_scale().factor("m/s");
  for (double bend = imported.home.knee_bend_rad - kStep_rad; bend > kStraightest_rad && fastest < enough;
       bend -= kStep_rad) {
    importer::ImportedRobot straighter = importer::with_knees_bent(imported, bend);
    const double speed = fastest_m_per_s(robot, straighter.home);
    if (speed < kWorthwhile * fastest) continue;
    fastest = speed;
    best = std::move(straighter);
  }
  if (best.home.knee_bend_rad < imported.home.knee_bend_rad) {
    constexpr double kDegree = 180.0 / std::numbers::pi;
    best.notes.push_back(fmt::format(
        "the knees stand bent by {:.0f} deg instead of {:.0f}: so the robot walks fastest, up to {:.2f} m/s",
        best.home.knee_bend_rad * kDegree, imported.home.knee_bend_rad * kDegree, fastest));
  }
  return best;
}

// As many joints as the bus is proven for, those that carry most.
Brought bring(importer::ImportedRobot imported, const FolderInTheMaking& folder) {
  constexpr std::size_t kMostNodes = 64;
  imported = importer::with_fewer_joints(imported, kMostNodes);
  importer::write_robot_folder(imported, folder.path());
  urdf::RobotModel robot = urdf::load_robot(folder.path());
  const std::size_t most = joints_on_bus(robot);
  importer::ImportedRobot best = with_best_stand(imported, robot);
  if (most < robot.joints.size() || best.home.knee_bend_rad != imported.home.knee_bend_rad) {
    imported = importer::with_fewer_joints(best, most);
    folder.empty();
    importer::write_robot_folder(imported, folder.path());
    robot = urdf::load_robot(folder.path());
  }
  std::string bus =
      fmt::format("{} joints on one bus, load {:.0f} % in the worst case, every deadline proven",
                  robot.joints.size(), 100.0 * msgcontroller::prove_network(robot).load);
  return {std::move(imported), std::move(robot), std::move(bus)};
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
  const Brought brought = bring(std::move(imported), folder);
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
