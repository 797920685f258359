// `gaitway dev`: a plug-in's source is watched, built and put into the walking robot at each change.

#include <fmt/format.h>
#include <poll.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "gaitway/facts/facts.hpp"
#include "gaitway/input/text.hpp"
#include "gaitway/manager/plugin_exchange.hpp"
#include "gaitway/process/installation.hpp"
#include "gaitway/process/private_folder.hpp"
#include "gaitway/process/real_time.hpp"
#include "gaitway/simulator/cosimulation.hpp"
#include "gaitway/simulator/scenario.hpp"
#include "tools/command_line.hpp"
#include "tools/dev/project_build.hpp"

namespace gaitway::tools {
namespace {

using facts::kMillisecond_ns;

struct DevOptions {
  std::filesystem::path project;  // folder with the plug-in's CMakeLists.txt
  std::filesystem::path build;    // empty: build/ in it
  std::vector<double> walk{0.15, 0.0, 0.0};
  double seconds = 0.0;     // of wall time; 0: until it is interrupted
  bool in_process = false;  // else in a process of its own
};

constexpr double kStand_s = 1.0;         // before it walks
constexpr double kVerdictAfter_s = 3.0;  // of walking with a new version

// The walking robot with the plug-in among the shipped ones.
class DevelopmentRobot {
 public:
  DevelopmentRobot(const std::filesystem::path& library, const DevOptions& options)
      : model_(urdf::load_robot(process::default_robot_directory())) {
    const std::filesystem::path config = process::default_config_file();
    const std::array libraries{library};
    core::PluginExchange plugins =
        core::put_in(core::read_configuration(config), libraries,
                     {.robot_directory = model_.directory, .plugin_path = core::plugin_search_path({})});
    plugin_ = plugins.added.front().name;
    for (core::PluginEntry& entry : plugins.configuration.plugins) {
      if (entry.name == plugin_ && !options.in_process) {
        entry.isolation = core::Isolation::process;
      }
    }
    fmt::print("{}\n", core::describe(plugins.added.front()));
    simulator::CosimulationOptions simulation;
    simulation.main_controller.configuration = config;
    simulation.main_controller.try_at_start = true;
    simulation.main_controller.plugins = plugins.configuration;
    commands_itself_ = !plugins.behaviour().empty();
    cosimulation_ = std::make_unique<simulator::Cosimulation>(model_, simulation);
    walk_ = {.velocity_m_per_s = {options.walk[0], options.walk[1]}, .turn_rate_rad_per_s = options.walk[2]};
    start_ns_ = process::monotonic_ns();
  }

  // Up to now, in real time; what was missed by much is left out.
  void catch_up() {
    const std::int64_t now_ns = process::monotonic_ns() - start_ns_;
    if (now_ns - cosimulation_->now_ns() > kLongestGap_ns) {
      start_ns_ += now_ns - cosimulation_->now_ns();
      return;
    }
    while (cosimulation_->now_ns() < now_ns && !fell()) {
      if (!walking_ && time_s() >= kStand_s) {
        walking_ = true;
        if (!commands_itself_) {
          cosimulation_->apply({time_s(), walk_});
        }
      }
      cosimulation_->advance_millisecond();
      print_events();
    }
  }
  // When the next millisecond is due, of the monotonic clock.
  [[nodiscard]] std::int64_t next_ns() const { return start_ns_ + cosimulation_->now_ns() + kMillisecond_ns; }
  [[nodiscard]] double time_s() const { return static_cast<double>(cosimulation_->now_ns()) * 1e-9; }
  [[nodiscard]] bool fell() const { return cosimulation_->plant().fallen(); }
  [[nodiscard]] core::PluginManager& plugins() { return cosimulation_->plugins(); }
  [[nodiscard]] const std::string& plugin() const { return plugin_; }
  [[nodiscard]] double walked_m() const { return cosimulation_->plant().truth().base.translation().x(); }
  [[nodiscard]] core::PluginTiming timing() {
    for (const core::PluginTiming& timing : plugins().timings()) {
      if (timing.name == plugin_) {
        return timing;
      }
    }
    return {};
  }

