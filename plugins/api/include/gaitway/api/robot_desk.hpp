// The robot's side of the robot API, behind the narrow link: orders in, answers and state out. Passive: told
// the time.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <unordered_map>

#include "gaitway/api/plan_digest.hpp"
#include "gaitway/api/state_export.hpp"
#include "gaitway/contract/order_table.hpp"
#include "gaitway/link/controller_end.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::api {

struct RobotDeskOptions {
  std::uint64_t boot = 0;  // random and not 0
  std::string name = "main_controller";
  bool narrow = false;  // the carrier is slower than a Unix socket
  link::LinkSettings link;
};

// Writes `walk_request`, `walk_to_request`, `stop_request`, `motion_request`, `head_request`,
// `command_request`, `behaviour_request`, `planned_state` and the queues `user_command` and
// `api_plugin_request`.
//
// When the link's session ends while the robot walks, it is told to stand: who commanded is not there any
// more.
class RobotDesk {
 public:
  // Opens the topics: throws msgclient::TopicError, urdf::RobotError when the description cannot be read.
  // `client` outlives it.
  RobotDesk(msgclient::Client& client, const urdf::RobotModel& robot, const RobotDeskOptions& options);
  RobotDesk(const RobotDesk&) = delete;
  RobotDesk& operator=(const RobotDesk&) = delete;

  // At least each millisecond, before and after its end() is pumped. `now_ns`: any monotonic clock.
  void step(std::int64_t now_ns);
  [[nodiscard]] link::ControllerEnd& end() noexcept { return end_; }

 private:
  struct Awaited {
    std::uint32_t number;
    link::OrderId id;
  };
  void pass_stops_on(std::int64_t robot_ns);
  void carry_out(const link::Order& order, std::int64_t robot_ns);
  void walk(const link::Order& order, std::int64_t robot_ns);
  void play_motion(const link::Order& order, std::int64_t robot_ns);
  void walk_to(const link::Order& order, std::int64_t robot_ns);
  void leave_way(std::int64_t robot_ns);
  void look(const link::Order& order, std::int64_t robot_ns);
  void take_or_let_go(const link::Order& order, std::int64_t robot_ns);
  void change_mission(const link::Order& order, std::int64_t robot_ns);
  void command(const link::Order& order, std::int64_t robot_ns);
  void request_plugin(const link::Order& order, std::int64_t robot_ns);
  void tell_that_person_is_lost(std::int64_t robot_ns);
  [[nodiscard]] bool was_given_before_stop(const link::Order& order) const noexcept;
  void take_answers();
  void take_motion_answer();
  void take_way_answer();
  void take_command_answer();
  void take_mission_answer();
  void overtake(std::deque<Awaited>& waiting);
  template <class Answer>
  void answer(link::OrderId id, const Answer& answer);
  void finish(link::OrderId id, contract::OrderResultCode code);  // without an answer of the robot's
  [[nodiscard]] std::uint32_t next_number() noexcept;
  template <class Request>
  [[nodiscard]] bool decode(const link::Order& order, Request& request) const noexcept;

  msgclient::Client& client_;
  contract::TopicCodec codec_, orders_;  // of state, of orders and answers
  link::ControllerEnd end_;
  PlanDigest plans_;
  StateExport state_;
  msgclient::Writer<WalkCommand> walk_requests_;
  msgclient::Writer<StopRequest> stop_requests_;
  msgclient::Reader<StopRequest> stop_answers_;
  msgclient::QueueWriter<UserCommand> commands_;
  msgclient::StreamReader<UserCommandAnswer> command_answers_;
  msgclient::QueueWriter<PluginRequest> requests_;
  msgclient::StreamReader<PluginAnswer> request_answers_;
  msgclient::Writer<WalkToRequest> way_requests_;
  msgclient::Reader<NavigationState> navigation_states_;
  msgclient::Writer<MotionRequest> motion_requests_;
  msgclient::Reader<MotionState> motion_states_;
  msgclient::Writer<CommandRequest> command_requests_;
  msgclient::Reader<CommandState> command_states_;
  msgclient::Writer<HeadCommand> head_requests_;
  msgclient::Writer<BehaviourRequest> behaviour_requests_;
  msgclient::Reader<BehaviourState> behaviour_states_;

  std::uint32_t last_number_;
  StopRequest stops_at_start_{};  // what the topic had when the link's counts were 0
  link::StopCounts stops_passed_on_;
  std::unordered_map<std::uint32_t, link::OrderId> awaited_;  // by the number under which the robot answers
  std::deque<Awaited> motions_;  // oldest first; the newest alone is answered by the robot
  std::uint64_t motion_seen_ = 0;
  std::deque<Awaited> ways_;  // likewise
  std::uint64_t way_seen_ = 0;
  std::deque<Awaited> commands_asked_, missions_;  // likewise
  std::uint64_t mission_seen_ = 0;
  bool on_way_ = false;        // told to walk to a place, and not told to leave the way since
  std::uint32_t session_ = 0;  // of the link, in which the orders below were given
};

}  // namespace gaitway::api
