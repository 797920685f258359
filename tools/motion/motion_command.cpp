// `gaitway motion`: key-frame motions, from their files to points and pictures.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "gaitway/facts/facts.hpp"
#include "gaitway/input/complaint.hpp"
#include "gaitway/motion/motion.hpp"
#include "gaitway/motion/motion_planner.hpp"
#include "gaitway/process/installation.hpp"
#include "gaitway/simulator/camera.hpp"
#include "gaitway/trajectory/motion_table.hpp"
#include "tools/command_line.hpp"
#include "tools/motion/adapt_motion.hpp"

namespace gaitway::tools {
namespace {

constexpr int kPictureWidth_px = 300, kPictureHeight_px = 420, kColumns = 8;
constexpr std::ptrdiff_t kFreeJoint = 7;  // position and quaternion of the pelvis

std::vector<double> pose_of(const motion::MotionPlan& plan, std::size_t point) {
  const Eigen::Isometry3d& pelvis = plan.pelvis[point];
  const Eigen::Quaterniond turn(pelvis.linear());
  std::vector<double> pose{pelvis.translation().x(),
                           pelvis.translation().y(),
                           pelvis.translation().z(),
                           turn.w(),
                           turn.x(),
                           turn.y(),
                           turn.z()};
  const std::span<const double> joints = plan.point(point);
  pose.insert(pose.end(), joints.begin(), joints.end());
  return pose;
}

// The planned postures, evenly spread over the motion's time. Throws std::runtime_error where no picture can
// be made.
void draw_motion(const urdf::RobotModel& robot, const motion::MotionPlan& plan, int pictures,
                 const std::filesystem::path& file) {
  if (std::ranges::find(plan.contact, motion::Contact::none) != plan.contact.end()) {
    throw std::invalid_argument(
        fmt::format("motion '{}': parts of it have contact none, and its plan does not say where the robot "
                    "lies then. Only motions on "
                    "flat feet can be drawn",
                    plan.name));
  }
  const simulator::Plant plant(robot, {.mismatch = 0.0});
  simulator::Camera camera(plant, kPictureWidth_px, kPictureHeight_px);
  std::vector<simulator::Image> images;
  for (int i = 0; i < pictures; ++i) {
    const std::size_t point =
        (plan.point_count() - 1) * static_cast<std::size_t>(i) / static_cast<std::size_t>(pictures - 1);
    images.push_back(camera.render(pose_of(plan, point)));
  }
  simulator::write_film_strip(file.string(), images, std::min(pictures, kColumns));
}

struct MotionOptions {
  std::string motion;            // name of one of the robot's motions, or a file
  std::filesystem::path folder;  // of motions; none: the robot's own
  std::filesystem::path robot, from;
  std::filesystem::path out;
  int pictures = 8;
  bool force = false;
};

constexpr double kDegree = std::numbers::pi / 180.0;

std::filesystem::path folder_of(const MotionOptions& options) {
  return options.folder.empty() ? process::motion_directory(options.robot) : options.folder;
}

// A motion of the folder by its name, or the file itself.
std::filesystem::path file_of(const MotionOptions& options, const std::filesystem::path& folder) {
  const std::filesystem::path given = options.motion;
  if (given.has_parent_path() || given.extension() == ".yaml") return given;
  std::vector<std::string> known;
  for (const std::filesystem::path& file : motion::motion_files(folder)) {
    if (file.stem() == options.motion) return file;
    known.push_back(file.stem().string());
  }
  throw std::invalid_argument(fmt::format("'{}': there is no such motion in {}. {}", options.motion,
                                          folder.string(), input::suggest(options.motion, known)));
}

struct Loaded {
  urdf::RobotModel robot;
  motion::Motion motion;
};

Loaded load(const MotionOptions& options) {
  urdf::RobotModel robot = urdf::load_robot(options.robot);
  motion::Motion motion = motion::read_motion(file_of(options, folder_of(options)), robot);
  return {std::move(robot), std::move(motion)};
}

struct TimedPlan {
  motion::PlannedMotion planned;
  double planning_s = 0.0;
};

TimedPlan plan(const Loaded& loaded) {
  const auto started = std::chrono::steady_clock::now();
  TimedPlan result{motion::plan_motion(loaded.robot, loaded.motion, {}), 0.0};
  result.planning_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  return result;
}

int list(const MotionOptions& options) {
  const urdf::RobotModel robot = urdf::load_robot(options.robot);
  for (const std::filesystem::path& file : motion::motion_files(folder_of(options))) {
    const motion::Motion motion = motion::read_motion(file, robot);
    fmt::print("{:<12} {:2} keys  {}\n", file.stem().string(), motion.keys.size(), motion.description);
  }
  return 0;
}

int show(const MotionOptions& options) {
  const Loaded loaded = load(options);
  const auto postures =
      motion::key_postures(loaded.robot, loaded.motion, motion::limits_of(loaded.motion, {}));
  fmt::print("{}: {}\n", loaded.motion.name, loaded.motion.description);
  const std::size_t first = postures.size() - loaded.motion.keys.size();
  for (std::size_t i = 0; i < loaded.motion.keys.size(); ++i) {
    const motion::Key& key = loaded.motion.keys[i];
    fmt::print("\n{}  (contact {}, hold {} s)\n", key.name, motion::name_of(key.contact), key.hold_s);
    for (std::size_t j = 0; j < loaded.robot.joints.size(); ++j) {
      const double angle = postures[i + first].joint_rad[static_cast<Eigen::Index>(j)];
      const double away = angle - loaded.robot.joints[j].home_rad;
      if (std::abs(away) < 0.05 * kDegree) continue;
      fmt::print("  {:<22} {:7.1f} deg  ({:+.1f} from home)\n", loaded.robot.joints[j].name, angle / kDegree,
                 away / kDegree);
    }
  }
  return 0;
}

void write_points(const urdf::RobotModel& robot, const motion::MotionPlan& plan, std::FILE* out) {
  fmt::print(out, "time_s,contact");
  for (const urdf::Joint& joint : robot.joints) fmt::print(out, ",{}_rad", joint.name);
  for (const urdf::Joint& joint : robot.joints) fmt::print(out, ",{}_reference_rad", joint.name);
  fmt::print(out, "\n");
  for (std::size_t i = 0; i < plan.point_count(); ++i) {
    fmt::print(out, "{:.2f},{}", static_cast<double>(i) * facts::kSlot_s, motion::name_of(plan.contact[i]));
    for (const double angle : plan.point(i)) fmt::print(out, ",{:.6f}", angle);
    for (const double angle : plan.reference(i)) fmt::print(out, ",{:.6f}", angle);
    fmt::print(out, "\n");
  }
}

int write_plan(const MotionOptions& options) {
  const Loaded loaded = load(options);
  const TimedPlan result = plan(loaded);
  if (options.out.empty()) {
    write_points(loaded.robot, result.planned.plan, stdout);
    return 0;
  }
  const std::string name = options.out.string();
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(name.c_str(), "w"), &std::fclose);
  if (!file) throw std::runtime_error(fmt::format("--out {}: cannot be written", name));
  write_points(loaded.robot, result.planned.plan, file.get());
  fmt::print("{}: {} points, {:.2f} s, in {}\n", loaded.motion.name, result.planned.plan.point_count(),
             result.planned.plan.duration_s(), name);
  return 0;
}

int check(const MotionOptions& options) {
  const Loaded loaded = load(options);
  const TimedPlan result = plan(loaded);
  const motion::PlannedMotion& planned = result.planned;
  fmt::print(
      "{}: {:.2f} s in {} points (first guess {:.2f} s), planned in {:.2f} s; slowed down by {:.1f} % at the "
      "end\n",
      loaded.motion.name, planned.plan.duration_s(), planned.plan.point_count(), planned.first_duration_s,
      result.planning_s, 100.0 * (planned.stretch - 1.0));
  for (const motion::KeyTime& key : planned.plan.keys) {
    fmt::print("  {:<16} {:6.2f} s\n", key.name, static_cast<double>(key.reached) * facts::kSlot_s);
  }
  fmt::print("Nearest to each limit:\n");
  for (const motion::LimitUse& use : planned.report.uses) fmt::print("  {}\n", motion::describe(use));
  return 0;
}

int prepare(const MotionOptions& options) {
  const Loaded loaded = load(options);
  const motion::PreparedMotion prepared = motion::prepare_motion(loaded.robot, loaded.motion, {});
  const std::filesystem::path folder = options.out.empty() ? std::filesystem::path(".") : options.out;
  std::filesystem::create_directories(folder);
  const std::filesystem::path file = folder / (loaded.motion.name + trajectory::kMotionTableEnding);
  trajectory::write_motion_table(prepared.table, file);
  fmt::print("{}: {:.2f} s, left within {:.2f} s from any of its {} batches, in {}\n", loaded.motion.name,
             prepared.planned.plan.duration_s(),
             static_cast<double>(prepared.longest_exit_points) * facts::kSlot_s, prepared.table.batch_count(),
             file.string());
  return 0;
}

int draw(const MotionOptions& options) {
  const Loaded loaded = load(options);
  const std::filesystem::path file =
      options.out.empty() ? std::filesystem::path(loaded.motion.name + ".png") : options.out;
  draw_motion(loaded.robot, plan(loaded).planned.plan, options.pictures, file);
  fmt::print("{}: {} pictures in {}\n", loaded.motion.name, options.pictures, file.string());
  return 0;
}

int adapt(const MotionOptions& options) {
  std::error_code unknown;  // of a folder that is none, which the loader will name
  if (std::filesystem::equivalent(options.from, options.robot, unknown)) {
    throw std::invalid_argument(
        fmt::format("--robot {}: the motion is this robot's own. Name the folder of another one",
                    options.robot.string()));
  }
  adapt_motion_file({file_of(options, process::motion_directory(options.from)), options.from, options.robot,
                     options.out.empty() ? process::motion_directory(options.robot) : options.out,
                     options.force});
  return 0;
}

}  // namespace

