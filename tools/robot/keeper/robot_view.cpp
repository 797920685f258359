// A client of the memory block like any other, that writes nothing.
#include "tools/robot/keeper/robot_view.hpp"

#include <chrono>
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
// It tells its state each time slot.
constexpr std::int64_t kFresh_ns = 5 * facts::kSlot_ns;
constexpr std::int64_t kFreshFeedback_ns = 10 * facts::kSlot_ns;

}  // namespace

struct RobotView::Block {
  explicit Block(const std::filesystem::path& socket)
      : client(msgclient::Client::connect(socket, "robot_keeper", kPatience)) {
    open(network, "network_state");
    open(joints, "joint_states");
    open(statistics, "plugin_statistics");
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

bool RobotView::may_be_commanded(std::int64_t now_ns) {
  const auto state = block_ ? block_->state(now_ns) : std::nullopt;
  JointStates joints{};
  const bool joints_answer = block_ && block_->joints && block_->joints->read(joints) &&
                             now_ns - joints.stamp_ns < kFreshFeedback_ns;
  return state && joints_answer && state->mode == network_state::mode::batches &&
         state->accepted_sequence >= state->cycle;
}

bool RobotView::holds(std::int64_t now_ns) {
  const auto state = block_ ? block_->state(now_ns) : std::nullopt;
  return state && state->mode >= network_state::mode::holding;
}

}  // namespace gaitway::tools
