// A command's way from its arrival at the module to the last joint's frame, stage by stage, in virtual time:
// each stage keeps what is proven of it, and all together what is published. GAITWAY_FIGURES names a file for
// what was measured (bench/userinterface/server/command_path.py makes a table of it).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numeric>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "gaitway/api/link_robot_port.hpp"
#include "gaitway/can/analysis/network_messages.hpp"
#include "gaitway/can/profile.hpp"
#include "gaitway/contract/order_table.hpp"
#include "gaitway/contract/topic_codec.hpp"
#include "gaitway/link/worst_case.hpp"
#include "gaitway/simulator/cosimulation.hpp"
#include "linked_robot.hpp"
#include "simulation.hpp"
#include "test_client.hpp"

namespace gaitway::api {
namespace {

constexpr std::int64_t kPublishedLimit_ns = 10 * kMillisecond_ns;  // from the module to the joints

constexpr int kTrialsOfFigures = 300;

enum class Command : std::uint8_t { emergency_stop, move_joint };

enum Stage : std::size_t {
  kLink,    // the module has what its client says; until the other end of the link has all of it
  kDesk,    // the plug-in api writes it into the memory block
  kIntake,  // the message controller looks at what there is, and offers its frame
  kBus,     // until every joint that is meant has that
  kStages
};
constexpr std::array<std::string_view, kStages> kStageNames{"link", "desk", "intake", "bus"};
using StageTimes = std::array<std::int64_t, kStages>;  // ns

std::int64_t sum(const StageTimes& stages) {
  return std::accumulate(stages.begin(), stages.end(), std::int64_t{0});
}

std::size_t user_command_bytes(std::size_t joints) {
  const contract::TopicCodec codec{.joint_count = joints, .exact = true};
  const UserCommand command{};
  std::array<std::uint8_t, link::kMostOrderBytes> room{};
  return contract::kStopsSeenBytes + codec.encode(TopicType<UserCommand>::descriptor, &command, room);
}

// While no other command is under way. The plug-in's thread and the message controller look once a
// millisecond; the former is woken before that unless it is flooded.
StageTimes worst_stages(const urdf::RobotModel& robot, test::Line line, Command command) {
  const link::CarrierTiming carrier = line == test::Line::i2c ? link::i2c_timing({}) : link::unix_timing();
  std::vector<can::NodeId> nodes;
  for (const urdf::Joint& joint : robot.joints) nodes.push_back(joint.node);
  const bool stop = command == Command::emergency_stop;
  const auto bus_ns =
      can::prove(can::kFullProfile, nodes)
          .worst_response_ns(stop ? can::MessageKind::emergency_stop : can::MessageKind::user_command);
  return {stop ? link::worst_stop_wait_ns(carrier, {})
               : link::worst_lone_order_wait_ns(carrier, {}, user_command_bytes(robot.joints.size())),
          kMillisecond_ns, kMillisecond_ns, bus_ns.value()};
}

// When the last joint that is meant has a frame of one kind.
class FrameWitness final : public simulator::CosimulationObserver {
 public:
  explicit FrameWitness(const urdf::RobotModel& robot) : robot_(robot) {}
  void begin(can::MessageKind kind) noexcept {
    kind_ = kind;
    arrived_ns_.reset();
  }
  void on_frame(const can::SimulatedBus::Delivery& delivery) override {
    const auto message = can::kFullProfile.identify(delivery.frame.id);
    if (!message || message->kind != kind_ || arrived_ns_) return;
    const auto command = can::decode_user_command(can::kFullProfile, delivery.frame);
    for (std::size_t joint = 0; joint < robot_.joints.size(); ++joint) {
      const bool meant = !command || command->node == robot_.joints[joint].node;
      if (meant && !delivery.received_by(1 + static_cast<int>(joint))) return;
    }
    arrived_ns_ = delivery.end_ns;
  }
  void on_millisecond(std::int64_t /*now_ns*/) override {}
  [[nodiscard]] std::optional<std::int64_t> arrived_ns() const noexcept { return arrived_ns_; }

 private:
  const urdf::RobotModel& robot_;
  can::MessageKind kind_ = can::MessageKind::heartbeat;
  std::optional<std::int64_t> arrived_ns_;
};

// A robot that stands, and its module but for the sockets. Instants are the robot's.
class CommandedRobot {
 public:
  explicit CommandedRobot(test::Line line) : linked_(run_.client(), robot_, line) {
    run_.observe(&witness_);
    run_for(1000);
  }

