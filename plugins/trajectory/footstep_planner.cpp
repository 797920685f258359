// Footsteps from velocities, with the named limits, and one line a limit.
#include "gaitway/trajectory/footstep_planner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gaitway::trajectory {
namespace {

constexpr double kSamePlace_m = 1e-6;

double approach(double present, double wanted, double most, StepLimit& applied) noexcept {
  const double change = std::clamp(wanted - present, -most, most);
  if (change != wanted - present) applied = applied | StepLimit::acceleration;
  return present + change;
}

double clamp_counting(double value, double low, double high, StepLimit rule, StepLimit& applied) noexcept {
  constexpr double kRounding = 1e-12;
  if (value < low - kRounding || value > high + kRounding) applied = applied | rule;
  return std::clamp(value, low, high);
}

// Displacement of a body that moves with constant velocity in its own frame while it turns at a constant
// rate.
Pose2 moved(double forward_m, double left_m, double turn_rad) noexcept {
  double s = 1.0, c = 0.0;  // sin θ / θ and (1 − cos θ) / θ
  if (std::abs(turn_rad) > 1e-9) {
    s = std::sin(turn_rad) / turn_rad;
    c = (1.0 - std::cos(turn_rad)) / turn_rad;
  }
  return {s * forward_m - c * left_m, c * forward_m + s * left_m, turn_rad};
}

bool same_request(const WalkCommand& a, const WalkCommand& b) noexcept {
  return a.walk == b.walk && a.velocity[0] == b.velocity[0] && a.velocity[1] == b.velocity[1] &&
         a.turn_rate == b.turn_rate;
}

}  // namespace

Eigen::Vector2d Pose2::transform(double forward_m, double left_m) const noexcept {
  const double c = std::cos(yaw_rad), s = std::sin(yaw_rad);
  return {x_m + c * forward_m - s * left_m, y_m + s * forward_m + c * left_m};
}

Pose2 Pose2::compose(const Pose2& local) const noexcept {
  const Eigen::Vector2d p = transform(local.x_m, local.y_m);
  return {p.x(), p.y(), yaw_rad + local.yaw_rad};
}

Pose2 Pose2::relative_of(const Pose2& other_pose) const noexcept {
  const double c = std::cos(yaw_rad), s = std::sin(yaw_rad);
  const double dx = other_pose.x_m - x_m, dy = other_pose.y_m - y_m;
  return {c * dx + s * dy, -s * dx + c * dy, other_pose.yaw_rad - yaw_rad};
}

FootstepPlanner::FootstepPlanner(const GaitParameters& parameters) : parameters_(parameters) {}

double FootstepPlanner::max_forward_m_per_s(bool backward) const noexcept {
  return (backward ? parameters_.max_step_backward_m : parameters_.max_step_forward_m) /
         parameters_.step_time_s;
}

// A side step opens the feet with one foot and closes them with the other.
double FootstepPlanner::max_left_m_per_s() const noexcept {
  return (parameters_.max_foot_spacing_m - parameters_.foot_spacing_m) / (2.0 * parameters_.step_time_s);
}

double FootstepPlanner::max_turn_rad_per_s() const noexcept {
  return parameters_.max_step_turn_rad / parameters_.step_time_s;
}

Velocity2 FootstepPlanner::limit_speed(const Velocity2& wanted, StepLimit& applied) const noexcept {
  const auto share = [](double value, double most) {
    return most > 0.0 ? value / most : (value == 0.0 ? 0.0 : 1e9);
  };
  const double norm = std::hypot(
      share(wanted.forward_m_per_s, max_forward_m_per_s(wanted.forward_m_per_s < 0.0)),
      share(wanted.left_m_per_s, max_left_m_per_s()), share(wanted.turn_rad_per_s, max_turn_rad_per_s()));
  if (norm <= 1.0) return wanted;
  applied = applied | StepLimit::speed;
  return {wanted.forward_m_per_s / norm, wanted.left_m_per_s / norm, wanted.turn_rad_per_s / norm};
}

