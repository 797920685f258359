// What is new is read once, converted once, and given away.
#include "gaitway/api/feed.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "command_news.hpp"
#include "event_digest.hpp"
#include "gaitway/api/diagnostics.hpp"
#include "gaitway/api/frame_messages.hpp"
#include "gaitway/api/robot_activity.hpp"
#include "gaitway/api/robot_frames.hpp"
#include "gaitway/api/ros_messages.hpp"
#include "gaitway/api/state_messages.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/urdf/description_text.hpp"
#include "latest.hpp"

namespace gaitway::api {
namespace {

// Further than a robot that stands is told to be by its noise.
bool is_elsewhere(const double (&pose)[3], const std::array<double, 3>& told) {
  constexpr double kFar_m = 0.02, kFar_rad = 0.03;
  return std::hypot(pose[0] - told[0], pose[1] - told[1]) > kFar_m || std::abs(pose[2] - told[2]) > kFar_rad;
}

constexpr std::int64_t kDiagnosticsPeriod_ns = 1'000'000'000;
constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::min();

std::int64_t slot_edge(std::int64_t time_ns) noexcept {
  return time_ns - time_ns % facts::kSlot_ns;
}

}  // namespace

struct Feed::Topics {
  explicit Topics(msgclient::Client& robot) : client(robot), events(robot.read_stream<Event>("events")) {}

  msgclient::Client& client;
  Latest<JointStates> joints{client, "joint_states"};
  Latest<FootForces> forces{client, "foot_forces"};
  Latest<gaitway::Imu> imu{client, "imu"};
  Latest<NetworkState> network{client, "network_state"};
  Latest<NetworkHealth> health{client, "network_health"};
  Latest<Estimate> estimate{client, "estimate"};
  Latest<PlannedState> planned{client, "planned_state"};
  Latest<gaitway::MotionState> motion{client, "motion_state"};
  Latest<NavigationState> navigation{client, "navigation_state"};
  Latest<PluginStatistics> statistics{client, "plugin_statistics"};
  Latest<gaitway::BusSlot> bus_slot{client, "bus_slot"};
  CommandNews command{client};
  msgclient::StreamReader<Event> events;
};

struct Feed::Messages {
  explicit Messages(const urdf::RobotModel& model)
      : joints(make_joint_state(model)),
        imu(make_imu(model)),
        wrenches{make_foot_wrench(model, urdf::Side::left), make_foot_wrench(model, urdf::Side::right)},
        odometry(make_odometry(model)),
        transforms(model),
        description{urdf::description_text(model.directory / "robot.urdf")} {}

  ros::JointState joints;
  ros::Imu imu;
  std::array<ros::WrenchStamped, 2> wrenches;
  ros::Odometry odometry;
  LinkTransforms transforms;
  ros::PointStamped point = make_ground_point();
  Footsteps footsteps;
  ros::String description;
};

struct Feed::State {
  explicit State(const urdf::RobotModel& robot) : model(robot), frames(robot), diagnostics(robot) {}

