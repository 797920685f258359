// The short way of a stop, from the message that arrives at the API to the last joint's frame, in virtual
// time: at random instants of the cycle, with a hundred clients that are subscribed to everything and say
// what they like.
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "gaitway/api/feed.hpp"
#include "gaitway/api/hub.hpp"
#include "gaitway/api/link_robot_port.hpp"
#include "gaitway/api/publication_sink.hpp"
#include "gaitway/can/profile.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/link/worst_case.hpp"
#include "gaitway/simulator/cosimulation.hpp"
#include "linked_robot.hpp"

namespace gaitway::api {
namespace {

using facts::kMillisecond_ns;

constexpr int kClients = 100;
constexpr std::int64_t kLimit_ns = 10 * kMillisecond_ns;  // published, from the module to the joints
// A stop of the walk is of all joints' trajectories, and takes those 10 ms from the desk on.
constexpr std::int64_t kI2cWalkLimit_ns = kLimit_ns + link::worst_stop_wait_ns(link::i2c_timing({}), {});

class QuietConnection final : public Connection {
 public:
  void wake() noexcept override {}
  void close(std::uint16_t, std::string_view) noexcept override { closed = true; }
  void shown_wrong_token() noexcept override {}
  bool closed = false;
};

// When each joint got a frame of one kind (or one for all), counted from an instant on.
class FrameWitness final : public simulator::CosimulationObserver {
 public:
  explicit FrameWitness(const urdf::RobotModel& robot) : robot_(robot) {}
  void begin(can::MessageKind kind) noexcept {
    kind_ = kind;
    arrived_.fill(false);
    last_ns_ = 0;
  }
  void on_frame(const can::SimulatedBus::Delivery& delivery) override {
    const auto message = can::kFullProfile.identify(delivery.frame.id);
    if (!message || message->kind != kind_) {
      return;
    }
    for (std::size_t joint = 0; joint < robot_.joints.size(); ++joint) {
      const bool meant = message->node == 0 || message->node == robot_.joints[joint].node;
      const bool received = delivery.received_by(1 + static_cast<int>(joint));  // 0 is the message controller
      if (meant && received && !arrived_[joint]) {
        arrived_[joint] = true;
        last_ns_ = delivery.end_ns;
      }
    }
  }
  void on_millisecond(std::int64_t) override {}
  [[nodiscard]] std::optional<std::int64_t> complete_ns() const {
    for (std::size_t joint = 0; joint < robot_.joints.size(); ++joint) {
      if (!arrived_[joint]) {
        return std::nullopt;
      }
    }
    return last_ns_;
  }

 private:
  const urdf::RobotModel& robot_;
  can::MessageKind kind_ = can::MessageKind::heartbeat;
  std::array<bool, kMaxJoints> arrived_{};
  std::int64_t last_ns_ = 0;
};

const urdf::RobotModel& humanoid() {
  static const urdf::RobotModel robot =
      urdf::load_robot(std::filesystem::path(GAITWAY_SOURCE_DIR) / "urdf" / "humanoid22");
  return robot;
}

simulator::CosimulationOptions options(std::uint64_t seed) {
  simulator::CosimulationOptions result;
  result.plant.seed = seed;
  result.people_outside = true;
  result.main_controller.configuration =
      std::filesystem::path(GAITWAY_SOURCE_DIR) / "core" / "config" / "walk.yaml";
  result.main_controller.plugin_path = {GAITWAY_PLUGIN_DIR};
  return result;
}

// The robot and everything of the API but sockets.
class WatchedRobot {
 public:
  WatchedRobot(std::uint64_t seed, test::Line line)
      : run_(humanoid(), options(seed)), witness_(humanoid()), linked_(run_.client(), humanoid(), line) {
    run_.observe(&witness_);
    for (int client = 0; client < kClients; ++client) {
      sessions_.push_back(hub_.open(connections_[static_cast<std::size_t>(client)], "test", true, wall_ns()));
      for (const TopicRow& topic : kTopics) {
        tell(client, R"({"op":"subscribe","queue_length":10,"topic":")" + std::string(topic.name) + R"("})");
      }
    }
  }