Velocity2 FootstepPlanner::next_velocity(const Velocity2& present, const Velocity2& wanted,
                                         StepLimit& applied) const noexcept {
  const Velocity2 target = limit_speed(wanted, applied);
  const double T = parameters_.step_time_s;
  return {approach(present.forward_m_per_s, target.forward_m_per_s,
                   parameters_.forward_acceleration_m_per_s2 * T, applied),
          approach(present.left_m_per_s, target.left_m_per_s, parameters_.lateral_acceleration_m_per_s2 * T,
                   applied),
          approach(present.turn_rad_per_s, target.turn_rad_per_s,
                   parameters_.turn_acceleration_rad_per_s2 * T, applied)};
}

double FootstepPlanner::least_spacing_m(Side swing, double turn_rad) const noexcept {
  const Sole& sole = parameters_.sole;
  const double half_width = 0.5 * sole.width_m;
  const double toe = sole.centre_forward_m + 0.5 * sole.length_m;
  const double heel = sole.centre_forward_m - 0.5 * sole.length_m;
  const double outward = std::sin(sign_of(swing) * turn_rad);  // toes turned outward: the heel comes in
  const double encroachment = std::max(-toe * outward, -heel * outward);
  return half_width * (1.0 + std::cos(turn_rad)) + encroachment + parameters_.min_sole_gap_m;
}

// Of the sole origins, across the middle between the feet. Where only the foot that would come too near
// stepped further out, the walk would drift to that side with each of its steps.
double FootstepPlanner::walking_spacing_m(const Velocity2& velocity) const noexcept {
  const double turn_rad = velocity.turn_rad_per_s * parameters_.step_time_s;
  const double way_left_m = moved(velocity.forward_m_per_s * parameters_.step_time_s, 0.0, turn_rad).y_m;
  double spacing_m = parameters_.foot_spacing_m;
  for (const Side swing : {Side::left, Side::right}) {
    const double wanted_m = least_spacing_m(swing, turn_rad) - sign_of(swing) * way_left_m;
    spacing_m = std::max(spacing_m, 2.0 * wanted_m / (1.0 + std::cos(turn_rad)));
  }
  return spacing_m;
}

Pose2 FootstepPlanner::landing(const Pose2& stance, Side swing, const Velocity2& before,
                               const Velocity2& velocity, const Eigen::Vector2d& offset_m,
                               StepLimit& applied) const noexcept {
  const double T = parameters_.step_time_s;
  const double side = sign_of(swing);
  // Sideways, the outer foot makes the whole way of two steps and the inner one closes.
  const bool outer = side * velocity.left_m_per_s > 0.0;
  const Pose2 way = moved(velocity.forward_m_per_s * T, outer ? 2.0 * velocity.left_m_per_s * T : 0.0,
                          velocity.turn_rad_per_s * T);
  const Pose2 middle = Pose2{0.0, 0.5 * side * walking_spacing_m(before), 0.0}.compose(way);
  const Pose2 foot = middle.compose({0.0, 0.5 * side * walking_spacing_m(velocity), 0.0});
  return stance.compose(limited(foot, swing, offset_m, applied));
}

// `foot`, here and below: in the stance foot's frame.
Pose2 FootstepPlanner::limited(Pose2 foot, Side swing, const Eigen::Vector2d& offset_m,
                               StepLimit& applied) const noexcept {
  const double side = sign_of(swing);
  foot.yaw_rad = clamp_counting(foot.yaw_rad, -parameters_.max_step_turn_rad, parameters_.max_step_turn_rad,
                                StepLimit::turn, applied);
  foot.x_m = clamp_counting(foot.x_m + offset_m.x(), -parameters_.max_step_backward_m,
                            parameters_.max_step_forward_m, StepLimit::length, applied);
  double lateral = side * (foot.y_m + offset_m.y());
  lateral = clamp_counting(lateral, -1e9, parameters_.max_foot_spacing_m, StepLimit::spacing, applied);
  lateral = clamp_counting(lateral, least_spacing_m(swing, foot.yaw_rad), 1e9, StepLimit::sole_gap, applied);
  foot.y_m = side * lateral;
  return foot;
}

