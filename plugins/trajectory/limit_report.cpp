// One line a rule.
#include "gaitway/trajectory/limit_report.hpp"

#include <fmt/format.h>

#include <utility>

namespace gaitway::trajectory {
namespace {

bool same_request(const WalkCommand& a, const WalkCommand& b) noexcept {
  return a.walk == b.walk && a.velocity[0] == b.velocity[0] && a.velocity[1] == b.velocity[1] &&
         a.turn_rate == b.turn_rate;
}

}  // namespace

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