void declare_program(const CommandLine& app) {
  const auto given = std::make_shared<MotionOptions>();
  MotionOptions& options = *given;
  const CommandLine command = add_command(app, "motion");
  command.needs_subcommand();
  options.robot = process::default_robot_directory();
  options.from = options.robot;
  const auto add = [&](const char* name, const char* text, const char* examples, const char* done,
                       int (*run)(const MotionOptions&), bool of_one = true) {
    const CommandLine sub = command.subcommand(name, text);
    if (of_one) sub.option("motion", options.motion, "Name of a motion, or its file").required();
    sub.option("--motions", options.folder,
               "Folder with the motions; otherwise motions/ of the robot's folder");
    sub.option("--robot", options.robot, "Folder of the robot's description");
    sub.footer(fmt::format("Examples:\n{}Exit code: 0 {}, 1 not, or the input was bad.", examples, done));
    sub.runs([given, run] { return run(*given); });
    return sub;
  };
  add("list", "The motions there are", "  gaitway motion list\n  gaitway motion list --robot my_robot\n",
      "they are listed", list, false);
  add("show", "Postures at the keys, with the legs as they are solved",
      "  gaitway motion show squat\n  gaitway motion show my_motion.yaml --robot my_robot\n",
      "the keys are possible and shown", show);
  add("plan", "Every point as CSV", "  gaitway motion plan kick --out kick.csv\n",
      "planned within all limits", write_plan)
      .option("--out", options.out, "File; otherwise to the terminal");
  add("check", "Plan, and say how near to each limit every point comes",
      "  gaitway motion check kick\n  gaitway motion check squat --robot my_robot\n",
      "planned within all limits", check);
  add("prepare", "Plan it, and write what the robot plays: the way, and a way out of every batch",
      "  gaitway motion prepare my_motion.yaml --robot my_robot --out my_robot/motions\n",
      "planned within all limits and written", prepare)
      .option("--out", options.out, "Folder; otherwise the current one");
  const CommandLine other = command.subcommand(
      "adapt",
      "Make one robot's motion another's: match the joints, scale, plan, and write it into its folder");
  other.option("motion", options.motion, "Name of a motion of the robot that it is from, or its file")
      .required();
  other.option("--robot", options.robot, "Folder of the robot that shall play it").required();
  other.option("--from", options.from, "Folder of the robot that the motion was made for");
  other.option("--out", options.out, "Folder; otherwise motions/ of the robot's folder");
  other.option("--force", options.force, "Replace NAME.yaml and NAME.motion that are there already");
  other.runs([given] { return adapt(*given); });
  other.footer(
      "Joints are matched by what they do: legs, arms, waist and neck by axis and place at home, never by "
      "name. Lengths "
      "and\nhip heights scale with the body, times with the root of it, angles are taken against how the "
      "limbs hang at "
      "home. What\nhas to be smaller, or is left out, stands in the comments of the new file.\n"
      "Examples:\n"
      "  gaitway motion adapt kick --robot my_robot\n"
      "  gaitway motion adapt get_up_front --robot my_robot --out trial\n"
      "  gaitway motion adapt dance.yaml --from first_robot --robot second_robot\n"
      "Exit code: 0 planned within all limits and written, 1 it does not go on this robot, it is there "
      "already, "
      "or the input\nwas bad: nothing is written.");
  const CommandLine film = add(
      "draw", "A film strip of the planned motion",
      "  gaitway motion draw kick\n  gaitway motion draw my_motion.yaml --out my_motion.png --pictures 16\n",
      "planned within all limits and drawn", draw);
  film.option("--out", options.out, "PNG file; otherwise NAME.png");
  film.option("--pictures", options.pictures, "How many").between(2, 64);
  command.footer(
      "Examples:\n"
      "  gaitway motion check kick\n"
      "  gaitway motion draw my_motion.yaml --out my_motion.png\n"
      "  gaitway motion prepare my_motion.yaml --out my_motions\n"
      "  gaitway motion adapt kick --robot my_robot\n"
      "Exit code: 0 planned within all limits, 1 not, or the input was bad.");
}

}  // namespace gaitway::tools
