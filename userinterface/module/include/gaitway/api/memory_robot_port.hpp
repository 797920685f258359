// The robot as the API reaches it: requests into its own topics of the memory block, answers out of others'.
#pragma once

#include <deque>
#include <set>
#include <vector>

#include "gaitway/api/robot_port.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::api {

class Recorder;

// Writes `walk_request`, `stop_request`, `motion_request` and the queues `user_command` and
// `api_plugin_request`. For one thread.
class MemoryRobotPort final : public RobotPort {
 public:
  // Opens the topics: throws msgclient::TopicError. All references outlive it. `recorder`: nullptr: recording
  // is refused.
  MemoryRobotPort(msgclient::Client& client, const urdf::RobotModel& robot, Recorder* recorder);

  // Tells it the time, to know whether the message controller is alive.
  void observe(std::int64_t wall_ns) noexcept;

  [[nodiscard]] std::int64_t now_ns() const override;
  [[nodiscard]] bool connected() const override { return connected_; }
  [[nodiscard]] bool emergency_stopped() const override;
  void walk(const Velocity& velocity, std::int64_t valid_ns) override;
  void stand() override;
  std::optional<std::uint32_t> stop() override;
  std::optional<std::uint32_t> emergency_stop(bool soft) override;
  std::optional<std::uint32_t> release() override;
  std::optional<std::uint32_t> move_joint(int joint, double position_rad, double duration_s) override;
  std::optional<std::uint32_t> play_motion(std::string_view name) override;
  std::optional<std::uint32_t> order(const PluginOrder& order) override;
  std::optional<OrderResult> take_result() override;
  [[nodiscard]] const std::vector<JointLimits>& joints() const override { return joints_; }
  [[nodiscard]] std::vector<PluginStatus> plugins() const override;
  std::uint32_t start_recording(std::string_view name) override;
  std::uint32_t stop_recording() override;
  std::uint32_t list_recordings(std::size_t most) override;

 private:
  [[nodiscard]] Recorder& recorder() const;
  // Stops that wait for their answer: the count of their kind that `stop_answer` must have reached.
  struct AwaitedStop {
    std::uint32_t number;
    std::uint32_t StopRequest::*kind;
    std::uint32_t count;
  };
  std::uint32_t next_number() noexcept;
  std::uint32_t ask(std::uint32_t StopRequest::*kind);
  std::optional<std::uint32_t> push(UserCommand command);
  void collect();
  std::optional<OrderResult> take_motion_answer();

  msgclient::Client& client_;
  Recorder* recorder_;
  std::vector<JointLimits> joints_;
  msgclient::Writer<WalkCommand> walk_requests_;
  msgclient::Writer<StopRequest> stop_requests_;
  msgclient::Reader<StopRequest> stop_answers_;
  msgclient::QueueWriter<UserCommand> commands_;
  msgclient::StreamReader<UserCommandAnswer> command_answers_;
  msgclient::QueueWriter<PluginRequest> orders_;
  msgclient::StreamReader<PluginAnswer> order_answers_;
  mutable msgclient::Reader<PluginStatistics> statistics_;
  mutable msgclient::Reader<NetworkState> network_;
  msgclient::Writer<MotionRequest> motion_requests_;
  msgclient::Reader<MotionState> motion_states_;
  std::uint32_t last_number_;
  StopRequest stops_asked_{};
  std::deque<AwaitedStop> stops_awaited_;      // oldest first
  std::set<std::uint32_t> awaited_;            // numbers of the orders that have no answer yet
  std::deque<OrderResult> results_;            // that nobody has taken yet
  std::deque<std::uint32_t> motions_awaited_;  // likewise; the newest alone is answered by the robot
  std::uint64_t motion_state_seen_ = 0;
  std::int64_t heartbeat_ns_ = 0;
  std::int64_t heard_ns_ = 0;  // by the wall clock
  bool connected_ = false;
};

}  // namespace gaitway::api
