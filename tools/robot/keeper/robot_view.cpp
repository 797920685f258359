// A client of the memory block like any other, that writes nothing.
#include "tools/robot/keeper/robot_view.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstring>
#include <exception>
#include <string>
#include <utility>

#include "gaitway/facts/facts.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/msgclient/topics.hpp"

namespace gaitway::tools {
namespace {

// A message controller answers within milliseconds, or is not there.
constexpr std::chrono::milliseconds kPatience{50};
// It beats each millisecond; a busy computer was seen to keep it from that for 23 ms.
constexpr std::int64_t kBeats_ns = 25 * facts::kMillisecond_ns;
constexpr std::uint32_t kBusOff = 2;  // or down
// It tells its state each time slot.
constexpr std::int64_t kFresh_ns = 5 * facts::kSlot_ns;
constexpr std::int64_t kFreshFeedback_ns = 10 * facts::kSlot_ns;

std::int64_t milliseconds(std::int64_t duration_ns) {
  return duration_ns / facts::kMillisecond_ns;
}

// Of what plays: empty, the batches of the main controller.
std::string why_not_played(const NetworkState& state) {
  switch (state.mode) {
    case network_state::mode::batches:
      return state.accepted_sequence >= state.cycle ? "" : "the main controller's batch has not come in time";
    case network_state::mode::safe_tail:
      return "the robot finishes its step without the main controller";
    case network_state::mode::holding:
      return state.accepted_sequence == 0 ? "it has just been started: no batch of the main controller yet"
                                          : "the robot stands and waits for the main controller's next batch";
    default:
      return "an emergency stop is in force: 'gaitway ctl release' ends it";
  }
}

}  // namespace

struct RobotView::Block {
  explicit Block(const std::filesystem::path& socket)
      : client(msgclient::Client::connect(socket, "robot_keeper", kPatience)) {
    open(network, "network_state");
    open(joints, "joint_states");
    open(statistics, "plugin_statistics");
    open(command, "command_state");
    open(health, "network_health");
  }
  // A program of another release is watched by its heartbeat all the same.
  template <class T>
  void open(std::optional<msgclient::Reader<T>>& reader, const char* topic) {
    try {
      reader.emplace(client.read<T>(topic));
    } catch (const msgclient::TopicError& error) {
      complaint = error.what();
    }
  }

  // Nothing: it is not told any more.
  std::optional<NetworkState> state(std::int64_t now_ns) {
    NetworkState state{};
    const bool fresh = network && network->read(state) && now_ns - state.stamp_ns < kFresh_ns;
    return fresh ? std::optional(state) : std::nullopt;
  }

  msgclient::Client client;
  std::optional<msgclient::Reader<NetworkState>> network;
  std::optional<msgclient::Reader<JointStates>> joints;
  std::optional<msgclient::Reader<PluginStatistics>> statistics;
  std::optional<msgclient::Reader<CommandState>> command;
  std::optional<msgclient::Reader<NetworkHealth>> health;
  std::string complaint;
};

RobotView::RobotView(std::filesystem::path memory_socket) : socket_(std::move(memory_socket)) {}
RobotView::~RobotView() = default;

bool RobotView::look() {
  if (!block_) {
    try {
      block_ = std::make_unique<Block>(socket_);
    } catch (const std::exception&) {
      return false;  // not yet there, or gone again
    }
  }
  return true;
}

void RobotView::forget() {
  block_.reset();
}

std::string RobotView::take_complaint() {
  return block_ ? std::exchange(block_->complaint, {}) : std::string();
}

std::optional<std::uint64_t> RobotView::message_controller_beats() const {
  if (!block_) return std::nullopt;
  return static_cast<std::uint64_t>(block_->client.heartbeat_ns());
}

std::optional<std::uint64_t> RobotView::main_controller_reports() {
  if (!block_ || !block_->statistics) return std::nullopt;
  return block_->statistics->newest_sequence();
}

std::optional<std::uint64_t> RobotView::joint_feedback() {
  JointStates states{};
  if (!block_ || !block_->joints || !block_->joints->read(states)) return std::nullopt;
  return static_cast<std::uint64_t>(states.stamp_ns);
}

// Of the joints: empty, they answer.
std::string RobotView::why_no_feedback(std::int64_t now_ns) {
  JointStates joints{};
  if (!block_->joints || !block_->joints->read(joints)) return "no joint has answered yet: is its power on?";
  const std::int64_t age_ns = now_ns - joints.stamp_ns;
  if (age_ns < kFreshFeedback_ns) return {};
  NetworkHealth health{};
  const bool is_off = block_->health && block_->health->read(health) && health.bus_state >= kBusOff;
  return fmt::format("the joints have not answered for {} ms: {}", milliseconds(age_ns),
                     is_off ? "the bus is gone" : "is their power on?");
}

std::string RobotView::why_not_commanded(std::int64_t now_ns) {
  if (!block_) return "its message controller is not there";
  if (const std::int64_t age_ns = now_ns - block_->client.heartbeat_ns(); age_ns >= kBeats_ns) {
    return fmt::format("its message controller has been silent for {} ms", milliseconds(age_ns));
  }
  const auto state = block_->state(now_ns);
  if (!state)
    return "its message controller does not tell what it does: the bus is away, or it has just begun";
  if (state->mode == network_state::mode::emergency_stop) return why_not_played(*state);
  std::string why = why_no_feedback(now_ns);
  return why.empty() ? why_not_played(*state) : why;
}

std::string RobotView::who_commands(std::int64_t now_ns) {
  CommandState state{};
  if (!block_ || !block_->command || !block_->command->read(state)) return {};
  const auto* const text = reinterpret_cast<const char*>(state.text);
  return fmt::format("{}, for {:.1f} s", std::string(text, strnlen(text, sizeof state.text)),
                     static_cast<double>(now_ns - state.since_ns) * 1e-9);
}

bool RobotView::holds(std::int64_t now_ns) {
  const auto state = block_ ? block_->state(now_ns) : std::nullopt;
  return state && state->mode >= network_state::mode::holding;
}

}  // namespace gaitway::tools
