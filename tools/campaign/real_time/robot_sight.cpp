// A client of the memory block like any other, that writes nothing.
#include "tools/campaign/real_time/robot_sight.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <fstream>
#include <utility>

#include "gaitway/facts/facts.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/process/real_time.hpp"

namespace gaitway::tools {
namespace {

using facts::kMillisecond_ns;

constexpr std::chrono::milliseconds kBlockPatience{50};
// As the supervisor judges it, which tells of it only ten times less often.
constexpr std::int64_t kFreshState_ns = 5 * facts::kSlot_ns, kFreshJoints_ns = 10 * facts::kSlot_ns;
constexpr std::int64_t kDeadBlock_ns = 50 * kMillisecond_ns;     // it beats each millisecond
constexpr std::int64_t kFreshReport_ns = 250 * kMillisecond_ns;  // the plug-in manager reports each 80 ms
constexpr std::int64_t kBetweenStatus_ns = 20 * kMillisecond_ns;
constexpr std::int64_t kOldStatus_ns = 1'000 * kMillisecond_ns;  // it is written five times a second

// By a signal: it makes no progress, before anybody has missed it.
bool is_stopped(pid_t process) {
  std::ifstream in(fmt::format("/proc/{}/stat", process));
  std::string text;
  std::getline(in, text);
  const std::size_t name_end = text.rfind(')');
  return name_end != std::string::npos && name_end + 2 < text.size() && text[name_end + 2] == 'T';
}

}  // namespace

bool parts_work(const RobotStatus& status, std::int64_t now_ns) {
  return now_ns - status.written_ns < kOldStatus_ns && status.all_work();
}

struct RobotEye::Block {
  explicit Block(const std::filesystem::path& socket)
      : client(msgclient::Client::connect(socket, "campaign", kBlockPatience)),
        network(client.read<NetworkState>("network_state")),
        joints(client.read<JointStates>("joint_states")),
        estimate(client.read<Estimate>("estimate")),
        imu(client.read<Imu>("imu")),
        walk(client.read<WalkCommand>("walk_command")),
        statistics(client.read<PluginStatistics>("plugin_statistics")) {}

  msgclient::Client client;
  msgclient::Reader<NetworkState> network;
  msgclient::Reader<JointStates> joints;
  msgclient::Reader<Estimate> estimate;
  msgclient::Reader<Imu> imu;
  msgclient::Reader<WalkCommand> walk;
  msgclient::Reader<PluginStatistics> statistics;
};

RobotEye::RobotEye(std::filesystem::path folder) : folder_(std::move(folder)) {}
RobotEye::~RobotEye() = default;

RobotSight RobotEye::look() {
  RobotSight sight;
  sight.at_ns = process::monotonic_ns();
  if (block_ && sight.at_ns - block_->client.heartbeat_ns() > kDeadBlock_ns &&
      block_->client.server_has_ended()) {
    block_.reset();
  }
  if (!block_) {
    try {
      block_ = std::make_unique<Block>(folder_ / "memory.sock");
    } catch (const std::exception&) {  // not yet there, or gone again
    }
    sight.at_ns = process::monotonic_ns();
  }
  if (block_) look_into_block(sight);
  if (sight.at_ns - status_read_ns_ >= kBetweenStatus_ns) {
    status_read_ns_ = sight.at_ns;
    if (auto status = read_status(folder_ / "status.json")) status_ = std::move(status);
    one_is_stopped_ = status_ && std::ranges::any_of(status_->parts, is_stopped, &PartStatus::worker);
  }
  if (status_) {
    sight.all_parts_work = sight.all_parts_work && parts_work(*status_, sight.at_ns);
    for (const PartStatus& part : status_->parts) sight.restarts += part.restarts;
    sight.all_parts_work = sight.all_parts_work && !one_is_stopped_;
    sight.lost_lines = status_->lost_lines;
    sight.told_ns = std::min(reported_ns_, status_->written_ns);
  }
  return sight;
}

void RobotEye::look_into_block(RobotSight& sight) {
  NetworkState network{};
  const bool is_told = static_cast<bool>(block_->network.read(network));
  if (is_told) {
    sight.counts = RobotSight::Counts{.late = network.late,
                                      .refused = network.refused,
                                      .tail_played = network.tail_played,
                                      .left_to_joints = network.left_to_joints,
                                      .stops = network.stops};
  }
  JointStates joints{};
  const bool joints_answer = block_->joints.read(joints) && sight.at_ns - joints.stamp_ns < kFreshJoints_ns;
  sight.is_commandable = is_told && joints_answer && sight.at_ns - network.stamp_ns < kFreshState_ns &&
                         network.mode == network_state::mode::batches &&
                         network.accepted_sequence >= network.cycle;
  WalkCommand walk{};
  if (block_->walk.read(walk) && walk.walk == 1 &&
      (walk.valid_until_ns == 0 || walk.valid_until_ns > sight.at_ns)) {
    sight.walk_order_ns = walk.stamp_ns;
  }
  Estimate estimate{};
  if (block_->estimate.read(estimate)) {
    sight.place = RobotSight::Place{estimate.stamp_ns, estimate.odometry_base[0], estimate.odometry_base[1]};
  }
  Imu imu{};
  if (block_->imu.read(imu)) {
    sight.lean_rad = std::max(std::abs(imu.inclination[0]), std::abs(imu.inclination[1]));
  }
  PluginStatistics plugins{};
  if (!block_->statistics.read(plugins)) return;
  const auto count = std::min<std::size_t>(plugins.plugin_count, kReportedPlugins);
  reported_ns_ = plugins.stamp_ns;
  sight.plugin_faults = 0;
  sight.all_parts_work = joints_answer && sight.at_ns - block_->client.heartbeat_ns() < kDeadBlock_ns &&
                         sight.at_ns - plugins.stamp_ns < kFreshReport_ns;
  for (std::size_t i = 0; i < count; ++i) {
    *sight.plugin_faults += plugins.faults[i];
    sight.all_parts_work = sight.all_parts_work && plugins.state[i] == 0;
  }
}

}  // namespace gaitway::tools
