// The whole chain on a CAN interface of the kernel: virtual_robot, message_controller and main_controller,
// each a process of its own, walk together, and candump watches the bus.
#include <gmock/gmock.h>
#include <sys/syscall.h>
#include <time.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "program.hpp"

namespace gaitway {
namespace {

using test::Program;
using namespace std::chrono_literals;

const std::string kSource = GAITWAY_SOURCE_DIR;
constexpr double kWalk_s = 20.0;
constexpr double kStand_s = 2.0;  // from the message controller's start to the command to walk
constexpr int kLargestDivisor = 16;

// How many times slower than real time the robot's clocks are to run here (see guest_clock.cpp): system calls
// take most of the time, about 25 for each millisecond of the robot, and their cost tells how busy the
// machine is.
int measured_divisor() {
  constexpr int kCalls = 4000;
  timespec time{};
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < kCalls; ++i) {
    syscall(SYS_clock_gettime, CLOCK_MONOTONIC, &time);
  }
  const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - begin;
  const int divisor = static_cast<int>(std::ceil(took.count() / kCalls / 12.0));
  return std::clamp(divisor, 1, kLargestDivisor);
}

// What a log in candump's format says was on the bus: "123#0011", line by line.
std::vector<std::string> frames_of(const std::filesystem::path& log) {
  std::vector<std::string> frames;
  std::ifstream in(log);
  for (std::string time, interface, frame; in >> time >> interface >> frame;) {
    frames.push_back(frame);
  }
  return frames;
}

std::set<std::string> identifiers_of(const std::vector<std::string>& frames) {
  std::set<std::string> identifiers;
  for (const std::string& frame : frames) {
    identifiers.insert(frame.substr(0, frame.find('#')));
  }
  return identifiers;
}

std::vector<std::string> only(const std::vector<std::string>& frames,
                              const std::set<std::string>& identifiers) {
  std::vector<std::string> kept;
  std::copy_if(frames.begin(), frames.end(), std::back_inserter(kept), [&](const std::string& frame) {
    return identifiers.contains(frame.substr(0, frame.find('#')));
  });
  return kept;
}

// Compares without printing tens of thousands of lines.
void expect_same(const std::vector<std::string>& seen, const std::vector<std::string>& sent,
                 const char* sender) {
  EXPECT_EQ(seen.size(), sent.size()) << sender;
  const auto different = std::mismatch(seen.begin(), seen.end(), sent.begin(), sent.end());
  EXPECT_TRUE(different.first == seen.end() && different.second == sent.end())
      << sender << ": the first difference is at frame " << different.first - seen.begin() << ": candump saw "
      << (different.first == seen.end() ? "nothing" : *different.first) << ", and sent was "
      << (different.second == sent.end() ? "nothing" : *different.second);
}

class VcanWalk : public testing::Test {
 protected:
  VcanWalk() {
    std::string name = (std::filesystem::temp_directory_path() / "gaitway_vcan_XXXXXX").string();
    folder = mkdtemp(name.data());
  }
  ~VcanWalk() override { std::filesystem::remove_all(folder); }

  Program start(const std::string& name, std::vector<std::string> arguments) {
    return {folder,
            name,
            std::move(arguments),
            {"LD_PRELOAD=" GAITWAY_GUEST_CLOCK, "GAITWAY_CLOCK_DIVISOR=" + std::to_string(divisor)}};
  }
  [[nodiscard]] nlohmann::json summary(const std::string& name) const {
    return nlohmann::json::parse(test::text_of(folder / (name + ".json")), nullptr, false);
  }
  void run();
  // The robot's process kept up with its own clock.
  [[nodiscard]] bool kept_pace() const {
    const nlohmann::json robot = summary("robot");
    return robot.is_object() &&
           robot["overruns"].get<double>() < 0.1 * 1000.0 * robot["seconds"].get<double>();
  }
  void expect_that_candump_saw_what_was_sent();
  [[nodiscard]] bool walked_well() const {
    const nlohmann::json robot = summary("robot");
    return !robot["fell"].get<bool>() && walked_s() >= kWalk_s - 1.0 &&
           robot["distance_m"].get<double>() > 2.0;
  }
  // Seconds from the first step to the end.
  [[nodiscard]] double walked_s() const;
  [[nodiscard]] std::string everything() const {
    std::string all = "clocks run at 1/" + std::to_string(divisor) + " of their rate\n";
    for (const char* file :
         {"robot.txt", "robot.json", "message.txt", "message.json", "main.txt", "candump.txt"}) {
      all += std::string("--- ") + file + "\n" + test::text_of(folder / file) + "\n";
    }
    return all;
  }

