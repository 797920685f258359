// Tries the motion as large as it was, and then smaller, until it is within every limit.
#include "tools/motion/adapt_motion.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "gaitway/motion/motion_adaptation.hpp"
#include "gaitway/motion/motion_planner.hpp"
#include "gaitway/process/text_file.hpp"
#include "gaitway/trajectory/motion_table.hpp"
#include "tools/command_line.hpp"

namespace gaitway::tools {
namespace {

constexpr std::array kShares{1.0, 0.9, 0.8, 0.7, 0.6, 0.5};

struct Adapted {
  std::string text;
  motion::AdaptedMotion adapted;
  motion::PreparedMotion prepared;
};

std::vector<std::string> comments_of(const motion::AdaptedMotion& adapted, const std::string& from,
                                     const std::string& to, double share, const std::string& too_large) {
  std::vector<std::string> comments{
      fmt::format("Adapted from {}'s {} for {} by `gaitway motion adapt`: lengths times {:.4g}, times times "
                  "{:.4g}.",
                  from, adapted.motion.name, to, adapted.length_factor, adapted.time_factor)};
  for (const std::string& change : adapted.changes) comments.push_back("- " + change);
  if (share < 1.0)
    comments.push_back(fmt::format("- made {:g} times as large; at first: {}", share, too_large));
  if (motion::is_on_ground(adapted.motion)) {
    comments.emplace_back(
        "- on the ground neither balance nor torque is planned: see it in the simulator before the robot "
        "plays it");
  }
  comments.front() += comments.size() == 1 ? " Changed: nothing" : " Changed:";
  return comments;
}

// The largest share of the motion that keeps every limit. Throws motion::MotionError, what was said first, if
// none does.
Adapted adapt_as_large_as_possible(const urdf::RobotModel& from, const motion::Motion& original,
                                   const urdf::RobotModel& to, const std::filesystem::path& file) {
  const ProgressLine progress(true);
  std::string too_large, still_too_large;
  for (const double share : kShares) {
    motion::AdaptedMotion adapted = motion::adapt_motion(from, original, to, share);
    std::string text =
        motion::motion_text(adapted.motion, to, comments_of(adapted, from.name, to.name, share, too_large));
    motion::Motion read = motion::parse_motion(text, file, to);
    // The file may never be written: what is refused is called by names that are there.
    for (motion::Key& key : read.keys)
      key.where = fmt::format("motion '{}' on the robot '{}': key '{}'", read.name, to.name, key.name);
    progress.show(fmt::format("  planning it {:g} times as large ", share));
    try {
      return {std::move(text), std::move(adapted), motion::prepare_motion(to, read, {})};
    } catch (const motion::MotionError& error) {
      if (too_large.empty()) too_large = error.what();
      still_too_large = error.what();
      if (motion::is_on_ground(original)) break;
    }
  }
  std::string why = too_large;
  if (still_too_large != too_large)
    why += fmt::format("; {:g} times as large: {}", kShares.back(), still_too_large);
  throw motion::MotionError(fmt::format(
      "motion '{}' does not go on the robot '{}'{}: {}", original.name, to.name,
      motion::is_on_ground(original) ? "" : fmt::format(", even {:g} times as large", kShares.back()), why));
}

void require_nothing_there(const std::filesystem::path& file) {
  if (!std::filesystem::exists(std::filesystem::symlink_status(file))) return;
  throw std::invalid_argument(fmt::format(
      "{}: is there already. Give --force to replace it, or name another folder with --out", file.string()));
}

}  // namespace

void adapt_motion_file(const AdaptOptions& options) {
  const urdf::RobotModel from = urdf::load_robot(options.from), to = urdf::load_robot(options.robot);
  const motion::Motion original = motion::read_motion(options.motion, from);
  const std::filesystem::path file = options.out / (original.name + ".yaml");
  const std::filesystem::path table = options.out / (original.name + trajectory::kMotionTableEnding);
  if (!options.force) {
    require_nothing_there(file);
    require_nothing_there(table);
  }
  const Adapted made = adapt_as_large_as_possible(from, original, to, file);
  std::filesystem::create_directories(options.out);
  process::write_text_file(file, made.text);
  trajectory::write_motion_table(made.prepared.table, table);
  for (std::size_t end = 0, begin = 0; made.text[begin] == '#'; begin = end + 1) {
    end = made.text.find('\n', begin);
    fmt::print("{}\n", made.text.substr(begin + 2, end - begin - 2));
  }
  fmt::print("{}: {:.2f} s, planned within all limits, in {}\n", original.name,
             made.prepared.planned.plan.duration_s(), file.string());
}

}  // namespace gaitway::tools
