// The search for a tag: where it was seen last, then the head goes from side to side, and the robot turns on,
// once around.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "leaf_base.hpp"

namespace gaitway::behaviour_leaves {
namespace {

using behaviour::Call;
using behaviour::Outcome;

// Whether a head has been at both sides, told by where it turns back.
class Sweep {
 public:
  void begin(const Situation& now) noexcept {
    moved_ns_ = now.now_ns;
    from_rad_ = most_rad_ = at_rad_ = yaw_rad(now);
    direction_ = 0;
    returns_ = 0;
  }
  void look(const Situation& now) noexcept {
    const double yaw = yaw_rad(now);
    if (std::abs(yaw - at_rad_) > kStill_rad) {
      at_rad_ = yaw;
      moved_ns_ = now.now_ns;
    }
    if (direction_ == 0) {
      if (std::abs(yaw - from_rad_) >= kTurn_rad) direction_ = yaw > from_rad_ ? 1 : -1;
      most_rad_ = yaw;
      return;
    }
    if (direction_ * (yaw - most_rad_) > 0.0) most_rad_ = yaw;
    if (direction_ * (most_rad_ - yaw) >= kTurn_rad) {
      ++returns_;
      direction_ = -direction_;
      most_rad_ = yaw;
    }
  }
  // A head that does not move, or does not any more, sees what is before it, and that is all.
  [[nodiscard]] bool is_done(const Situation& now) const noexcept {
    return returns_ >= 2 || now.now_ns - moved_ns_ >= kRests_ns;
  }

 private:
  static constexpr double kTurn_rad = 0.1, kStill_rad = 0.02;
  static constexpr std::int64_t kRests_ns = 2'000'000'000;
  static double yaw_rad(const Situation& now) noexcept {
    return now.estimate != nullptr ? now.estimate->head[0] : 0.0;
  }

  std::int64_t moved_ns_ = 0;
  double from_rad_ = 0.0, most_rad_ = 0.0, at_rad_ = 0.0;
  int direction_ = 0, returns_ = 0;
};

class FindTag final : public RobotAction {
 public:
  using RobotAction::RobotAction;

  Outcome on_start(Call& call) noexcept override {
    if (find(call)) return Outcome::success;
    if (!now().is_upright()) return fail("FindTag", not_upright());
    if (!now().sees()) return fail("FindTag", "there are no cameras that see");
    turned_rad_ = 0.0;
    recalled_bearing_rad(call) ? recall() : scan();
    return Outcome::running;
  }

  Outcome on_running(Call& call) noexcept override {
    if (!now().is_upright()) return lose(not_upright());
    if (!now().sees()) return lose("the cameras do not see any more");
    switch (doing_) {
      case Doing::recalls: {
        const double bearing_rad = recalled_bearing_rad(call).value_or(0.0);
        if (find(call) || std::abs(bearing_rad) <= kBefore_rad) return stop(call);
        const double rate = std::abs(call.get<double>(3).value_or(0.0));
        orders().walk({.turn_rad_per_s = std::copysign(rate, bearing_rad)});
        return Outcome::running;
      }
      case Doing::scans:
        if (find(call)) return keep_eyes_on(call);
        sweep_.look(now());
        if (!sweep_.is_done(now())) return Outcome::running;
        if (turned_rad_ >= call.get<double>(2).value_or(0.0) - kAround_rad) {
          orders().look_ahead();
          return fail("FindTag", "it has looked all around");
        }
        from_rad_ = now().base().yaw_rad;
        doing_ = Doing::turns;
        return Outcome::running;
      case Doing::turns:
        if (find(call) || std::abs(now().base().yaw_rad - from_rad_) >= kPart_rad) {
          turned_rad_ += std::abs(now().base().yaw_rad - from_rad_);
          return stop(call);
        }
        orders().walk({.turn_rad_per_s = call.get<double>(3).value_or(0.0)});
        return Outcome::running;
      case Doing::stops:
        if (!end_.is_reached(now())) return Outcome::running;
        if (find(call)) return keep_eyes_on(call);
        scan();
        return Outcome::running;
    }
    return Outcome::running;
  }

  Halt on_halt(Call& call) noexcept override {
    if (doing_ == Doing::turns || doing_ == Doing::recalls) end_.begin(call.now_ns());
    if (now().commands()) orders().look_ahead_after(look_);
    return on_halting(call);
  }
  Halt on_halting(Call&) noexcept override {
    return doing_ == Doing::scans || end_.is_reached(now()) ? Halt::ended : Halt::ending;
  }

