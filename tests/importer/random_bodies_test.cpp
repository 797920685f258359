// Bodies that nobody has seen end in a walk or in a reason: none crashes, none falls.
// GAITWAY_RANDOM_BODIES=1000 random_bodies_tests looks at bodies 1 to 1000, =37..37 at body 37 alone;
// GAITWAY_RANDOM_BODIES_OUT=FOLDER keeps what was written of each of them.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gaitway/facts/facts.hpp"
#include "gaitway/importer/import.hpp"
#include "gaitway/input/complaint.hpp"
#include "gaitway/process/private_folder.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "generated_humanoid.hpp"
#include "random_humanoid.hpp"
#include "tools/robot/bring_robot.hpp"
#include "tools/robot/robot_check.hpp"
#include "tools/robot/robot_description.hpp"

namespace gaitway::importer {
namespace {

#ifdef GAITWAY_SANITIZED
constexpr int kUsual = 4;
#else
constexpr int kUsual = 12;
#endif
constexpr int kFirst = 101;  // of the usual ones
constexpr double kHalfSpeed = 0.5;
constexpr double kWalk_s = 6.0;
constexpr double kOfFastest = 0.75;  // at most, of what the chosen gait walks
constexpr unsigned kMost_s = 300;    // for one body: else it hangs

// What becomes of a body, from best to worst.
enum class End {
  walks,
  import_refuses,  // with a reason
  description_refuses,
  plugin_refuses,  // what the description had let pass
  walks_badly,     // too slow, or its batches were refused
  falls_walking,
  falls_standing,
  fault,  // of what an import wrote itself, or of the test
  crashes
};
constexpr std::array kEndNames{"walks",
                               "refused by the import",
                               "refused by the description",
                               "refused late",
                               "walks badly",
                               "falls walking",
                               "falls standing",
                               "fault",
                               "crashes"};

struct Outcome {
  End end = End::crashes;
  std::string reason;
};

struct Bodies {
  int first = kFirst, last = kFirst + kUsual - 1;
};
Bodies bodies() {
  const char* const wanted = std::getenv("GAITWAY_RANDOM_BODIES");
  if (wanted == nullptr) return {};
  Bodies range;
  if (std::sscanf(wanted, "%d..%d", &range.first, &range.last) == 2) return range;
  return {1, std::atoi(wanted)};
}

std::string first_line(const char* text) {
  const std::string all = text;
  return all.substr(0, all.find('\n'));
}

// Stands, steps on the spot, walks: with deviations from what the planner knows.
Outcome checked(const tools::RobotDescription& description, std::uint64_t seed) {
  const urdf::RobotModel& robot = description.robot;
  tools::RobotCheckOptions how;
  how.configuration = std::filesystem::path(GAITWAY_SOURCE_DIR) / "core/config/walk.yaml";
  how.plugin_path = {GAITWAY_PLUGIN_DIR};
  how.speed_m_per_s = std::min(tools::kFroudeSpeed * std::sqrt(facts::kGravity_m_per_s2 * robot.hip_height_m),
                               kOfFastest * description.speeds.front().most);
  how.walk_s = kWalk_s;
  std::optional<tools::RobotCheckOutcome> outcome;
  try {
    outcome = tools::check_robot(robot, seed, how, {});
  } catch (const std::exception& reason) {
    return {End::plugin_refuses, first_line(reason.what())};
  }
  if (outcome->walks())
    return {End::walks, outcome->trembles ? "trembling while it stands" : "at rest while it stands"};
  const std::string story = fmt::format("{}{:.3f} of {:.3f} m/s, {} of {} batches refused; {}",
                                        outcome->fell ? fmt::format("at {:.2f} s, ", outcome->fell_at_s) : "",
                                        outcome->speed_m_per_s, how.speed_m_per_s, outcome->refused,
                                        outcome->batches + outcome->refused, outcome->first_refusal);
  if (!outcome->fell && outcome->refused == 0 && outcome->speed_m_per_s >= kHalfSpeed * how.speed_m_per_s)
    return {End::walks, "at more than half of the speed that it was told"};
  if (!outcome->fell) return {End::walks_badly, story};
  const bool stood = outcome->reached >= tools::RobotCheckOutcome::Reached::stand;
  return {stood ? End::falls_walking : End::falls_standing, story};
}

Outcome outcome_of(std::uint64_t seed, const std::filesystem::path& folder) {
  std::optional<ImportedRobot> imported;
  try {
    imported = import_robot(test::write_humanoid(test::RandomHumanoid(seed).draw(), folder / "maker"), {});
  } catch (const input::InputError& reason) {
    return {End::import_refuses, first_line(reason.what())};
  }
  // What was brought must load: a complaint about a file that the import itself wrote is a fault.
  std::filesystem::create_directories(folder / "robot");
  const tools::RobotDescription description =
      tools::describe_robot(tools::bring_robot(*std::move(imported), folder / "robot").robot);
  for (const std::string* complaint :
       {&description.gait_complaint, &description.torque_complaint, &description.bus_complaint}) {
    if (!complaint->empty()) return {End::description_refuses, *complaint};
  }
  return checked(description, seed);
}

// In a process of its own, which may crash.
Outcome outcome_apart(int seed, const std::filesystem::path& folder) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) return {End::fault, "no pipe"};
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    alarm(kMost_s);
    Outcome outcome;
    try {
      outcome = outcome_of(static_cast<std::uint64_t>(seed), folder);
    } catch (const std::exception& fault) {
      outcome = {End::fault, first_line(fault.what())};
    }
    const std::string text = static_cast<char>('0' + static_cast<int>(outcome.end)) + outcome.reason;
    _exit(write(ends[1], text.data(), text.size()) == static_cast<ssize_t>(text.size()) ? 0 : 1);
  }
  close(ends[1]);
  std::string text;
  std::array<char, 4096> part{};
  for (ssize_t read_bytes = 0; (read_bytes = read(ends[0], part.data(), part.size())) > 0;)
    text.append(part.data(), static_cast<std::size_t>(read_bytes));
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFSIGNALED(status)) return {End::crashes, fmt::format("signal {}", WTERMSIG(status))};
  if (WEXITSTATUS(status) != 0 || text.empty()) return {End::crashes, "ended in its midst"};
  return {static_cast<End>(text[0] - '0'), text.substr(1)};
}

