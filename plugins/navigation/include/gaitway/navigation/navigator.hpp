// Walks to a place: asks for a way, has the walk follow it, and asks anew when the robot was pushed off it or
// something stands in it.
#pragma once

#include <cstdint>
#include <string_view>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/navigation/planning_desk.hpp"
#include "gaitway/navigation/pose_filter.hpp"
#include "gaitway/navigation/way.hpp"
#include "gaitway/navigation/way_planner.hpp"

namespace gaitway::navigation {

struct NavigatorParameters {
  // Of the stand at the goal; what is further off is stepped after, at most `most_adjustments` times.
  double goal_tolerance_m = 0.010, goal_tolerance_rad = 0.017;
  int most_adjustments = 3;
  // A step that lands so far off its place was pushed: the rest is planned anew.
  double pushed_m = 0.030, pushed_rad = 0.10;
  int most_replans_at_a_stand = 6;
};

class Navigator {
 public:
  struct Inputs {
    std::int64_t now_ns = 0;
    const Estimate& estimate;
    const FootstepState& walk;
    bool commanded = false;  // somebody walks the robot by velocities
    std::uint32_t network_mode = network_state::mode::batches;
    std::uint64_t stops = 0;  // of people, since start
  };

  // `planner` and `desk` outlive it.
  Navigator(WayPlanner& planner, PlanningDesk& desk, const PoseFilter& pose,
            const NavigatorParameters& parameters) noexcept;

  // Before step(), as they come.
  void ask(const WalkToRequest& request, std::int64_t now_ns);
  void measure(const PoseMeasurement& measurement) noexcept;
  void see(const Obstacles& obstacles);

  // Every tick.
  void step(const Inputs& inputs, FootstepPlan& plan, NavigationState& state, NavigationWay& way);

  [[nodiscard]] const PoseFilter& pose() const noexcept { return pose_; }

  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.pose_, self.state_, self.result_, self.since_ns_, self.answered_, self.stops_, self.request_,
            self.goal_, self.way_, self.is_first_plan_, self.sees_news_, self.has_new_goal_,
            self.judged_step_, self.planned_after_, self.replans_, self.adjustments_, self.stands_in_the_way_,
            self.text_);
  }

 private:
  enum class State : std::uint32_t { idle, plans, walks, waits };
  enum class Result : std::uint32_t { none, arrived, cancelled, refused, failed };

  void answer(const Inputs& inputs);
  void ask_for_way(const Inputs& inputs);
  void begin_way(const planning::Plan& plan, const Inputs& inputs);
  void follow(const Inputs& inputs);
  void finish_or_plan_anew(const Inputs& inputs);
  void wait(const Inputs& inputs);
  void ask_on_the_way(const Inputs& inputs);
  void go_on(const planning::Plan& plan, const Inputs& inputs);
  [[nodiscard]] bool was_pushed(const Inputs& inputs) const noexcept;
  void end_if_taken_away(const Inputs& inputs);
  [[nodiscard]] planning::Pose foot(const Estimate& estimate, planning::Side side) const noexcept;
  [[nodiscard]] planning::Pose middle(const Estimate& estimate) const noexcept;
  void enter(State state, std::int64_t now_ns) noexcept;
  void end(Result result, std::string_view why, std::int64_t now_ns) noexcept;
  void tell(const Inputs& inputs, FootstepPlan& plan, NavigationState& state,
            NavigationWay& way) const noexcept;

  WayPlanner& planner_;
  PlanningDesk& desk_;
  PoseFilter pose_;
  NavigatorParameters parameters_;
  State state_ = State::idle;
  Result result_ = Result::none;
  std::int64_t since_ns_ = 0;  // in this state
  std::uint32_t answered_ = 0;
  std::uint64_t stops_ = 0;  // when the way was asked for
  WalkToRequest request_{};  // answered, or to be
  planning::Pose goal_;
  Way way_;
  bool is_first_plan_ = true;
  bool sees_news_ = false;
  bool has_new_goal_ = false;
  std::uint32_t judged_step_ = 0;    // in flight, when it was looked at whether it was pushed
  std::uint32_t planned_after_ = 0;  // the step from whose landing on the rest is being planned anew
  std::uint32_t replans_ = 0;
  int adjustments_ = 0, stands_in_the_way_ = 0;
  char text_[sizeof NavigationState::text]{};
};

}  // namespace gaitway::navigation