  urdf::RobotModel model;
  RobotFrames frames;
  Diagnostics diagnostics;
  EventDigest digest;
  std::optional<Activity> activity;  // as told last
  std::int64_t robot_ns = 0, beat_wall_ns = kNever, heartbeat_age_ns = 0;
  // Newest of each, so that nothing is published twice.
  std::int64_t joints_ns = 0, imu_ns = 0, forces_ns = 0, estimate_ns = 0, planned_ns = kNever,
               edge_ns = kNever;
  bool joints_wait = false, estimate_waits = false;  // to be made frames of
  bool described = false, footsteps_told = false;
  std::int64_t diagnostics_ns = kNever, diagnostics_wall_ns = kNever;
  std::uint64_t missed_events = 0;
  std::uint32_t motion_told = 0, motions_ended = 0;  // MotionState::state and ended, of the last message
  bool any_motion_told = false;
  std::uint32_t way_told = 0, way_answered = 0;  // NavigationState::state and answered, of the last message
  bool any_way_told = false;
  std::array<double, 3> place_told{};  // x m, y m, yaw rad, of the last message
};

Feed::Feed(msgclient::Client& client, const urdf::RobotModel& model)
    : topics_(std::make_unique<Topics>(client)),
      messages_(std::make_unique<Messages>(model)),
      state_(std::make_unique<State>(model)) {}
Feed::~Feed() = default;

std::int64_t Feed::robot_ns() const noexcept {
  return state_->robot_ns;
}
std::int64_t Feed::heartbeat_age_ns() const noexcept {
  return state_->heartbeat_age_ns;
}

void Feed::poll(std::int64_t wall_ns, PublicationSink& sink) {
  follow_clock(wall_ns);
  publish_once(sink);
  read_network();
  // An estimate belongs to the joints of its slot, which may have been read in the poll before.
  if (topics_->estimate.update()) state_->estimate_waits = true;
  if (state_->joints_wait && slot_edge(topics_->estimate.value().stamp_ns) <= slot_edge(state_->joints_ns)) {
    publish_frames(sink);
  }
  publish_joints(sink);
  publish_frames(sink);
  publish_imu(sink);
  publish_wrenches(sink);
  publish_at_slot_edge(sink);
  publish_planned(sink);
  publish_diagnostics(wall_ns, sink);
  publish_bus_slot(sink);
  publish_motion(sink);
  publish_way(sink);
  topics_->command.publish(sink, state_->robot_ns);
  publish_robot_state(sink);
  publish_events(sink);
}

void Feed::follow_clock(std::int64_t wall_ns) {
  State& state = *state_;
  const std::int64_t beat_ns = topics_->client.heartbeat_ns();
  if (beat_ns < state.robot_ns) forget();
  if (beat_ns != state.robot_ns || state.beat_wall_ns == kNever) state.beat_wall_ns = wall_ns;
  state.robot_ns = beat_ns;
  state.heartbeat_age_ns = wall_ns - state.beat_wall_ns;
}

void Feed::forget() {
  State& state = *state_;
  state.frames.reset();
  state.diagnostics.reset();
  topics_->planned.forget();
  topics_->command.forget();
  state.digest.clear();
  topics_->estimate.forget();
  state.joints_ns = state.imu_ns = state.forces_ns = state.estimate_ns = 0;
  state.planned_ns = state.edge_ns = state.diagnostics_ns = kNever;
  state.joints_wait = state.estimate_waits = false;
}

void Feed::publish_once(PublicationSink& sink) {
  if (state_->described || !sink.wants(Topic::robot_description)) return;
  sink.publish(Topic::robot_description, messages_->description, state_->robot_ns);
  state_->described = true;
}

void Feed::read_network() {
  topics_->network.update();
}

void Feed::publish_joints(PublicationSink& sink) {
  State& state = *state_;
  if (!topics_->joints.is_newer()) return;
  if (state.joints_wait) publish_transforms(sink, false);
  topics_->joints.update();
  const JointStates& joints = topics_->joints.value();
  if (joints.stamp_ns < state.joints_ns) forget();
  if (joints.stamp_ns == state.joints_ns) return;  // no joint has answered since
  state.joints_ns = joints.stamp_ns;
  state.joints_wait = true;
  if (!sink.wants(Topic::joint_states)) return;
  fill(messages_->joints, joints);
  sink.publish(Topic::joint_states, messages_->joints, state.robot_ns);
}

void Feed::publish_imu(PublicationSink& sink) {
  State& state = *state_;
  if (!topics_->imu.update() || topics_->imu.value().stamp_ns == state.imu_ns) return;
  state.imu_ns = topics_->imu.value().stamp_ns;
  if (!sink.wants(Topic::imu)) return;
  fill(messages_->imu, topics_->imu.value(), topics_->estimate.if_there());
  sink.publish(Topic::imu, messages_->imu, state.robot_ns);
}

void Feed::publish_wrenches(PublicationSink& sink) {
  State& state = *state_;
  if (!topics_->forces.update() || topics_->forces.value().stamp_ns == state.forces_ns) return;
  state.forces_ns = topics_->forces.value().stamp_ns;
  for (const urdf::Side side : urdf::kSides) {
    const Topic topic = side == urdf::Side::left ? Topic::left_wrench : Topic::right_wrench;
    if (!sink.wants(topic)) continue;
    ros::WrenchStamped& message = messages_->wrenches[static_cast<std::size_t>(side)];
    fill(message, topics_->forces.value(), state.model, side);
    sink.publish(topic, message, state.robot_ns);
  }
}

void Feed::publish_frames(PublicationSink& sink) {
  State& state = *state_;
  if (!state.estimate_waits || state.joints_ns == 0) return;
  const Estimate& estimate = topics_->estimate.value();
  state.estimate_waits = false;
  if (estimate.stamp_ns == state.estimate_ns) return;  // some sensor has fallen silent
  state.estimate_ns = estimate.stamp_ns;

  const JointStates& joints = topics_->joints.value();
  const std::size_t count = state.model.joints.size();
  const std::int64_t instant_ns = slot_edge(joints.stamp_ns);  // the joints measure at the slot's beginning
  topics_->planned.update();
  state.frames.update(instant_ns, {joints.position, count}, {joints.velocity, count}, estimate, planned());
  if (state.joints_wait) publish_transforms(sink, true);
  if (sink.wants(Topic::odometry)) {
    fill(messages_->odometry, state.frames, joints.stamp_ns);
    sink.publish(Topic::odometry, messages_->odometry, state.robot_ns);
  }
  const auto publish_point = [&](Topic topic, const Eigen::Vector3d& point_m) {
    if (!sink.wants(topic)) return;
    fill(messages_->point, state.frames.odom_from_support(), point_m, estimate.stamp_ns);
    sink.publish(topic, messages_->point, state.robot_ns);
  };
  publish_point(Topic::com, {estimate.com[0], estimate.com[1], estimate.com[2]});
  publish_point(Topic::zmp, {estimate.zmp[0], estimate.zmp[1], 0.0});
}

void Feed::publish_transforms(PublicationSink& sink, bool with_base) {
  State& state = *state_;
  state.joints_wait = false;
  if (!sink.wants(Topic::transforms)) return;
  const JointStates& joints = topics_->joints.value();
  messages_->transforms.fill({joints.position, state.model.joints.size()},
                             with_base ? &state.frames.odom_from_base() : nullptr, joints.stamp_ns);
  sink.publish(Topic::transforms, messages_->transforms.message(), state.robot_ns);
}

void Feed::publish_at_slot_edge(PublicationSink& sink) {
  State& state = *state_;
  const std::int64_t edge_ns = slot_edge(state.robot_ns);
  if (edge_ns == state.edge_ns || state.robot_ns == 0) return;
  state.edge_ns = edge_ns;
  if (sink.wants(Topic::clock)) {
    sink.publish(Topic::clock, ros::Clock{ros_time(state.robot_ns)}, state.robot_ns);
  }
}

// Null: no plan is in force.
const PlannedState* Feed::planned() const noexcept {
  const PlannedState* const planned = topics_->planned.if_there();
  return planned != nullptr && planned->sequence != 0 ? planned : nullptr;
}

void Feed::publish_planned(PublicationSink& sink) {
  State& state = *state_;
  topics_->planned.update();
  const std::int64_t stamp_ns = topics_->planned.value().stamp_ns;
  if (topics_->planned.if_there() == nullptr || stamp_ns == state.planned_ns) return;
  state.planned_ns = stamp_ns;
  const PlannedState& moment = topics_->planned.value();
  if (sink.wants(Topic::reference_zmp) && planned() != nullptr) {
    fill(messages_->point, state.frames.odom_from_plan(), {moment.zmp[0], moment.zmp[1], 0.0}, stamp_ns);
    sink.publish(Topic::reference_zmp, messages_->point, state.robot_ns);
  }
  if (!sink.wants(Topic::footsteps)) return;
  if (messages_->footsteps.update(moment, state.frames.odom_from_plan()) || !state.footsteps_told) {
    sink.publish(Topic::footsteps, messages_->footsteps.message(), state.robot_ns);
    state.footsteps_told = true;
  }
}

void Feed::publish_diagnostics(std::int64_t wall_ns, PublicationSink& sink) {
  State& state = *state_;
  const bool due = state.diagnostics_ns == kNever ||
                   state.robot_ns - state.diagnostics_ns >= kDiagnosticsPeriod_ns ||
                   wall_ns - state.diagnostics_wall_ns >= kDiagnosticsPeriod_ns;
  if (!due) return;
  state.diagnostics_ns = state.robot_ns;
  state.diagnostics_wall_ns = wall_ns;
  if (!sink.wants(Topic::diagnostics)) return;
  topics_->statistics.update();
  topics_->health.update();
  const RobotCondition condition{.stamp_ns = state.robot_ns,
                                 .heartbeat_age_ns = state.heartbeat_age_ns,
                                 .plugins = topics_->statistics.if_there(),
                                 .network = topics_->network.if_there(),
                                 .health = topics_->health.if_there()};
  sink.publish(Topic::diagnostics, state.diagnostics.report(condition), state.robot_ns);
}

void Feed::publish_bus_slot(PublicationSink& sink) {
  if (topics_->bus_slot.update() && sink.wants(Topic::bus_slot)) {
    sink.publish(Topic::bus_slot, bus_slot_of(topics_->bus_slot.value()), state_->robot_ns);
  }
}

void Feed::publish_motion(PublicationSink& sink) {
  if (!topics_->motion.update()) return;
  const gaitway::MotionState& motion = topics_->motion.value();
  State& state = *state_;
  const bool news = motion.state != 0 || state.motion_told != 0 || motion.ended != state.motions_ended;
  if (!news && state.any_motion_told) return;
  state.motion_told = motion.state;
  state.motions_ended = motion.ended;
  state.any_motion_told = true;
  if (sink.wants(Topic::motion_state))
    sink.publish(Topic::motion_state, motion_state_of(motion), state.robot_ns);
}

void Feed::publish_way(PublicationSink& sink) {
  if (!topics_->navigation.update()) return;
  const NavigationState& navigation = topics_->navigation.value();
  State& state = *state_;
  const bool news = navigation.state != 0 || state.way_told != 0 ||
                    navigation.answered != state.way_answered ||
                    is_elsewhere(navigation.pose, state.place_told);
  if (!news && state.any_way_told) return;
  std::ranges::copy(navigation.pose, state.place_told.begin());
  state.way_told = navigation.state;
  state.way_answered = navigation.answered;
  state.any_way_told = true;
  if (sink.wants(Topic::way_state)) sink.publish(Topic::way_state, way_state_of(navigation), state.robot_ns);
}

void Feed::publish_robot_state(PublicationSink& sink) {
  State& state = *state_;
  const Activity activity = activity_of({.network = topics_->network.if_there(),
                                         .estimate = topics_->estimate.if_there(),
                                         .planned = topics_->planned.if_there(),
                                         .motion = topics_->motion.if_there(),
                                         .heartbeat_age_ns = state.heartbeat_age_ns});
  if (activity == state.activity || !sink.wants(Topic::robot_state)) return;
  state.activity = activity;
  sink.publish(Topic::robot_state, robot_state_of(activity, state.robot_ns), state.robot_ns);
}

void Feed::tell(const ros::Log& event, PublicationSink& sink) {
  if (state_->digest.is_news(event, state_->robot_ns)) publish_event(event, sink);
}

void Feed::publish_event(const ros::Log& event, PublicationSink& sink) {
  for (const Topic topic : {Topic::events, Topic::rosout}) {
    if (sink.wants(topic)) sink.publish(topic, event, state_->robot_ns);
  }
}

void Feed::publish_events(PublicationSink& sink) {
  State& state = *state_;
  Event event;
  while (topics_->events.read(event).status == msgclient::ReadStatus::value) {
    tell(log_of(event), sink);
  }
  while (const auto log = state.digest.repeats(state.robot_ns)) {
    publish_event(*log, sink);
  }
  const std::uint64_t missed = topics_->events.missed();
  if (missed == state.missed_events) return;
  publish_event(log_of_missed(missed - state.missed_events, state.robot_ns), sink);
  state.missed_events = missed;
}

}  // namespace gaitway::api