// A reason without what differs from body to body: numbers, names, places.
std::string kind_of(const std::string& reason) {
  std::string kind;
  for (std::size_t i = 0; i < reason.size(); ++i) {
    const auto is_digit = [&](std::size_t at) {
      return at < reason.size() && std::isdigit(static_cast<unsigned char>(reason[at])) != 0;
    };
    if (reason[i] == '\'') {
      i = std::min(reason.find('\'', i + 1), reason.size());
      kind += "'...'";
    } else if (is_digit(i)) {
      while (is_digit(i + 1) || (i + 1 < reason.size() && reason[i + 1] == '.' && is_digit(i + 2))) ++i;
      kind += '#';
    } else {
      kind += reason[i];
    }
  }
  return kind;
}

void print_table(const std::map<End, std::map<std::string, int>>& kinds) {
  for (const auto& [end, reasons] : kinds) {
    int all = 0;
    for (const auto& [reason, count] : reasons) all += count;
    fmt::print("{:>5}  {}\n", all, kEndNames.at(static_cast<std::size_t>(end)));
    if (end > End::plugin_refuses) continue;
    for (const auto& [reason, count] : reasons) fmt::print("       {:>5}  {}\n", count, reason);
  }
}

TEST(RandomBodies, EndInAWalkOrInAReason) {
  const Bodies range = bodies();
  const char* const kept = std::getenv("GAITWAY_RANDOM_BODIES_OUT");
  std::map<End, std::map<std::string, int>> kinds;
  for (int seed = range.first; seed <= range.last; ++seed) {
    const process::PrivateFolder temporary("gaitway-body");
    const std::filesystem::path folder =
        kept != nullptr ? std::filesystem::path(kept) / fmt::format("{:04}", seed) : temporary.path();
    const Outcome outcome = outcome_apart(seed, folder);
    ++kinds[outcome.end][kind_of(outcome.reason)];
    if (outcome.end == End::walks) continue;
    const std::string line = fmt::format("body {}: {}: {}", seed,
                                         kEndNames.at(static_cast<std::size_t>(outcome.end)), outcome.reason);
    fmt::print("{}\n", line);
    EXPECT_FALSE(outcome.reason.empty());
    EXPECT_LE(outcome.end, End::description_refuses) << line;
  }
  print_table(kinds);
}

}  // namespace
}  // namespace gaitway::importer