  // Of one command, which arrives in the millisecond that begins now.
  std::optional<StageTimes> stages_of(Command command, std::int64_t into_ns) {
    const bool stop = command == Command::emergency_stop;
    witness_.begin(stop ? can::MessageKind::emergency_stop : can::MessageKind::user_command);
    const link::StopCounts asked = linked_.desk.end().stops_asked();
    const std::uint32_t fetched = linked_.desk.end().fetched_orders();
    const std::uint64_t obeyed = stop_answers_.newest_sequence();
    std::int64_t arrived_ns = 0;
    std::optional<std::int64_t> heard_ns, offered_ns;
    linked_.exchanged = [&](std::int64_t at_ns) {
      const link::ControllerEnd& end = linked_.desk.end();
      if (!heard_ns && (stop ? end.stops_asked() != asked : end.fetched_orders() != fetched)) {
        heard_ns = at_ns - kAhead_ns;
      }
    };
    const auto say = [&](std::int64_t at_ns) {
      arrived_ns = at_ns - kAhead_ns;
      now_ns_ = at_ns;
      port_.observe(now_ns_);
      client_.send({{"op", "call_service"},
                    {"service", stop ? "/emergency_stop" : "/move_joint"},
                    {"args", stop ? json{{"data", false}} : next_movement()}});
    };
    millisecond(into_ns, say);
    for (int ms = 0; ms < 50 && !witness_.arrived_ns(); ++ms) {
      UserCommandAnswer answer;
      millisecond();
      if (!offered_ns &&
          (stop ? stop_answers_.newest_sequence() != obeyed : bool{command_answers_.read(answer)})) {
        offered_ns = run_.now_ns() - kMillisecond_ns;
      }
    }
    linked_.exchanged = {};
    if (!witness_.arrived_ns() || !offered_ns || !heard_ns) return std::nullopt;
    // The plug-in writes as soon as it has heard.
    return StageTimes{*heard_ns - arrived_ns, 0, *offered_ns - *heard_ns,
                      *witness_.arrived_ns() - *offered_ns};
  }
  // Until another command can be given.
  void recover(Command command, std::int64_t pause_ms) {
    if (command == Command::emergency_stop) {
      run_for(100);
      client_.send({{"op", "call_service"}, {"service", "/release"}});
      run_for(1500);
    }
    run_for(200 + pause_ms);
    UserCommandAnswer answer;
    while (command_answers_.read(answer)) {
    }
  }
  [[nodiscard]] const urdf::RobotModel& robot() const noexcept { return robot_; }

 private:
  static constexpr std::int64_t kAhead_ns = kSecond_ns;  // of the module's clock before the robot's

  json next_movement() {
    position_ = position_ == 0.0 ? 0.02 : 0.0;
    return {{"joint", "neck_yaw"}, {"position", position_}, {"duration", 0.02}};
  }
  void run_for(std::int64_t duration_ms) {
    for (std::int64_t ms = 0; ms < duration_ms; ++ms) millisecond();
  }
  void millisecond(std::int64_t into_ns = 0, const std::function<void(std::int64_t)>& say = {}) {
    run_.advance_millisecond();
    linked_.pass_millisecond(run_.now_ns() + kAhead_ns - kMillisecond_ns, into_ns, say);
    now_ns_ = run_.now_ns() + kAhead_ns;
    port_.observe(now_ns_);
    hub_.step(now_ns_);
    client_.receive();
  }

  const urdf::RobotModel robot_ =
      urdf::load_robot(std::filesystem::path(GAITWAY_SOURCE_DIR) / "urdf" / "humanoid22");
  simulator::Cosimulation run_{robot_, served_walk()};
  FrameWitness witness_{robot_};
  test::LinkedRobot linked_;
  LinkRobotPort port_{linked_.link, robot_, nullptr};
  Hub hub_{port_, {}};
  std::int64_t now_ns_ = kAhead_ns;
  TestClient client_{hub_, now_ns_, "who commands"};
  msgclient::Reader<StopRequest> stop_answers_ = run_.client().read<StopRequest>("stop_answer");
  msgclient::StreamReader<UserCommandAnswer> command_answers_ =
      run_.client().read_stream<UserCommandAnswer>("user_command_answer");
  double position_ = 0.0;
};

std::int64_t share(std::vector<std::int64_t> values, double part) {
  std::ranges::sort(values);
  return values[std::min(values.size() - 1,
                         static_cast<std::size_t>(part * static_cast<double>(values.size())))];
}

class CommandPath : public testing::TestWithParam<std::tuple<test::Line, Command>> {};

TEST_P(CommandPath, EachStageKeepsItsWorstCaseAndAllTogetherTheLimit) {
  const auto [line, command] = GetParam();
  std::mt19937_64 random(5);
  CommandedRobot robot(line);
  const StageTimes worst = worst_stages(robot.robot(), line, command);
  EXPECT_LE(sum(worst), kPublishedLimit_ns);
  std::array<std::vector<std::int64_t>, kStages + 1> measured;
  const char* const file = std::getenv("GAITWAY_FIGURES");
  const int trials = file == nullptr ? GAITWAY_TRIALS : kTrialsOfFigures;
  for (int trial = 0; trial < trials; ++trial) {
    const auto stages =
        robot.stages_of(command, std::uniform_int_distribution<std::int64_t>(1, kMillisecond_ns - 1)(random));
    ASSERT_TRUE(stages) << "trial " << trial;
    for (std::size_t stage = 0; stage < kStages; ++stage) {
      ASSERT_LE((*stages)[stage], worst[stage]) << kStageNames[stage] << ", trial " << trial;
      measured[stage].push_back((*stages)[stage]);
    }
    measured[kStages].push_back(sum(*stages));
    robot.recover(command, std::uniform_int_distribution<std::int64_t>(0, 79)(random));
  }
  const std::string what = std::string(line == test::Line::i2c ? "i2c" : "socket") +
                           (command == Command::emergency_stop ? " emergency_stop " : " move_joint ");
  std::ofstream figures(file == nullptr ? "/dev/null" : file, std::ios::app);
  for (std::size_t stage = 0; stage <= kStages; ++stage) {
    figures << what << (stage < kStages ? kStageNames[stage] : "sum") << ' '
            << (stage < kStages ? worst[stage] : sum(worst));
    for (const double part : {0.5, 0.99, 1.0}) figures << ' ' << share(measured[stage], part);
    figures << ' ' << measured[stage].size() << '\n';
  }
  RecordProperty("most_us", static_cast<int>(share(measured[kStages], 1.0) / 1000));
  RecordProperty("worst_us", static_cast<int>(sum(worst) / 1000));
}

INSTANTIATE_TEST_SUITE_P(All, CommandPath,
                         testing::Combine(testing::Values(test::Line::i2c, test::Line::socket),
                                          testing::Values(Command::emergency_stop, Command::move_joint)));

}  // namespace
}  // namespace gaitway::api
