// Outages in real time: a robot walks at 0.2 m/s, one of its processes is killed, or stopped for five
// seconds, at a random instant of a step, and comes back. Did the robot fall, and when may it be commanded
// again, which is when the message controller accepts batches?
//
// GAITWAY_OUTAGES: how many trials of each fault (1). GAITWAY_OUTAGE_SEED: their first seed (1).
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>

#include "gaitway/msgclient/client.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "running_process.hpp"

namespace gaitway::scenarios {
namespace {

const std::string kRobot = std::string(GAITWAY_SOURCE_DIR) + "/urdf/humanoid22";
const std::string kConfig = std::string(GAITWAY_SOURCE_DIR) + "/core/config/walk.yaml";
constexpr auto kStop = 5s;
constexpr auto kAfterwards = 4s;  // the longest tail lasts two
constexpr double kStepPair_s = 1.28;

enum class Fault : std::uint8_t {
  message_killed,
  message_stopped,
  main_killed,
  main_stopped,
  robot_stopped,  // and with it its bus: for the message controller the bus stands still
};

struct FaultKind {
  Fault fault;
  const char* name;
  double back_within_s, accepted_within_s;  // of the fault, or of its end
};
constexpr double kLongestTail_s = 2.0;
constexpr std::array kFaults{
    FaultKind{Fault::message_killed, "message_controller_killed", 1.0, 1.0},
    FaultKind{Fault::message_stopped, "message_controller_stopped_5_s", 1.0, 1.0 + kLongestTail_s},
    FaultKind{Fault::main_killed, "main_controller_killed", 0.5, 0.5 + kLongestTail_s},
    FaultKind{Fault::main_stopped, "main_controller_stopped_5_s", 1.5, 1.5 + kLongestTail_s},
    FaultKind{Fault::robot_stopped, "bus_stands_still_5_s", 3.0, 3.0 + kLongestTail_s}};

int number(const char* variable, int otherwise) {
  const char* const text = std::getenv(variable);
  return text == nullptr ? otherwise : std::atoi(text);
}

// What the message controller says of itself, whichever it is by now.
class NetworkWatch {
 public:
  explicit NetworkWatch(std::filesystem::path socket) : socket_(std::move(socket)) {}

  // The newest batch that has been accepted; 0: none, or there is no message controller, or it has no bus.
  std::uint32_t accepted() {
    NetworkState state{};
    NetworkHealth health{};
    const bool told = look() && network_->read(state) && health_->read(health);
    if (told && state.mode != mode_ && std::getenv("GAITWAY_OUTAGE_OUTPUT") != nullptr) {
      fmt::print("at {:.3f} s: mode {}, accepted {}\n", 1e-9 * static_cast<double>(state.stamp_ns),
                 state.mode, state.accepted_sequence);
    }
    mode_ = told ? state.mode : mode_;
    return told && health.bus_state < 2 ? state.accepted_sequence : 0;
  }
  // Times that a main controller has told of its plug-ins, every 80 ms.
  std::uint64_t told() { return look() ? plugins_->newest_sequence() : 0; }

 private:
  bool look() {
    if (client_ && client_->server_has_ended()) {
      leave();
    }
    try {
      if (!client_) {
        client_.emplace(msgclient::Client::connect(socket_, "watch", 100ms));
        network_.emplace(client_->read<NetworkState>("network_state"));
        health_.emplace(client_->read<NetworkHealth>("network_health"));
        plugins_.emplace(client_->read<PluginStatistics>("plugin_statistics"));
      }
      return true;
    } catch (const msgclient::TopicError&) {
      leave();
      return false;
    }
  }
  void leave() {
    network_.reset();
    health_.reset();
    plugins_.reset();
    client_.reset();
  }

