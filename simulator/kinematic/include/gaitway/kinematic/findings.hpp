// What a trajectory does that it must not: which rule, what, when, by how much.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gaitway::kinematic {

enum class Rule : std::uint8_t {
  position,        // a joint, or its reference, stays between its stops
  speed,           // it is no faster than motor and reference may be
  torque,          // the motor gives no more than it has at that speed
  count_step,      // a point's difference fits a signed byte of the wire
  self_collision,  // no link is in another
  sole_in_floor,   // no sole is in the floor
  sole_slides,     // a sole that stands stays where it is
  zmp,             // the ZMP is over the support polygon
};
inline constexpr std::size_t kRules = 8;
[[nodiscard]] std::string_view name_of(Rule rule) noexcept;     // "position"
[[nodiscard]] std::string_view meaning_of(Rule rule) noexcept;  // "must lie between the joint's stops"

struct Finding {
  Rule rule = Rule::position;
  std::string what;                 // the joint, both links, the sole, or whose ZMP
  double from_s = 0.0, to_s = 0.0;  // the first and the last row that breaks the rule without a break
  double at_s = 0.0;                // the worst of them
  double value = 0.0, limit = 0.0;  // there, in the unit
  std::string unit;
};

// "left_knee: position 2.41 rad at 1.230 s, must lie between the joint's stops (2.3 rad); 1.200 to 1.260 s".
[[nodiscard]] std::string describe(const Finding& finding);

// Puts rows together to findings.
class FindingList {
 public:
  // To be told row by row, of each rule and thing once a row at most; what is not told of a row keeps to the
  // rule there. `excess`: by how much the rule is broken, > 0.
  void note(Rule rule, std::string_view what, std::size_t row, double time_s, double value, double limit,
            double excess, std::string_view unit);
  // By time, and of one instant by rule and thing.
  [[nodiscard]] std::vector<Finding> take();

 private:
  struct Open {
    std::size_t finding = 0, row = 0;
    double excess = 0.0;
  };
  std::vector<Finding> findings_;
  std::map<std::pair<Rule, std::string>, Open, std::less<>> open_;
};

}  // namespace gaitway::kinematic