  void walk_for(std::int64_t duration_ns) {
    const std::int64_t end_ns = run_.now_ns() + duration_ns;
    while (run_.now_ns() < end_ns) {
      if (run_.now_ns() % (100 * kMillisecond_ns) == 0) {
        tell(0, R"({"op":"publish","topic":"/cmd_vel","msg":{"linear":{"x":0.15}}})");
      }
      millisecond();
    }
  }
  // From the arrival of `message`, `into_ns` after the last millisecond, to the last joint's frame of `kind`.
  std::int64_t response_ns(const std::string& message, can::MessageKind kind, std::int64_t into_ns) {
    const std::int64_t arrived_ns = run_.now_ns() - kMillisecond_ns + into_ns;
    tell(kClients / 2, message);
    linked_.exchange(wall_ns());  // it wakes the link's thread
    witness_.begin(kind);
    for (int ms = 0; ms < 50 && !witness_.complete_ns(); ++ms) {
      millisecond();
    }
    return witness_.complete_ns().value_or(arrived_ns + 1'000'000'000) - arrived_ns;
  }
  // Other clients say all sorts of things at once, just before.
  void babble(std::mt19937_64& random) {
    static constexpr std::array kSayings{
        R"({"op":"call_service","service":"/stop"})",
        R"({"op":"call_service","service":"/stand"})",
        R"({"op":"call_service","service":"/release"})",
        R"({"op":"call_service","service":"/command/acquire"})",
        R"({"op":"publish","topic":"/cmd_vel","msg":{"linear":{"x":0.3},"angular":{"z":1}}})",
        R"({"op":"call_service","service":"/move_joint","args":{"joint":"neck_yaw","position":0.1,"duration":0.5}})",
        R"({"op":"call_service","service":"/plugins/reload","args":{"plugin":"zmp"}})",
        R"({"op":"call_service","service":"/rosapi/topics"})",
        R"({"op":"advertise","topic":"/talk","type":"std_msgs/msg/String"})",
        R"({"op":"publish","topic":"/talk","msg":{"data":"hello"}})",
        R"({"op":)"};
    const int sayings = std::uniform_int_distribution(0, 200)(random);
    for (int saying = 0; saying < sayings; ++saying) {
      const int client = std::uniform_int_distribution(0, kClients / 2 - 1)(random);
      tell(client, kSayings[std::uniform_int_distribution<std::size_t>(0, kSayings.size() - 1)(random)]);
    }
  }
  [[nodiscard]] std::uint64_t frames() const noexcept { return frames_; }
  [[nodiscard]] msgcontroller::Mode mode() const { return run_.message_controller().mode(); }
  [[nodiscard]] bool fallen() const { return run_.plant().fallen(); }
  void millisecond() {
    run_.advance_millisecond();
    linked_.pass_millisecond(wall_ns() - kMillisecond_ns);
    port_.observe(wall_ns());
    GenericSink sink([this](Topic topic) { return hub_.wanted(topic); },
                     [this](Topic topic, const auto& value, std::int64_t) { hub_.publish(topic, value); });
    feed_.poll(wall_ns(), sink);
    hub_.step(wall_ns());
    for (const auto& session : sessions_) {
      while (session->next_frame(wall_ns())) {
        ++frames_;
      }
    }
  }

 private:
  [[nodiscard]] std::int64_t wall_ns() const { return run_.now_ns() + 1'000'000'000; }
  void tell(int client, const std::string& message) {
    sessions_[static_cast<std::size_t>(client)]->take(message, false, wall_ns());
  }

  simulator::Cosimulation run_;
  FrameWitness witness_;
  test::LinkedRobot linked_;
  LinkRobotPort port_{linked_.link, humanoid(), nullptr};
  msgclient::Client topics_ = linked_.link.topics("feed");
  Feed feed_{topics_, humanoid()};
  Hub hub_{port_, {}};
  std::array<QuietConnection, kClients> connections_;
  std::vector<std::unique_ptr<Session>> sessions_;
  std::uint64_t frames_ = 0;
};

struct Instant {
  std::mt19937_64& random;
  // After the robot has begun to walk, anywhere in a cycle.
  std::int64_t whole_ms() { return std::uniform_int_distribution<std::int64_t>(0, 79)(random); }
  std::int64_t into_ns() {
    return std::uniform_int_distribution<std::int64_t>(0, kMillisecond_ns - 1)(random);
  }
};

// What a carrier promises, and at least so many messages come over it for the clients.
struct Promise {
  test::Line line;
  std::int64_t walk_limit_ns;
  std::uint64_t least_frames;
};

class StopPath : public ::testing::TestWithParam<Promise> {};

TEST_P(StopPath, AnEmergencyStopIsOnEveryJointWithinTenMilliseconds) {
  std::mt19937_64 random(1);
  Instant instant{random};
  std::int64_t worst_ns = 0;
  for (int trial = 0; trial < GAITWAY_EMERGENCY_TRIALS; ++trial) {
    WatchedRobot robot(static_cast<std::uint64_t>(trial), GetParam().line);
    robot.walk_for((700 + instant.whole_ms()) * kMillisecond_ns);
    robot.babble(random);
    const std::string message = R"({"op":"call_service","service":"/emergency_stop","args":{"data":)" +
                                std::string(trial % 2 == 0 ? "false" : "true") + "}}";
    const std::int64_t response_ns =
        robot.response_ns(message, can::MessageKind::emergency_stop, instant.into_ns());
    ASSERT_LE(response_ns, kLimit_ns) << "trial " << trial;
    worst_ns = std::max(worst_ns, response_ns);
    ASSERT_EQ(robot.mode(), msgcontroller::Mode::emergency_stop);
    ASSERT_GT(robot.frames(), GetParam().least_frames) << "the hundred clients were served";
  }
  RecordProperty("worst_ns", std::to_string(worst_ns));
}

TEST_P(StopPath, AStopOfTheWalkIsWithEveryJointWithinTenMillisecondsAndWhatTheLinkTakes) {
  std::mt19937_64 random(2);
  Instant instant{random};
  std::int64_t worst_ns = 0;
  WatchedRobot robot(1, GetParam().line);
  robot.walk_for(1000 * kMillisecond_ns);
  for (int trial = 0; trial < GAITWAY_TRIALS; ++trial) {
    robot.walk_for((1600 + instant.whole_ms()) * kMillisecond_ns);
    ASSERT_EQ(robot.mode(), msgcontroller::Mode::batches) << "trial " << trial;
    const std::int64_t response_ns = robot.response_ns(R"({"op":"call_service","service":"/stop"})",
                                                       can::MessageKind::trajectory, instant.into_ns());
    ASSERT_LE(response_ns, GetParam().walk_limit_ns) << "trial " << trial;
    worst_ns = std::max(worst_ns, response_ns);
    // Until it stands and the lease of who drove has run out.
    for (int ms = 0; ms < 3000; ++ms) {
      robot.millisecond();
    }
    ASSERT_FALSE(robot.fallen()) << "trial " << trial;
  }
  RecordProperty("worst_ns", std::to_string(worst_ns));
}

INSTANTIATE_TEST_SUITE_P(Socket, StopPath, ::testing::Values(Promise{test::Line::socket, kLimit_ns, 50'000}));
INSTANTIATE_TEST_SUITE_P(I2c, StopPath,
                         ::testing::Values(Promise{test::Line::i2c, kI2cWalkLimit_ns, 15'000}));

}  // namespace
}  // namespace gaitway::api