 private:
  static constexpr std::int64_t kLongestGap_ns = 200 * kMillisecond_ns;

  // What the plug-in reports, and its faults.
  void print_events() {
    const core::EventLog& events = plugins().events();
    for (next_event_ = std::max(next_event_, events.first()); next_event_ < events.total(); ++next_event_) {
      const core::Event& event = events[next_event_];
      if (event.source() == plugin_) {
        fmt::print("  {:7.2f} s  {}: {}\n", static_cast<double>(event.stamp_ns) * 1e-9,
                   core::event_kind_name(event.kind), input::terminal_text(event.text()));
      }
    }
  }

  urdf::RobotModel model_;
  std::string plugin_;
  std::unique_ptr<simulator::Cosimulation> cosimulation_;
  simulator::WalkEvent walk_;
  bool commands_itself_ = false;
  bool walking_ = false;
  std::int64_t start_ns_ = 0;
  std::uint64_t next_event_ = 0;
};

// From a saved file to a verdict.
class Development {
 public:
  explicit Development(const DevOptions& options)
      : options_(options), build_(options.project, options.build), watch_(options.project, options.build) {}

  int run() {
    build_first();
    accepted_ = copy_of_newest();
    robot_ = std::make_unique<DevelopmentRobot>(accepted_, options_);
    fmt::print("The robot walks with it. Change the sources in {}; Ctrl-C ends.\n",
               options_.project.string());
    verdict_at_s_ = kStand_s + kVerdictAfter_s;
    const std::int64_t end_ns = process::monotonic_ns() + static_cast<std::int64_t>(options_.seconds * 1e9);
    process::stop_on_signals();
    while (!process::stop_requested() && (options_.seconds <= 0.0 || process::monotonic_ns() < end_ns)) {
      std::array<pollfd, 2> wakes{pollfd{watch_.wake_fd(), POLLIN, 0},
                                  pollfd{build_.running() ? build_.wake_fd() : -1, POLLIN, 0}};
      process::wait_until(robot_->next_ns(), wakes);
      robot_->catch_up();
      turn();
      std::fflush(stdout);
    }
    return kExitFine;
  }

 private:
  void build_first() {
    fmt::print("Building {} ...\n", options_.project.string());
    std::fflush(stdout);
    build_.start();
    if (!build_.take_result(true).value_or(false)) {
      throw std::runtime_error(
          fmt::format("{}\n{}: does not build; see above", build_.output(), options_.project.string()));
    }
  }

  // A build may replace, spoil or remove its own at any time.
  std::filesystem::path copy_of_newest() {
    const std::filesystem::path newest = build_.library();
    if (newest.empty()) {
      throw std::runtime_error(fmt::format(
          "{}: the build gave no plug-in library in {}. Does CMakeLists.txt call gaitway_plugin()?",
          options_.project.string(), options_.build.string()));
    }
    const std::filesystem::path folder = versions_.path() / std::to_string(++version_);
    std::filesystem::create_directory(folder);
    std::filesystem::copy_file(newest, folder / newest.filename());
    return folder / newest.filename();
  }

  void turn() {
    if (watch_.take_change()) {
      saved_ns_ = process::monotonic_ns();
      fmt::print("Saved; building ...\n");
      build_.start();
    }
    if (const auto built = build_.take_result()) {
      *built ? put_in_place([this] { return copy_of_newest(); })
             : complain("it does not build", build_.output());
    }
    if (auto result = robot_->plugins().changes().take_result()) {
      told(result->done, std::string(result->text));
    }
    if (robot_->fell()) {
      fmt::print("  FELL after {:.1f} s. It begins anew.\n", robot_->time_s());
      robot_ = std::make_unique<DevelopmentRobot>(accepted_, options_);
      verdict_at_s_ = kStand_s + kVerdictAfter_s;
      if (!candidate_.empty()) {
        put_in_place([this] { return std::exchange(candidate_, {}); });
      }
    } else if (verdict_at_s_ > 0.0 && robot_->time_s() >= verdict_at_s_) {
      verdict_at_s_ = 0.0;
      print_verdict();
    }
  }