  std::filesystem::path socket_;
  std::optional<msgclient::Client> client_;
  std::optional<msgclient::Reader<NetworkState>> network_;
  std::optional<msgclient::Reader<NetworkHealth>> health_;
  std::optional<msgclient::Reader<PluginStatistics>> plugins_;
  std::uint32_t mode_ = 0;
};

// The worker below a supervised main controller; 0: none at the moment.
pid_t worker_of(pid_t supervisor) {
  std::ifstream children(fmt::format("/proc/{0}/task/{0}/children", supervisor));
  pid_t child = 0;
  children >> child;
  return child;
}

struct Outcome {
  bool walked = false;
  bool fell = true;
  double back_s = -1.0, accepted_s = -1.0;  // after the fault, or after the end of a stop; -1: not any more
  int missing = 0;                          // processes that did not end well
};

class Trial {
 public:
  explicit Trial(std::uint64_t seed) : seed_(seed), random_(seed) {
    std::string name = (std::filesystem::temp_directory_path() / "gaitway_outage_XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;
  ~Trial() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  Outcome run(Fault fault) {
    start();
    NetworkWatch watch(path("memory"));
    Outcome outcome;
    outcome.walked = until(20s, [&] { return watch.accepted() > 0; });
    std::this_thread::sleep_for(3s + instant());  // it walks from a second and a half on
    const Mark mark = inflict(fault, watch);
    outcome.back_s = mark.seconds_until([&] { return watch.told() > mark.told; });
    outcome.accepted_s = mark.seconds_until([&] { return watch.accepted() > mark.accepted; });
    std::this_thread::sleep_for(kAfterwards);
    for (const auto& process : {main_.get(), message_.get(), robot_.get()}) {
      outcome.missing += process->stop() == 0 ? 0 : 1;
    }
    const auto summary = nlohmann::json::parse(text_of(folder_ / "robot.json"), nullptr, false);
    outcome.fell = !summary.is_object() || summary.value("fell", true);
    outcome.walked = outcome.walked && summary.is_object() && summary.value("distance_m", 0.0) > 0.1;
    return outcome;
  }
  [[nodiscard]] std::string everything() const {
    std::string all;
    for (const char* file : {"robot.txt", "robot.json", "message.txt", "again.txt", "main.txt"}) {
      all += std::string("\n--- ") + file + "\n" + text_of(folder_ / file);
    }
    return all;
  }

 private:
  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
  // Where the time begins, and what had been seen until then.
  struct Mark {
    Clock::time_point at;
    std::uint64_t told = 0;
    std::uint32_t accepted = 0;

    [[nodiscard]] double seconds_until(const std::function<bool()>& done) const {
      return until(20s, done) ? std::chrono::duration<double>(Clock::now() - at).count() : -1.0;
    }
  };
  // Anywhere in a left and a right step.
  Clock::duration instant() {
    const double phase_s = std::uniform_real_distribution<double>(0.0, kStepPair_s)(random_);
    return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(phase_s));
  }
  void start() {
    robot_ = std::make_unique<Process>(
        GAITWAY_VIRTUAL_ROBOT, folder_ / "robot.txt",
        std::vector<std::string>{"--robot", kRobot, "--bus", path("bus"), "--summary", path("robot.json"),
                                 "--seed", std::to_string(seed_)});
    EXPECT_TRUE(until(20s, [&] { return std::filesystem::exists(path("bus")); })) << robot_->output();
    message_ = message_controller("message.txt", {"--walk", "0.2,0,0", "--walk-after", "1.5"});
    EXPECT_TRUE(until(20s, [&] { return std::filesystem::exists(path("memory")); })) << message_->output();
    main_ = std::make_unique<Process>(
        GAITWAY_MAIN_CONTROLLER, folder_ / "main.txt",
        std::vector<std::string>{"--supervised", "--socket", path("memory"), "--robot", kRobot, "--config",
                                 kConfig, "--plugin-path", GAITWAY_PLUGIN_DIR});
  }
  std::unique_ptr<Process> message_controller(const char* output, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{
        "--robot",  kRobot,         "--bus",     path("bus"),
        "--memory", path("memory"), "--summary", path(std::string(output) + ".json")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return std::make_unique<Process>(GAITWAY_MESSAGE_CONTROLLER, folder_ / output, arguments);
  }
  // The time counts from the fault, or from the end of a stop; of one that ends the process, from the fault.
  Mark inflict(Fault fault, NetworkWatch& watch) {
    switch (fault) {
      case Fault::message_killed: {
        const Clock::time_point now = Clock::now();
        message_->send(SIGKILL);
        message_->wait();
        message_ =
            message_controller("again.txt", {});  // at once, as who watches it does; nobody orders a walk
        return {now};
      }
      case Fault::main_killed:
        return send_to_worker(SIGKILL, watch);
      case Fault::main_stopped:
        return send_to_worker(SIGSTOP, watch);
      case Fault::message_stopped:
        return stop_and_go_on(*message_, watch);
      case Fault::robot_stopped:
        return stop_and_go_on(*robot_, watch);
    }
    return {};
  }
  Mark send_to_worker(int signal, NetworkWatch& watch) {
    const Clock::time_point now = Clock::now();
    kill(worker_of(main_->id()), signal);
    return {now, watch.told() + 1, watch.accepted() + 1};  // one of each may have been on its way
  }
  static Mark stop_and_go_on(const Process& process, NetworkWatch& watch) {
    process.send(SIGSTOP);
    std::this_thread::sleep_for(kStop);
    Mark mark{{}, watch.told(), watch.accepted()};
    process.send(SIGCONT);
    mark.at = Clock::now();
    return mark;
  }

  std::uint64_t seed_;
  std::mt19937_64 random_;
  std::filesystem::path folder_;
  std::unique_ptr<Process> robot_, message_, main_;
};

class Outage : public testing::TestWithParam<FaultKind> {};

std::string distribution(std::vector<double> seconds) {
  std::ranges::sort(seconds);
  return fmt::format("{:.3f} s (median), {:.3f} s (longest)", seconds[seconds.size() / 2], seconds.back());
}

TEST_P(Outage, IsOutlastedWithoutAFall) {
  const FaultKind& kind = GetParam();
  const int trials = number("GAITWAY_OUTAGES", 1), first = number("GAITWAY_OUTAGE_SEED", 1);
  int falls = 0;
  std::vector<double> back_s, accepted_s;
  for (int trial = first; trial < first + trials; ++trial) {
    SCOPED_TRACE(fmt::format("seed {}", trial));
    Trial robot(static_cast<std::uint64_t>(trial));
    const Outcome outcome = robot.run(kind.fault);
    EXPECT_TRUE(outcome.walked) << robot.everything();
    EXPECT_FALSE(outcome.fell) << robot.everything();
    EXPECT_EQ(outcome.missing, 0) << robot.everything();
    EXPECT_TRUE(0.0 <= outcome.back_s && outcome.back_s <= kind.back_within_s) << outcome.back_s << " s\n"
                                                                               << robot.everything();
    EXPECT_TRUE(0.0 <= outcome.accepted_s && outcome.accepted_s <= kind.accepted_within_s)
        << outcome.accepted_s << " s\n"
        << robot.everything();
    if (std::getenv("GAITWAY_OUTAGE_OUTPUT") != nullptr) {
      fmt::print("{}\n", robot.everything());
    }
    falls += outcome.fell ? 1 : 0;
    back_s.push_back(outcome.back_s);
    accepted_s.push_back(outcome.accepted_s);
    fmt::print("{:<32} seed {:>3}: {}, back after {:.3f} s, batches accepted after {:.3f} s\n", kind.name,
               trial, outcome.fell ? "fell" : "stands", outcome.back_s, outcome.accepted_s);
    std::fflush(stdout);
  }
  fmt::print("{:<32} {} of {} fell; back after {}; batches accepted after {}\n", kind.name, falls, trials,
             distribution(back_s), distribution(accepted_s));
  RecordProperty("falls", falls);
}

INSTANTIATE_TEST_SUITE_P(Each, Outage, testing::ValuesIn(kFaults),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace gaitway::scenarios
