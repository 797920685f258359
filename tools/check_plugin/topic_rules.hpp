// What a value of a standard topic may be: which of its numbers are in use, their range, and how far they may
// move from one tick to the next.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gaitway/core/joint_plan_check.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "tools/check_plugin/replay_host.hpp"

namespace gaitway::plugin_check {

// Over what is in use of a value; of types that are not the schema's, over all of its floating-point numbers.
std::uint64_t digest_of(const Port& port) noexcept;

// Looks at every value that an output publishes, in order.
class OutputRules {
 public:
  explicit OutputRules(const urdf::RobotModel& robot) : joint_plan_check_(robot) {}

  // The first number of the output's value that is not finite; empty: all are.
  [[nodiscard]] std::optional<std::string> non_finite(const Port& port) const;
  // The first rule of range that the output's value breaks.
  [[nodiscard]] std::optional<std::string> out_of_range(const Port& port) const;
  // The first jump from the value that was given to this function before.
  [[nodiscard]] std::optional<std::string> jump(const Port& port);

 private:
  [[nodiscard]] std::optional<std::string> joint_plan_fault(const Port& port,
                                                            std::span<const double> start_rad) const;

  struct Before {
    const Port* port = nullptr;
    std::vector<std::byte> value;
  };
  core::JointPlanCheck joint_plan_check_;
  std::vector<Before> before_;
};

}  // namespace gaitway::plugin_check