Pose2 FootstepPlanner::placed_landing(const Pose2& stance, Side swing, const Pose2& place,
                                      const Eigen::Vector2d& offset_m) const noexcept {
  StepLimit ignored = StepLimit::none;  // nobody has asked for more than the plan
  return stance.compose(limited(place, swing, offset_m, ignored));
}

Pose2 FootstepPlanner::adjusted_landing(const Pose2& stance, Side swing, const Velocity2& before,
                                        const Velocity2& velocity,
                                        const Eigen::Vector2d& offset_m) const noexcept {
  StepLimit ignored = StepLimit::none;
  const auto in_stance = [&](const Eigen::Vector2d& offset) {
    return stance.relative_of(landing(stance, swing, before, velocity, offset, ignored));
  };
  const double side = sign_of(swing);
  const double widest_m =
      std::max(parameters_.adjust_spacing_m, side * in_stance(Eigen::Vector2d::Zero()).y_m);
  Pose2 foot = in_stance(offset_m);
  foot.y_m = side * std::min(side * foot.y_m, widest_m);
  return stance.compose(foot);
}

Pose2 FootstepPlanner::beside(const Pose2& stance, Side swing) const noexcept {
  return stance.compose({0.0, sign_of(swing) * parameters_.foot_spacing_m, 0.0});
}

bool FootstepPlanner::is_beside(const Pose2& stance, Side swing, const Pose2& foot) const noexcept {
  const Pose2 place = beside(stance, swing);
  return std::abs(place.x_m - foot.x_m) < kSamePlace_m && std::abs(place.y_m - foot.y_m) < kSamePlace_m &&
         std::abs(place.yaw_rad - foot.yaw_rad) < kSamePlace_m;
}

StepLimit LimitReport::news(const WalkCommand& command, StepLimit applied) noexcept {
  if (!same_request(command, command_)) {
    command_ = command;
    told_ = StepLimit::none;
  }
  const auto fresh =
      static_cast<StepLimit>(static_cast<std::uint32_t>(applied) & ~static_cast<std::uint32_t>(told_));
  told_ = told_ | applied;
  return fresh;
}

const char* LimitReport::text(StepLimit rule) noexcept {
  const GaitParameters& p = parameters_;
  const auto write = [this](fmt::string_view format, auto... values) {
    auto* const begin = text_.data();
    auto end = fmt::format_to_n(begin, text_.size() - 1,
                                "walk {:.3g}, {:.3g} m/s, {:.3g} rad/s: ", command_.velocity[0],
                                command_.velocity[1], command_.turn_rate)
                   .out;
    const auto room = static_cast<std::size_t>(begin + text_.size() - 1 - end);
    *fmt::vformat_to_n(end, room, format, fmt::make_format_args(values...)).out = '\0';
    return static_cast<const char*>(begin);
  };
  switch (rule) {
    case StepLimit::speed:
      return write(
          "limited by rule speed: at most {:.3g} forward, {:.3g} backward, {:.3g} m/s sideways, {:.3g} rad/s",
          planner_.max_forward_m_per_s(false), planner_.max_forward_m_per_s(true),
          planner_.max_left_m_per_s(), planner_.max_turn_rad_per_s());
    case StepLimit::acceleration:
      return write("reached step by step by rule acceleration: at most {:.3g}, {:.3g} m/s^2, {:.3g} rad/s^2",
                   p.forward_acceleration_m_per_s2, p.lateral_acceleration_m_per_s2,
                   p.turn_acceleration_rad_per_s2);
    case StepLimit::length:
      return write("footstep limited by rule length: max_step_forward {:.3g} m, max_step_backward {:.3g} m",
                   p.max_step_forward_m, p.max_step_backward_m);
    case StepLimit::sole_gap:
      return write("footstep set further out by rule sole_gap: min_sole_gap {:.3g} m", p.min_sole_gap_m);
    case StepLimit::spacing:
      return write("footstep limited by rule spacing: max_foot_spacing {:.3g} m", p.max_foot_spacing_m);
    case StepLimit::turn:
      return write("footstep limited by rule turn: max_step_turn {:.3g} rad", p.max_step_turn_rad);
    case StepLimit::none:
      break;
  }
  return write("not limited");
}

}  // namespace gaitway::trajectory