  std::filesystem::path folder;
  int divisor = measured_divisor();
};

void VcanWalk::run() {
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    std::filesystem::remove_all(file);
  }
  const std::string robot_folder = kSource + "/urdf/humanoid22";
  // With a buffer for what comes while it does not get the processor; ends when the bus is silent for eight
  // seconds.
  Program candump(folder, "candump", {"candump", "-l", "-r", "32000000", "-T", "8000", "vcan0"});
  Program robot =
      start("robot", {GAITWAY_VIRTUAL_ROBOT, "--robot", robot_folder, "--can", "vcan0", "--summary",
                      "robot.json", "--sent-log", "robot.log", "--walk-log", "walk.csv"});
  Program message =
      start("message", {GAITWAY_MESSAGE_CONTROLLER, "--robot", robot_folder, "--can", "vcan0", "--memory",
                        "memory", "--walk", "0.15,0,0", "--walk-after", std::to_string(kStand_s), "--summary",
                        "message.json", "--sent-log", "message.log"});
  ASSERT_TRUE(test::until(60s, [&] { return std::filesystem::exists(folder / "memory"); })) << everything();
  Program main =
      start("main", {GAITWAY_MAIN_CONTROLLER, "--socket", "memory", "--robot", robot_folder, "--config",
                     kSource + "/core/config/walk.yaml", "--plugin-path", GAITWAY_PLUGIN_DIR});
  // It says so when it has taken the command to walk.
  ASSERT_TRUE(test::until(120s, [&] { return main.output().find("walk 0.15") != std::string::npos; }))
      << everything();
  std::this_thread::sleep_for(std::chrono::duration<double>((kWalk_s + 1.0) * divisor));
  EXPECT_EQ(main.stop(), 0) << everything();
  EXPECT_EQ(message.stop(), 0) << everything();
  EXPECT_EQ(robot.stop(), 0) << everything();
  EXPECT_EQ(candump.wait(60s), 0) << everything();
  ASSERT_TRUE(summary("robot").is_object() && summary("message").is_object()) << everything();
}

void VcanWalk::expect_that_candump_saw_what_was_sent() {
  std::filesystem::path log;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    if (file.path().filename().string().starts_with("candump-")) {
      log = file.path();
    }
  }
  const auto seen = frames_of(log);
  const auto from_robot = frames_of(folder / "robot.log"), from_message = frames_of(folder / "message.log");
  const auto robots = identifiers_of(from_robot), messages = identifiers_of(from_message);
  std::set<std::string> shared;
  std::set_intersection(robots.begin(), robots.end(), messages.begin(), messages.end(),
                        std::inserter(shared, shared.end()));
  EXPECT_TRUE(shared.empty()) << *shared.begin() << " had two senders";
  EXPECT_EQ(seen.size(), from_robot.size() + from_message.size()) << everything();
  expect_same(only(seen, robots), from_robot, "virtual_robot");
  expect_same(only(seen, messages), from_message, "message_controller");
  const auto counted = [this](const char* name) {
    const nlohmann::json can = summary(name)["can"];
    return can["sent"].get<std::uint64_t>() + can["late_echoes"].get<std::uint64_t>();
  };
  EXPECT_EQ(from_robot.size(), counted("robot"));
  EXPECT_EQ(from_message.size(), counted("message"));
  for (const char* name : {"robot", "message"}) {
    EXPECT_EQ(summary(name)["can"]["dropped_by_kernel"].get<int>(), 0) << everything();
  }
}

double VcanWalk::walked_s() const {
  std::ifstream log(folder / "walk.csv");
  std::string line;
  double begin_s = -1.0, last_s = 0.0;
  while (std::getline(log, line)) {
    double time_s = 0.0, x_m = 0.0;
    if (std::sscanf(line.c_str(), "%lf,%lf", &time_s, &x_m) == 2) {
      begin_s = begin_s < 0.0 && x_m > 0.02 ? time_s : begin_s;
      last_s = time_s;
    }
  }
  return begin_s < 0.0 ? 0.0 : last_s - begin_s;
}

// What candump saw must be what was sent, at any pace. Whether the robot walks well is judged where its
// processes got the processor in time.
TEST_F(VcanWalk, TheRobotWalksTwentySecondsAndCandumpSeesEveryFrameThatWasSent) {
  while (true) {
    run();
    ASSERT_FALSE(HasFatalFailure());
    expect_that_candump_saw_what_was_sent();
    if (walked_well() || kept_pace() || divisor == kLargestDivisor) {
      break;
    }
    divisor = std::min(2 * divisor, kLargestDivisor);
    std::printf("too slow for that pace: once more, with clocks at 1/%d of their rate\n", divisor);
  }
  EXPECT_TRUE(walked_well()) << "walked " << walked_s() << " s"
                             << (kept_pace() ? "" : "; this machine is too slow");
  EXPECT_GT(summary("message")["handed_over"].get<int>(), 200);
  std::printf("%s", everything().c_str());
}

}  // namespace
}  // namespace gaitway