  template <class Version>
  void put_in_place(const Version& version) {
    try {
      const std::filesystem::path library = version();
      robot_->plugins().changes().schedule(
          robot_->plugins().changes().prepare_reload(robot_->plugin(), library.string()));
      candidate_ = library;
    } catch (const std::exception& error) {
      complain("it cannot be loaded", error.what());
    }
  }
  static void complain(std::string_view what, std::string_view why) {
    fmt::print("  NOT CHANGED: {}; the robot walks on with the last version:\n{}\n", what,
               input::terminal_text(why));
  }
  void told(bool done, const std::string& text) {
    const std::filesystem::path version = std::exchange(candidate_, {});
    if (!done) {
      return complain("the new version was taken back", text);
    }
    accepted_ = version;
    fmt::print("  Live {:.1f} s after it was saved: {}\n",
               static_cast<double>(process::monotonic_ns() - saved_ns_) * 1e-9, text);
    verdict_at_s_ = robot_->time_s() + kVerdictAfter_s;
  }
  void print_verdict() {
    const core::PluginTiming timing = robot_->timing();
    fmt::print(
        "  {}: upright at {:.2f} m; step p50 {:.1f} us, p99 {:.1f} us, max {:.1f} us; {} of {} steps "
        "failed\n",
        timing.faults == 0 ? "GOOD" : "FAULTS", robot_->walked_m(), timing.step_us.p50, timing.step_us.p99,
        timing.step_us.max, timing.faults, timing.steps);
  }

  DevOptions options_;
  ProjectBuild build_;
  SourceWatch watch_;
  process::PrivateFolder versions_{"gaitway_dev"};
  unsigned version_ = 0;                        // copied last
  std::filesystem::path accepted_, candidate_;  // that it walks with; that is being put in place, or empty
  std::unique_ptr<DevelopmentRobot> robot_;
  double verdict_at_s_ = 0.0;  // 0: given
  std::int64_t saved_ns_ = 0;
};

int develop(const DevOptions& options) {
  DevOptions complete = options;
  complete.project = std::filesystem::canonical(options.project);
  complete.build =
      options.build.empty() ? complete.project / "build" : std::filesystem::absolute(options.build);
  if (!std::filesystem::exists(complete.project / "CMakeLists.txt")) {
    throw std::invalid_argument(
        fmt::format("{}: has no CMakeLists.txt. Is it a plug-in's project? Make one with "
                    "'gaitway new-plugin'",
                    complete.project.string()));
  }
  return Development(complete).run();
}

}  // namespace

void declare_program(const CommandLine& app) {
  const CommandLine command = add_command(app, "dev");
  DevOptions& options = command.runs(develop);
  command.option("project", options.project, "Folder with the plug-in's CMakeLists.txt")
      .required()
      .existing_folder();
  command.option("--build", options.build, "Build folder (default: build/ in the project)");
  command.option("--walk", options.walk, "Walk VX,VY,WZ: forward m/s, left m/s, turn rad/s").values(3);
  command.option("--seconds", options.seconds, "End after this time; 0: when it is interrupted")
      .between(0.0, 1e6);
  command.option("--in-process", options.in_process,
                 "Run the plug-in in this process: exact timing, but its crash ends all");
  command.footer(
      "Examples:\n"
      "  gaitway new-plugin sway && gaitway dev sway\n"
      "  gaitway dev sway --walk 0.1,0,0.2\n"
      "The robot walks in real time, with the plug-in in a process of its own: a crash or a hang is told, "
      "and\n"
      "the robot walks on. A version that does not build, load, or stand its first step leaves the one "
      "before\n"
      "it where it is.");
}

}  // namespace gaitway::tools
