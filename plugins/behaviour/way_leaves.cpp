// Ways that navigation walks: to a place in the world, or to a tag.
#include <cmath>
#include <numbers>

#include "leaf_base.hpp"

namespace gaitway::behaviour_leaves {
namespace {

using behaviour::Call;
using behaviour::Outcome;

// One way from its order to its end.
class WayAction : public RobotAction {
 public:
  using RobotAction::RobotAction;

  Outcome on_start(Call& call) noexcept final {
    number_ = 0;
    if (!now().is_upright()) return fail(name(), not_upright());
    if (now().navigation == nullptr) return fail(name(), "there is no navigation");
    if (const char* const why = objection(call)) return fail(name(), why);
    return on_running(call);
  }

  Outcome on_running(Call& call) noexcept final {
    if (!now().is_upright()) return abandon(not_upright(), call.now_ns());
    if (now().navigation == nullptr) return abandon("navigation has gone silent", call.now_ns());
    const auto goal = goal_in_world(call);
    if (number_ == 0) {  // whoever walks before it may still come to a stand
      if (const char* const why = objection(call)) return fail(name(), why);
      if (now().stands() && goal) order(*goal, call.now_ns());
      return Outcome::running;
    }
    if (orders().way_number() != number_) return fail(name(), "another node walks a way of its own");
    const NavigationState& state = *now().navigation;
    if (state.answered != number_) {
      const bool waits = call.now_ns() - ordered_ns_ < kOrderIsAnswered_ns;
      return waits ? Outcome::running : abandon("navigation has not answered", call.now_ns());
    }
    if (state.state != navigation_state::state::idle) {
      const bool has_moved = goal && std::hypot(goal->x_m - goal_.x_m, goal->y_m - goal_.y_m) > kGoalMoves_m;
      if (has_moved && state.state == navigation_state::state::walks) order(*goal, call.now_ns());
      return Outcome::running;
    }
    if (state.result == navigation_state::result::arrived) return Outcome::success;
    const bool is_cancelled = state.result == navigation_state::result::cancelled;
    return fail(name(), is_cancelled ? "the way was cancelled" : text_of(state.text));
  }

  Halt on_halt(Call& call) noexcept final {
    end_.begin(call.now_ns());
    halted_ns_ = call.now_ns();
    if (number_ == 0 || orders().way_number() != number_) return Halt::ended;
    if (now().commands()) cancel(call.now_ns());
    return on_halting(call);
  }

  // Whoever passes orders on may give the end of a way a number of his own, so that no answer has this one:
  // what counts is that no way is walked any more. An order that had just been given would show by then, too.
  Halt on_halting(Call& call) noexcept final {
    const bool is_ours = now().commands() && orders().way_number() == number_;
    if (!is_ours || now().navigation == nullptr) return Halt::ended;
    const bool is_idle = now().navigation->state == navigation_state::state::idle;
    if (!is_idle && call.now_ns() - halted_ns_ >= kMostForEnd_ns) {
      orders().tell_trouble(name(), "navigation does not end the way");
      return Halt::ended;
    }
    if (!is_idle && call.now_ns() - ordered_ns_ >= kOrderIsAnswered_ns) cancel(call.now_ns());
    return is_idle && end_.is_reached(now()) ? Halt::ended : Halt::ending;
  }

 protected:
  [[nodiscard]] virtual const char* name() const noexcept = 0;
  // Why it can't begin; nullptr: it can.
  [[nodiscard]] virtual const char* objection(Call& call) noexcept = 0;
  // Nothing: it can't be told now.
  [[nodiscard]] virtual std::optional<Pose> goal_in_world(Call& call) noexcept = 0;

 private:
  static constexpr double kGoalMoves_m = 0.12;  // from there on a way that is walked gets its new goal
  // A way ends within a few steps: by then whoever walks it does not obey.
  static constexpr std::int64_t kMostForEnd_ns = 10'000'000'000;

