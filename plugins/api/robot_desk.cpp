// Orders into queues, answers back by their numbers.
#include "gaitway/api/robot_desk.hpp"

#include <algorithm>
#include <array>
#include <random>
#include <span>
#include <string_view>

namespace gaitway::api {
namespace {

using contract::OrderKind;
using contract::OrderResultCode;

bool moves(const link::Order& order) noexcept {
  return static_cast<OrderKind>(order.kind) != OrderKind::plugin_request;
}

}  // namespace

RobotDesk::RobotDesk(msgclient::Client& client, const urdf::RobotModel& robot,
                     const RobotDeskOptions& options)
    : client_(client),
      codec_{.joint_count = robot.joints.size()},
      orders_{.joint_count = robot.joints.size(), .exact = true},
      end_(contract::identity_of(link::Role::controller, options.boot, options.name, robot),
           contract::link_channels(codec_), options.link),
      plans_(client),
      state_(client, codec_, options.narrow),
      walk_requests_(client.write<WalkCommand>("walk_request")),
      stop_requests_(client.write<StopRequest>("stop_request")),
      stop_answers_(client.read<StopRequest>("stop_answer")),
      commands_(client.write_queue<UserCommand>("user_command")),
      command_answers_(client.read_stream<UserCommandAnswer>("user_command_answer")),
      requests_(client.write_queue<PluginRequest>("api_plugin_request")),
      request_answers_(client.read_stream<PluginAnswer>("plugin_answer")),
      way_requests_(client.write<WalkToRequest>("walk_to_request")),
      navigation_states_(client.read<NavigationState>("navigation_state")),
      motion_requests_(client.write<MotionRequest>("motion_request")),
      motion_states_(client.read<MotionState>("motion_state")),
      command_requests_(client.write<CommandRequest>("command_request")),
      command_states_(client.read<CommandState>("command_state")),
      head_requests_(client.write<HeadCommand>("head_request")),
      behaviour_requests_(client.write<BehaviourRequest>("behaviour_request")),
      behaviour_states_(client.read<BehaviourState>("behaviour_state")),
      last_number_(std::random_device{}()) {  // answers to a process before this one are not ours
  // Goes on from what was obeyed, never from what a process before this one has left in its own topic.
  static_cast<void>(stop_answers_.read(stops_at_start_));
  stop_requests_.publish(stops_at_start_, client_.heartbeat_ns());
  tell_that_person_is_lost(client_.heartbeat_ns());  // what it has left of a walk ends, too
}

void RobotDesk::step(std::int64_t now_ns) {
  const std::int64_t robot_ns = client_.heartbeat_ns();
  end_.set_robot_time(robot_ns, now_ns);
  end_.step(now_ns);
  const std::uint32_t session = end_.session().open() ? end_.session().count() : 0;
  bool tells_of_loss = false;
  if (session != session_) {
    tells_of_loss = session_ != 0;
    session_ = session;
    awaited_.clear();
    motions_.clear();
    ways_.clear();
    commands_asked_.clear();
    missions_.clear();
    if (tells_of_loss) tell_that_person_is_lost(robot_ns);
  }
  pass_stops_on(robot_ns);
  // An order to take the command is told by the same topic, whose newest value alone is heard.
  while (const auto order = tells_of_loss ? std::nullopt : end_.next_order(now_ns)) {
    carry_out(*order, robot_ns);
  }
  take_answers();
  plans_.step(robot_ns);
  state_.step(end_, robot_ns);
}

void RobotDesk::pass_stops_on(std::int64_t robot_ns) {
  const link::StopCounts& counts = end_.stops_asked();
  if (counts != stops_passed_on_) {
    stops_passed_on_ = counts;
    StopRequest request = stops_at_start_;  // counts go round
    request.stamp_ns = robot_ns;
    request.stops = stops_at_start_.stops + counts.stops;
    request.holds = stops_at_start_.holds + counts.holds;
    request.softs = stops_at_start_.softs + counts.softs;
    stop_requests_.publish(request, robot_ns);  // after which nobody walks on
    on_way_ = false;
  }
  StopRequest obeyed;
  if (stop_answers_.read(obeyed)) {
    end_.stops_obeyed({obeyed.stops - stops_at_start_.stops, obeyed.holds - stops_at_start_.holds,
                       obeyed.softs - stops_at_start_.softs});
  }
}

void RobotDesk::carry_out(const link::Order& order, std::int64_t robot_ns) {
  if (moves(order) && was_given_before_stop(order)) {
    return finish(order.id, OrderResultCode::stopped);
  }
  switch (static_cast<OrderKind>(order.kind)) {
    case OrderKind::walk:
      return walk(order, robot_ns);
    case OrderKind::motion:
      return play_motion(order, robot_ns);
    case OrderKind::way:
      return walk_to(order, robot_ns);
    case OrderKind::head:
      return look(order, robot_ns);
    case OrderKind::command:
      return take_or_let_go(order, robot_ns);
    case OrderKind::behaviour:
      return change_mission(order, robot_ns);
    case OrderKind::user_command:
      return command(order, robot_ns);
    case OrderKind::plugin_request:
      return request_plugin(order, robot_ns);
  }
  finish(order.id, OrderResultCode::unknown);
}

bool RobotDesk::was_given_before_stop(const link::Order& order) const noexcept {
  std::uint32_t seen = 0;
  for (std::size_t i = 0; i < std::min(order.payload.size(), contract::kStopsSeenBytes); ++i) {
    seen |= std::uint32_t{order.payload[i]} << (8U * i);
  }
  const link::StopCounts& heard = end_.stops_heard();
  return static_cast<std::int32_t>(seen - (heard.stops + heard.holds + heard.softs)) < 0;
}

template <class Request>
bool RobotDesk::decode(const link::Order& order, Request& request) const noexcept {
  const TypeDescriptor& type = TopicType<Request>::descriptor;
  if (order.payload.size() <= contract::kStopsSeenBytes) {
    return false;
  }
  const link::Bytes value = order.payload.subspan(contract::kStopsSeenBytes);
  return orders_.decode(type, value, &request) == value.size() && contract::all_finite(type, &request);
}

void RobotDesk::finish(link::OrderId id, OrderResultCode code) {
  static_cast<void>(end_.answer(id, static_cast<std::uint16_t>(code), {}));
}

template <class Answer>
void RobotDesk::answer(link::OrderId id, const Answer& value) {
  std::array<std::uint8_t, link::kMostAnswerBytes> room{};
  const std::size_t size = orders_.encode(TopicType<Answer>::descriptor, &value, room);
  static_cast<void>(
      end_.answer(id, static_cast<std::uint16_t>(OrderResultCode::done), std::span(room).first(size)));
}

void RobotDesk::walk(const link::Order& order, std::int64_t robot_ns) {
  WalkCommand request;
  if (!decode(order, request) || request.valid_until_ns < 0 || request.valid_until_ns > link::kMostTime_ns) {
    return finish(order.id, OrderResultCode::malformed);
  }
  request.stamp_ns = robot_ns;
  request.valid_until_ns = request.walk == 0 ? 0 : robot_ns + request.valid_until_ns;
  if (request.walk == 0) {
    leave_way(robot_ns);
  }
  walk_requests_.publish(request, robot_ns);
  finish(order.id, OrderResultCode::done);
}

// Who commanded is not there any more: what walks comes to a stand.
void RobotDesk::tell_that_person_is_lost(std::int64_t robot_ns) {
  CommandRequest request{};
  request.stamp_ns = robot_ns;
  request.number = next_number();
  request.verb = command_request::verb::is_lost;
  on_way_ = false;
  command_requests_.publish(request, robot_ns);
}

// Whoever wants the robot to stand means its way, too.
void RobotDesk::leave_way(std::int64_t robot_ns) {
  if (!on_way_) {
    return;
  }
  WalkToRequest request{};
  request.stamp_ns = robot_ns;
  request.number = next_number();
  request.cancel = 1;
  on_way_ = false;
  way_requests_.publish(request, robot_ns);
}

// Answered when the way is planned, or refused; the end of one is answered at once.
void RobotDesk::walk_to(const link::Order& order, std::int64_t robot_ns) {
  WalkToRequest request;
  if (!decode(order, request)) {
    return finish(order.id, OrderResultCode::malformed);
  }
  overtake(ways_);
  if (request.cancel != 0) {
    leave_way(robot_ns);
    return answer(order.id, NavigationState{});
  }
  if (navigation_states_.newest_sequence() == 0) {
    constexpr std::string_view kNobody =
        "no plug-in of this robot walks to places: add 'navigation' to its configuration";
    NavigationState nobody{};
    nobody.result = navigation_state::result::refused;
    std::ranges::copy(kNobody, nobody.text);
    return answer(order.id, nobody);
  }
  request.stamp_ns = robot_ns;
  request.number = next_number();
  on_way_ = true;
  way_requests_.publish(request, robot_ns);
  ways_.push_back({request.number, order.id});
}

void RobotDesk::take_way_answer() {
  if (ways_.empty() || navigation_states_.newest_sequence() == way_seen_) {
    return;
  }
  NavigationState state;
  const auto read = navigation_states_.read(state);
  if (!read) {
    return;
  }
  way_seen_ = read.sequence;
  if (state.answered == ways_.front().number && state.state != navigation_state::state::plans) {
    answer(ways_.front().id, state);
    ways_.pop_front();
  }
}

// The behaviour's have the top bit set, and those of the arbiter itself the next.
std::uint32_t RobotDesk::next_number() noexcept {
  constexpr std::uint32_t kOfPeople = 0x3fff'ffff;
  last_number_ = std::max<std::uint32_t>((last_number_ + 1) & kOfPeople, 1);
  return last_number_;
}

// A request that came before another one could be answered was never seen.
void RobotDesk::overtake(std::deque<Awaited>& waiting) {
  for (; !waiting.empty(); waiting.pop_front()) {
    finish(waiting.front().id, OrderResultCode::overtaken);
  }
}

void RobotDesk::play_motion(const link::Order& order, std::int64_t robot_ns) {
  MotionRequest request;
  if (!decode(order, request)) {
    return finish(order.id, OrderResultCode::malformed);
  }
  overtake(motions_);
  request.stamp_ns = robot_ns;
  request.number = next_number();
  motion_requests_.publish(request, robot_ns);
  motions_.push_back({request.number, order.id});
}

void RobotDesk::look(const link::Order& order, std::int64_t robot_ns) {
  HeadCommand request;
  if (!decode(order, request) || request.mode > head_command::mode::hold) {
    return finish(order.id, OrderResultCode::malformed);
  }
  request.stamp_ns = robot_ns;
  head_requests_.publish(request, robot_ns);
  finish(order.id, OrderResultCode::done);
}

void RobotDesk::take_or_let_go(const link::Order& order, std::int64_t robot_ns) {
  CommandRequest request;
  if (!decode(order, request) || request.verb > command_request::verb::let_go) {
    return finish(order.id, OrderResultCode::malformed);
  }
  overtake(commands_asked_);
  request.stamp_ns = robot_ns;
  request.number = next_number();
  // The arbiter ends the way of who lets go.
  on_way_ = on_way_ && request.verb != command_request::verb::let_go;
  command_requests_.publish(request, robot_ns);
  commands_asked_.push_back({request.number, order.id});
}

void RobotDesk::change_mission(const link::Order& order, std::int64_t robot_ns) {
  BehaviourRequest request;
  if (!decode(order, request) || request.verb > behaviour_request::verb::change) {
    return finish(order.id, OrderResultCode::malformed);
  }
  overtake(missions_);
  if (behaviour_states_.newest_sequence() == 0) {
    constexpr std::string_view kNobody =
        "no plug-in of this robot carries out missions: add 'behaviour' to its configuration";
    PluginAnswer nobody{};
    std::ranges::copy(kNobody, nobody.text);
    return answer(order.id, nobody);
  }
  request.stamp_ns = robot_ns;
  request.number = next_number();
  behaviour_requests_.publish(request, robot_ns);
  missions_.push_back({request.number, order.id});
}

void RobotDesk::command(const link::Order& order, std::int64_t robot_ns) {
  UserCommand command;
  if (!decode(order, command)) {
    return finish(order.id, OrderResultCode::malformed);
  }
  take_answers();  // the stream of answers holds as many as the queue: none is overwritten
  command.number = next_number();
  if (!commands_.push(command, robot_ns)) {
    return finish(order.id, OrderResultCode::full);
  }
  awaited_.emplace(command.number, order.id);
}

void RobotDesk::request_plugin(const link::Order& order, std::int64_t robot_ns) {
  PluginRequest request;
  if (!decode(order, request)) {
    return finish(order.id, OrderResultCode::malformed);
  }
  take_answers();
  request.number = next_number();
  if (!requests_.push(request, robot_ns)) {
    return finish(order.id, OrderResultCode::full);
  }
  awaited_.emplace(request.number, order.id);
}

void RobotDesk::take_answers() {
  UserCommandAnswer obeyed;
  while (command_answers_.read(obeyed)) {
    if (const auto order = awaited_.extract(obeyed.number)) {
      answer(order.mapped(), obeyed);
    }
  }
  PluginAnswer done;
  while (request_answers_.read(done)) {
    if (const auto order = awaited_.extract(done.number)) {
      answer(order.mapped(), done);
    }
  }
  take_motion_answer();
  take_way_answer();
  take_command_answer();
  take_mission_answer();
}

void RobotDesk::take_motion_answer() {
  if (motions_.empty() || motion_states_.newest_sequence() == motion_seen_) {
    return;
  }
  MotionState state;
  const auto read = motion_states_.read(state);
  if (!read) {
    return;
  }
  motion_seen_ = read.sequence;
  if (state.answered == motions_.front().number) {
    answer(motions_.front().id, state);
    motions_.pop_front();
  }
}

void RobotDesk::take_command_answer() {
  CommandState state;
  if (commands_asked_.empty() || !command_states_.read(state) ||
      state.answered != commands_asked_.front().number) {
    return;
  }
  answer(commands_asked_.front().id, state);
  commands_asked_.pop_front();
}

// What was said, without the tree: that comes as state, and would be longer than an answer may be.
void RobotDesk::take_mission_answer() {
  if (missions_.empty() || behaviour_states_.newest_sequence() == mission_seen_) {
    return;
  }
  BehaviourState state;
  const auto read = behaviour_states_.read(state);
  if (!read) {
    return;
  }
  mission_seen_ = read.sequence;
  if (state.answered != missions_.front().number) {
    return;
  }
  PluginAnswer said{};
  said.done = state.refused == 0 ? 1 : 0;
  std::ranges::copy(state.text, said.text);
  answer(missions_.front().id, said);
  missions_.pop_front();
}

}  // namespace gaitway::api
