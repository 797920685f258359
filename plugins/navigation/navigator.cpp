// The states of a way.
#include "gaitway/navigation/navigator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

namespace gaitway::navigation {
namespace {

namespace walk_states = footstep_state::state;
using planning::Pose;
using planning::Side;

constexpr std::int64_t kOrderValid_ns = 1'000'000'000;  // a request, from its stamp
constexpr std::int64_t kPlanValid_ns = 1'000'000'000;   // what the walk follows, without a newer one
constexpr std::int64_t kStandsFor_ns = 500'000'000;     // a stand that no step of the plan ends
constexpr std::int64_t kOneStop_ns = 50'000'000;        // from a cancellation to the stop that it belongs to
constexpr const char* kStopped = "somebody stopped the robot";
constexpr std::int64_t kMostForStand_ns = 10'000'000'000;  // until the robot stands again

Pose pose_of(const double (&numbers)[3]) noexcept {
  return {numbers[0], numbers[1], numbers[2]};
}

void write(const Pose& pose, double (&numbers)[3]) noexcept {
  numbers[0] = pose.x_m;
  numbers[1] = pose.y_m;
  numbers[2] = pose.yaw_rad;
}

bool is_off(const Pose& from, const Pose& to, double most_m, double most_rad) noexcept {
  return planning::way_m(from, to) > most_m || planning::turn_rad(from, to) > most_rad;
}

}  // namespace

Navigator::Navigator(WayPlanner& planner, PlanningDesk& desk, const PoseFilter& pose,
                     const NavigatorParameters& parameters) noexcept
    : planner_(planner), desk_(desk), pose_(pose), parameters_(parameters) {}

// One that is old was asked of somebody who has gone: it is not walked now. An end counts however late it is
// heard.
void Navigator::ask(const WalkToRequest& request, std::int64_t now_ns) {
  const bool counts = request.cancel != 0 || now_ns - request.stamp_ns < kOrderValid_ns;
  if (request.number != 0 && request.number != answered_ && counts) {
    request_ = request;
  }
}

void Navigator::measure(const PoseMeasurement& measurement) noexcept {
  static_cast<void>(pose_.correct(measurement.stamp_ns, pose_of(measurement.base), measurement.deviation[0],
                                  measurement.deviation[1]));
}

void Navigator::see(const Obstacles& obstacles) {
  sees_news_ = planner_.see(obstacles, pose_.odometry()) || sees_news_;
}

void Navigator::step(const Inputs& inputs, FootstepPlan& plan, NavigationState& state, NavigationWay& way) {
  pose_.predict(inputs.estimate.stamp_ns, pose_of(inputs.estimate.odometry_base));
  end_if_taken_away(inputs);  // with its reason, before a request that ends it without one
  answer(inputs);
  switch (state_) {
    case State::plans:
      ask_for_way(inputs);
      break;
    case State::walks:
      follow(inputs);
      break;
    case State::waits:
      wait(inputs);
      break;
    case State::idle:
      break;
  }
  tell(inputs, plan, state, way);
}

void Navigator::answer(const Inputs& inputs) {
  if (request_.number == answered_ || request_.number == 0) return;
  answered_ = request_.number;
  if (request_.cancel != 0) {
    if (state_ != State::idle) end(Result::cancelled, "", inputs.now_ns);
    return;
  }
  goal_ = pose_of(request_.goal);
  stops_ = inputs.stops;
  if (!std::isfinite(goal_.x_m + goal_.y_m + goal_.yaw_rad)) {
    end(Result::refused, "the goal must be three finite numbers", inputs.now_ns);
    return;
  }
  goal_.yaw_rad = planning::wrapped(goal_.yaw_rad);
  is_first_plan_ = true;
  replans_ = 0;
  adjustments_ = stands_in_the_way_ = 0;
  text_[0] = '\0';
  result_ = Result::none;
  if (state_ == State::walks && inputs.walk.step != 0) {
    has_new_goal_ = true;
    desk_.forget();  // a plan to the goal before
    return;
  }
  if (state_ == State::idle) {
    const char* const why = inputs.estimate.fall != estimate::fall::upright
                                ? "the robot falls or lies: have it get up first"
                            : inputs.network_mode == network_state::mode::emergency_stop
                                ? "an emergency stop is in force: release it first"
                            : inputs.commanded ? "somebody walks the robot by velocities: let it stand first"
                            : inputs.walk.state != walk_states::stands
                                ? "the robot does not stand: let it finish what it does first"
                                : nullptr;
    if (why != nullptr) {
      end(Result::refused, why, inputs.now_ns);
      return;
    }
  }
  enter(State::plans, inputs.now_ns);
}

// By somebody, or by a fall. A way that was stopped is not gone on with: nobody expects that.
void Navigator::end_if_taken_away(const Inputs& inputs) {
  if (state_ == State::idle) {
    // Whoever stops the robot has the way cancelled, too, which may be heard first.
    const bool just_cancelled =
        result_ == Result::cancelled && text_[0] == '\0' && inputs.now_ns - since_ns_ < kOneStop_ns;
    if (just_cancelled && inputs.stops != stops_) end(Result::cancelled, kStopped, inputs.now_ns);
    return;
  }
  if (inputs.commanded) {
    end(Result::cancelled, "somebody walks the robot by velocities", inputs.now_ns);
  } else if (inputs.estimate.fall != estimate::fall::upright) {
    end(Result::failed, "the robot fell", inputs.now_ns);
  } else if (inputs.stops != stops_) {
    end(Result::cancelled, kStopped, inputs.now_ns);
  }
}

void Navigator::ask_for_way(const Inputs& inputs) {
  if (inputs.walk.state != walk_states::stands) {
    if (inputs.now_ns - since_ns_ > kMostForStand_ns) {
      end(Result::failed, "the robot did not come to a stand within 10 s", inputs.now_ns);
    }
    return;
  }
  if (!desk_.waits()) {
    desk_.submit(planner_.job({.left = foot(inputs.estimate, Side::left),
                               .right = foot(inputs.estimate, Side::right),
                               .goal = goal_,
                               .first = std::nullopt,
                               .previous = {},
                               .budget = {}}),
                 inputs.now_ns);
  } else if (const auto plan = desk_.take(inputs.now_ns)) {
    begin_way(*plan, inputs);
  }
}

void Navigator::begin_way(const planning::Plan& plan, const Inputs& inputs) {
  if (!plan.found()) {
    end(is_first_plan_ ? Result::refused : Result::failed,
        fmt::format("{}: {}", planning::name(plan.reason), plan.explanation), inputs.now_ns);
    return;
  }
  if (!is_first_plan_) ++replans_;
  is_first_plan_ = false;
  sees_news_ = false;
  if (plan.steps.empty()) {
    end(Result::arrived, "", inputs.now_ns);
    return;
  }
  const std::uint32_t used = std::max({inputs.walk.landed, inputs.walk.step, way_.last()});
  way_.clear();
  way_.go_on(used, plan.steps);
  enter(State::walks, inputs.now_ns);
}

void Navigator::follow(const Inputs& inputs) {
  if (inputs.walk.state == walk_states::other || inputs.network_mode != network_state::mode::batches) {
    enter(State::waits, inputs.now_ns);
  } else if (inputs.walk.state == walk_states::stands) {
    finish_or_plan_anew(inputs);
  } else if (desk_.waits()) {
    if (const auto plan = desk_.take(inputs.now_ns)) go_on(*plan, inputs);
  } else if (inputs.walk.step != 0 && (has_new_goal_ || sees_news_ || was_pushed(inputs))) {
    ask_on_the_way(inputs);
  } else {
    judged_step_ = inputs.walk.step;
  }
}

void Navigator::finish_or_plan_anew(const Inputs& inputs) {
  if (inputs.walk.landed >= way_.last()) {
    const bool there =
        !is_off(middle(inputs.estimate), goal_, parameters_.goal_tolerance_m, parameters_.goal_tolerance_rad);
    if (there || adjustments_ >= parameters_.most_adjustments) {
      end(Result::arrived, "", inputs.now_ns);
      return;
    }
    ++adjustments_;
    enter(State::plans, inputs.now_ns);
  } else if (inputs.now_ns - since_ns_ >= kStandsFor_ns) {
    if (++stands_in_the_way_ > parameters_.most_replans_at_a_stand) {
      end(Result::failed, "the walk does not follow the planned footsteps", inputs.now_ns);
      return;
    }
    enter(State::plans, inputs.now_ns);
  }
}

// A recovery after a push, or a safe tail: the robot is about to stand.
void Navigator::wait(const Inputs& inputs) {
  const bool plays = inputs.network_mode == network_state::mode::batches;
  if (plays && inputs.walk.state == walk_states::stands) {
    if (++stands_in_the_way_ > parameters_.most_replans_at_a_stand) {
      end(Result::failed, "the robot was brought to a stand again and again", inputs.now_ns);
      return;
    }
    enter(State::plans, inputs.now_ns);
  } else if (inputs.now_ns - since_ns_ > kMostForStand_ns) {
    end(Result::failed, "the robot did not come to a stand within 10 s", inputs.now_ns);
  }
}

// Looked at once a step, early in it.
bool Navigator::was_pushed(const Inputs& inputs) const noexcept {
  const planning::Footstep* const step = way_.find(inputs.walk.step);
  if (inputs.walk.step == judged_step_ || step == nullptr) return false;
  return is_off(pose_.odometry().compose(pose_of(inputs.walk.landing)), step->pose, parameters_.pushed_m,
                parameters_.pushed_rad);
}

// From where the step in flight lands.
void Navigator::ask_on_the_way(const Inputs& inputs) {
  const std::uint32_t number = inputs.walk.step;
  const planning::Footstep* const step = way_.find(number);
  judged_step_ = planned_after_ = number;
  if (step == nullptr) return;
  planning::Request request{.left = foot(inputs.estimate, Side::left),
                            .right = foot(inputs.estimate, Side::right),
                            .goal = goal_,
                            .first = planning::other(step->side),
                            .previous = way_.from(number + 1),
                            .budget = {}};
  (step->side == Side::left ? request.left : request.right) =
      pose_.odometry().compose(pose_of(inputs.walk.landing));
  desk_.submit(planner_.job(request), inputs.now_ns);
  is_first_plan_ = has_new_goal_;
  has_new_goal_ = sees_news_ = false;
}

void Navigator::go_on(const planning::Plan& plan, const Inputs& inputs) {
  if (!plan.found()) {
    end(is_first_plan_ ? Result::refused : Result::failed,
        fmt::format("{}: {}", planning::name(plan.reason), plan.explanation), inputs.now_ns);
    return;
  }
  if (!plan.kept && !is_first_plan_) ++replans_;
  is_first_plan_ = false;
  way_.go_on(planned_after_, plan.steps);
}

Pose Navigator::foot(const Estimate& estimate, Side side) const noexcept {
  return pose_.odometry().compose(pose_of(estimate.odometry_foot[static_cast<std::size_t>(side)]));
}

Pose Navigator::middle(const Estimate& estimate) const noexcept {
  return planning::middle_of(foot(estimate, Side::left), foot(estimate, Side::right));
}

void Navigator::enter(State state, std::int64_t now_ns) noexcept {
  state_ = state;
  desk_.forget();  // what was asked for before is of no use
  since_ns_ = now_ns;
}

void Navigator::end(Result result, std::string_view why, std::int64_t now_ns) noexcept {
  result_ = result;
  const std::size_t size = std::min(why.size(), sizeof text_ - 1);
  std::copy_n(why.data(), size, text_);
  text_[size] = '\0';
  has_new_goal_ = false;
  enter(State::idle, now_ns);
}

void Navigator::tell(const Inputs& inputs, FootstepPlan& plan, NavigationState& state,
                     NavigationWay& way) const noexcept {
  plan.stamp_ns = inputs.now_ns;
  plan.valid_until_ns = inputs.now_ns + kPlanValid_ns;
  plan.first = 1;
  plan.step_count = plan.ends = 0;
  const Pose here = middle(inputs.estimate);
  state = NavigationState{};
  way.stamp_ns = inputs.now_ns;
  way.first = 1;
  way.step_count = 0;
  if (state_ == State::walks) {
    way_.tell(inputs.walk.step != 0 ? inputs.walk.step : inputs.walk.landed + 1, pose_.odometry(), plan);
    way_.tell_rest(inputs.walk.landed, way);
    state.steps_left = static_cast<std::uint32_t>(way_.from(inputs.walk.landed + 1).size());
    state.distance_left = way_.distance_left_m(inputs.walk.landed, here);
  }
  state.stamp_ns = inputs.now_ns;
  state.answered = answered_;
  state.state = static_cast<std::uint32_t>(state_);
  state.result = static_cast<std::uint32_t>(result_);
  state.replans = replans_;
  write(goal_, state.goal);
  write(here, state.pose);
  write(pose_.odometry(), state.odometry);
  state.pose_deviation[0] = pose_.deviation_m();
  state.pose_deviation[1] = pose_.deviation_rad();
  std::memcpy(state.text, text_, sizeof state.text);
}

}  // namespace gaitway::navigation