  void order(const Pose& goal, std::int64_t now_ns) noexcept {
    goal_ = goal;
    ordered_ns_ = now_ns;
    number_ = orders().walk_to(goal);
  }
  // Whoever comes back must not walk on.
  Outcome abandon(const char* why, std::int64_t now_ns) noexcept {
    const bool is_ours = number_ != 0 && orders().way_number() == number_;
    if (is_ours && now().commands()) cancel(now_ns);
    return fail(name(), why);
  }
  void cancel(std::int64_t now_ns) noexcept {
    ordered_ns_ = now_ns;
    number_ = orders().cancel_way();
  }

  std::uint32_t number_ = 0;  // of its order; 0: none yet
  std::int64_t ordered_ns_ = 0, halted_ns_ = 0;
  Pose goal_;  // world
  WalkEnd end_;
};

class WalkTo final : public WayAction {
 public:
  using WayAction::WayAction;

 protected:
  const char* name() const noexcept override { return "WalkTo"; }
  const char* objection(Call& call) noexcept override {
    return goal_in_world(call) ? nullptr : "a port of its goal has no value";
  }
  std::optional<Pose> goal_in_world(Call& call) noexcept override {
    const auto x_m = call.get<double>(0), y_m = call.get<double>(1), heading_rad = call.get<double>(2);
    if (!x_m || !y_m || !heading_rad) return std::nullopt;
    return Pose{*x_m, *y_m, *heading_rad};
  }
};

class WalkToTag final : public WayAction {
 public:
  using WayAction::WayAction;

 protected:
  const char* name() const noexcept override { return "WalkToTag"; }
  const char* objection(Call& call) noexcept override {
    const bool is_seen = now().tag(call.get<std::int64_t>(0).value_or(-1), oldest_ns(call)).has_value();
    return is_seen ? nullptr : "the tag has not been seen, or too long ago";
  }
  // It stands `distance` off the tag and faces it. A tag that is out of sight on the way stays where it was.
  std::optional<Pose> goal_in_world(Call& call) noexcept override {
    const auto tag = now().tag(call.get<std::int64_t>(0).value_or(-1), oldest_ns(call));
    const auto odometry = now().odometry();
    if (!tag || !odometry) return std::nullopt;
    const Pose base = now().base();
    const double* const at_m = tag->position_m;
    const bool in_front = call.get<std::int64_t>(2).value_or(0) == kInFront && tag->facing_rad.has_value();
    const double side_rad = in_front ? *tag->facing_rad : std::atan2(base.y_m - at_m[1], base.x_m - at_m[0]);
    const double off_m = call.get<double>(1).value_or(0.0);
    return outside(*odometry, Pose{at_m[0] + off_m * std::cos(side_rad), at_m[1] + off_m * std::sin(side_rad),
                                   side_rad + std::numbers::pi});
  }

 private:
  static constexpr std::int64_t kInFront = 0;
  static std::int64_t oldest_ns(Call& call) noexcept { return call.get<std::int64_t>(3).value_or(0); }
};

}  // namespace

void register_ways(behaviour::Registry& registry, const std::shared_ptr<Robot>& robot) {
  registry.add_action(
      {.id = "WalkTo",
       .ports = {number_port("x", "m", -1e4, 1e4, std::nullopt, "world"),
                 number_port("y", "m", -1e4, 1e4, std::nullopt, "world"),
                 number_port("heading", "rad", -10.0, 10.0, "0 rad", "world, at the end")},
       .meaning = "Has navigation walk to a place of the map. Fails with navigation's reason, "
                  "and in a fall"},
      [robot] { return std::make_unique<WalkTo>(robot); });
  registry.add_action(
      {.id = "WalkToTag",
       .ports = {tag_port(),
                 number_port("distance", "m", 0.2, 100.0, "0.5 m", "of the stand from the tag, level"),
                 choice_port("stand", {"in_front", "nearest"}, "in_front",
                             "before the tag's face, or on the nearest side"),
                 oldest_port("3 s")},
       .meaning =
           "Has navigation walk to a tag, and follows where it moves; it stands there and faces it. Fails "
           "where the tag is not seen at the beginning, with navigation's reason, and in a fall"},
      [robot] { return std::make_unique<WalkToTag>(robot); });
}

}  // namespace gaitway::behaviour_leaves
