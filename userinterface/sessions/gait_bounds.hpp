// How fast the robot's gait can walk now: out of the parameters of the plug-in `trajectory`, which the module
// reads once it is there, when they may have changed, and from time to time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "gaitway/api/robot_port.hpp"

namespace gaitway::api {

class Orders;

struct GaitBounds {
  double forward_m_per_s = 0.0, backward_m_per_s = 0.0;
  double left_m_per_s = 0.0;  // and to the right
  double turn_rad_per_s = 0.0;
};

class GaitWatch {
 public:
  static constexpr std::string_view kPlugin = "trajectory";
  // What is changed elsewhere than by clients is seen so late.
  static constexpr std::int64_t kPeriod_ns = 30'000'000'000;
  static constexpr std::int64_t kRetry_ns = 1'000'000'000;
  // Of the plug-in's parameters, in the order of Place.
  static constexpr std::array<std::string_view, 6> kNames{"step_time",         "max_step_forward",
                                                          "max_step_backward", "max_step_turn",
                                                          "max_foot_spacing",  "foot_spacing"};

  GaitWatch(RobotPort& robot, Orders& orders) noexcept : robot_(robot), orders_(orders) {}
  GaitWatch(const GaitWatch&) = delete;
  GaitWatch& operator=(const GaitWatch&) = delete;

  void step(std::int64_t now_ns);
  // This plug-in's parameters may be others now.
  void read_again(std::string_view plugin) noexcept;
  // The link to the robot was lost, or is there again.
  void robot_lost() noexcept;

  // Nothing: not known, or no plug-in of this robot has such parameters.
  [[nodiscard]] const std::optional<GaitBounds>& bounds() const noexcept { return bounds_; }

 private:
  enum Place : std::uint8_t { step_time, step_forward, step_backward, step_turn, most_spacing, spacing };
  using Indices = std::array<std::optional<std::uint32_t>, kNames.size()>;

  void begin(const Indices& indices);
  void ask(std::uint32_t index);
  void take(std::uint32_t index, const OrderResult* result);
  void ask_next(std::uint32_t after);
  void end_reading(std::int64_t pause_ns) noexcept;
  [[nodiscard]] std::optional<GaitBounds> read_bounds() const noexcept;

  RobotPort& robot_;
  Orders& orders_;
  Indices indices_;                                          // where they are, as read last
  std::array<std::optional<double>, kNames.size()> values_;  // in SI units, of the reading that is under way
  std::optional<GaitBounds> bounds_;
  std::int64_t now_ns_ = 0, due_ns_ = 0;
  std::uint32_t reading_ = 0;  // answers to another one are worth nothing any more
  bool reads_ = false, by_index_ = false;
};

}  // namespace gaitway::api
