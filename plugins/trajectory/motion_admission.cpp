// Answers each request for a motion: taken, or refused with its reason.
#include "gaitway/trajectory/motion_admission.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstring>

namespace gaitway::trajectory {
namespace {

// Of the trunk against the vertical.
constexpr double kStandsWithin_rad = 0.5, kLiesBeyond_rad = 0.6;

template <std::size_t size, class... Values>
void tell(std::uint8_t (&to)[size], fmt::format_string<const Values&...> format,
          const Values&... values) noexcept {
  auto* const text = reinterpret_cast<char*>(to);
  const auto end = fmt::format_to_n(text, size - 1, format, values...);
  *end.out = 0;
}

double tilt_rad(const Estimate* estimate) noexcept {
  return estimate == nullptr ? 0.0
                             : std::acos(std::cos(estimate->attitude[0]) * std::cos(estimate->attitude[1]));
}

// One that lies between its front and its back is left to try either: no motion may begin there.
bool lies_the_other_way(const MotionTable& motion, const Estimate* estimate) noexcept {
  return motion.lies_on && estimate != nullptr &&
         lying_side(estimate->attitude[0], estimate->attitude[1]) == opposite(*motion.lies_on);
}

}  // namespace

MotionAdmission::MotionAdmission(const std::vector<MotionTable>& motions, const urdf::RobotModel& robot) {
  for (const MotionTable& motion : motions) known_ += (known_.empty() ? "" : ", ") + motion.name;
  for (const urdf::Joint& joint : robot.joints) home_rad_.push_back(joint.home_rad);
  offset_rad_.resize(home_rad_.size());
}

std::optional<MotionOrder> MotionAdmission::answer(const MotionRequest& request,
                                                   const MotionCircumstances& now, const MotionPlayer& player,
                                                   gaitway::MotionState& state) noexcept {
  if (request.number == 0 || request.number == seen_) return std::nullopt;
  seen_ = request.number;
  if (now.now_ns - request.stamp_ns > kLifetime_ns) return std::nullopt;
  state.answered = request.number;
  state.refused = 1;
  const auto* const characters = reinterpret_cast<const char*>(request.name);
  const std::string_view name(characters, strnlen(characters, sizeof request.name));
  if (name.empty()) {
    state.refused = 0;
    if (!player.plays()) {
      tell(state.text, "no motion plays");
      return MotionOrder{};
    }
    tell(state.text, "the motion is being left");
    return MotionOrder{MotionOrder::Kind::leave, 0};
  }
  const std::optional<std::size_t> motion = player.find(name);
  if (!motion) {
    tell(state.text, "there is no motion '{}'; there {} {}", name,
         known_.empty() ? "are" : "is:", known_.empty() ? "none" : known_.c_str());
    return MotionOrder{};
  }
  const MotionTable& table = player.motions()[*motion];
  if (const std::string_view why = objection(table, now, player); !why.empty()) {
    tell(state.text, "'{}' cannot begin: {}", name, why);
    return MotionOrder{};
  }
  if (lies_the_other_way(table, now.estimate)) {
    tell(state.text, "'{}' cannot begin: it begins on the {}, and the robot lies on its {}", name,
         name_of(*table.lies_on), name_of(opposite(*table.lies_on)));
    return MotionOrder{};
  }
  state.refused = 0;
  tell(state.text, "'{}' begins", name);
  return MotionOrder{MotionOrder::Kind::play, *motion};
}

std::string_view MotionAdmission::objection(const MotionTable& motion, const MotionCircumstances& now,
                                            const MotionPlayer& player) const noexcept {
  if (player.plays()) return "another motion plays. Wait for its end, or have it left";
  if (!now.follows) return "the robot plays its safe tail or is stopped. Wait until it stands";
  if (now.falls) return "the robot falls. Wait until it lies";
  if (!now.stands) return "the robot walks. Let it stand first";
  const double tilt = tilt_rad(now.estimate);
  if (motion.on_ground && !(tilt >= kLiesBeyond_rad))
    return "it begins on the ground, and the robot does not lie there";
  if (!motion.on_ground && (player.lies() || !(tilt <= kStandsWithin_rad))) {
    return "it begins in the stand, and the robot does not stand";
  }
  return {};
}

std::span<const double> MotionAdmission::offsets(const MotionCircumstances& now) noexcept {
  if (now.joints == nullptr || now.joints->joint_count != home_rad_.size()) return {};
  for (std::size_t j = 0; j < home_rad_.size(); ++j) {
    const double offset = now.joints->reference_position[j] - home_rad_[j];
    offset_rad_[j] = std::isfinite(offset) ? offset : 0.0;
  }
  return offset_rad_;
}

}  // namespace gaitway::trajectory