 private:
  enum class Doing : std::uint8_t { recalls, scans, turns, stops };
  static constexpr double kPart_rad = std::numbers::pi / 3.0;  // turned between two scans
  static constexpr double kAround_rad = 0.1;
  static constexpr double kBefore_rad = 0.4;  // the head turns the rest

  // Where the tag was seen last.
  struct Recalled {
    std::int64_t id = -1;  // -1: nothing has been seen yet
    Pose in_world;
    double height_m = 0.0;
  };

  // From the robot's heading; nothing: that tag has not been seen, or it is not known where the robot is.
  [[nodiscard]] std::optional<double> recalled_bearing_rad(Call& call) const noexcept {
    const auto odometry = now().odometry();
    if (recalled_.id != call.get<std::int64_t>(0).value_or(-1) || !odometry) return std::nullopt;
    const Pose from_base = inside(now().base(), inside(*odometry, recalled_.in_world));
    return std::atan2(from_base.y_m, from_base.x_m);
  }

  void recall() noexcept {
    const Pose at = inside(*now().odometry(), recalled_.in_world);
    look_at(at.x_m, at.y_m, recalled_.height_m);
    doing_ = Doing::recalls;
  }

  // The head would scan on.
  Outcome lose(std::string_view why) noexcept {
    orders().look_ahead_after(look_);
    return fail("FindTag", why);
  }

  Outcome stop(Call& call) noexcept {
    end_.begin(call.now_ns());
    doing_ = Doing::stops;
    return Outcome::running;
  }

  void look_at(double x_m, double y_m, double z_m) noexcept {
    HeadCommand command{};
    command.mode = head_command::mode::point;
    command.point[0] = x_m;
    command.point[1] = y_m;
    command.point[2] = z_m;
    look_ = orders().look(command);
  }

  void scan() noexcept {
    HeadCommand command{};
    command.mode = head_command::mode::scan;
    command.direction[1] = kDown_rad;
    command.extent = kExtent_rad;
    command.period = kPeriod_s;
    look_ = orders().look(command);
    sweep_.begin(now());
    doing_ = Doing::scans;
  }

  // Whether the cameras have it now; where it is goes to the outputs.
  bool find(Call& call) noexcept {
    const auto tag = now().tag(call.get<std::int64_t>(0).value_or(-1), call.get<std::int64_t>(1).value_or(0));
    if (!tag) return false;
    const Pose base = now().base();
    const Pose seen{tag->position_m[0], tag->position_m[1], 0.0};
    const Pose from_base = inside(base, seen);
    call.set(4, now().distance_m(*tag));
    call.set(5, std::atan2(from_base.y_m, from_base.x_m));
    if (const auto odometry = now().odometry()) {
      recalled_ = {call.get<std::int64_t>(0).value_or(-1), outside(*odometry, seen), tag->position_m[2]};
      call.set(6, recalled_.in_world.x_m);
      call.set(7, recalled_.in_world.y_m);
    }
    return true;
  }

  Outcome keep_eyes_on(Call& call) noexcept {
    if (const auto tag =
            now().tag(call.get<std::int64_t>(0).value_or(-1), call.get<std::int64_t>(1).value_or(0))) {
      look_at(tag->position_m[0], tag->position_m[1], tag->position_m[2]);
    }
    return Outcome::success;
  }

  static constexpr double kExtent_rad = 1.05, kDown_rad = 0.1, kPeriod_s = 5.0;

  Doing doing_ = Doing::scans;
  double turned_rad_ = 0.0, from_rad_ = 0.0;
  std::uint32_t look_ = 0;  // its newest order to the head
  Recalled recalled_;
  Sweep sweep_;
  WalkEnd end_;
};

}  // namespace

void register_search(behaviour::Registry& registry, const std::shared_ptr<Robot>& robot) {
  registry.add_action(
      {.id = "FindTag",
       .ports = {tag_port(), oldest_port("0.5 s"),
                 number_port("around", "rad", 0.0, 100.0, "360 deg", "turned at most; then it fails"),
                 number_port("rate", "rad/s", 0.05, 3.0, "0.4 rad/s", "of the turns between two scans"),
                 output_port("distance", "m", "level, from the base"),
                 output_port("bearing", "rad", "from the robot's heading, to the left"),
                 output_port("x", "m", "world; not set without navigation"),
                 output_port("y", "m", "world; not set without navigation")},
       .meaning =
           "Looks where the tag was when it was last seen, if it was; then from side to side, turns by 60 "
           "degrees and looks again until the cameras have it; then the eyes stay on it. Fails when it has "
           "looked all around, where the cameras do not see, "
           "and in a fall. A limit in time is the decorator Timeout's"},
      [robot] { return std::make_unique<FindTag>(robot); });
}

}  // namespace gaitway::behaviour_leaves
