// Findings, row by row and in words.
#include "gaitway/kinematic/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <tuple>

namespace gaitway::kinematic {
namespace {

struct RuleWords {
  std::string_view name, meaning;
};
constexpr std::array<RuleWords, kRules> kRuleWords{
    {{"position", "must lie between the joint's stops"},
     {"speed", "must not be more than motor and reference may have"},
     {"torque", "must not be more than the motor gives at that speed"},
     {"count step", "must fit a signed byte of the wire"},
     {"self-collision", "links must not be in one another"},
     {"sole in floor", "a sole must not be in the floor"},
     {"sole slides", "a sole that stands must stay where it is"},
     {"zmp", "must lie over the support polygon"}}};

}  // namespace

std::string_view name_of(Rule rule) noexcept {
  return kRuleWords[static_cast<std::size_t>(rule)].name;
}

std::string_view meaning_of(Rule rule) noexcept {
  return kRuleWords[static_cast<std::size_t>(rule)].meaning;
}

std::string describe(const Finding& finding) {
  const std::string when = finding.from_s < finding.to_s
                               ? fmt::format("; {:.3f} to {:.3f} s", finding.from_s, finding.to_s)
                               : std::string();
  return fmt::format("{}: {} {:.4g} {} at {:.3f} s, {} (limit {:.4g} {}){}", finding.what,
                     name_of(finding.rule), finding.value, finding.unit, finding.at_s,
                     meaning_of(finding.rule), finding.limit, finding.unit, when);
}

void FindingList::note(Rule rule, std::string_view what, std::size_t row, double time_s, double value,
                       double limit, double excess, std::string_view unit) {
  auto& open = open_[{rule, std::string(what)}];
  const bool goes_on = !findings_.empty() && open.excess > 0.0 && row == open.row + 1;
  if (!goes_on) {
    open = {findings_.size(), row, 0.0};
    findings_.push_back({rule, std::string(what), time_s, time_s, time_s, value, limit, std::string(unit)});
  }
  Finding& finding = findings_[open.finding];
  finding.to_s = time_s;
  open.row = row;
  if (excess <= open.excess) return;
  open.excess = excess;
  finding.at_s = time_s;
  finding.value = value;
  finding.limit = limit;
}

std::vector<Finding> FindingList::take() {
  open_.clear();
  std::ranges::stable_sort(findings_, {}, [](const Finding& finding) {
    return std::tuple(finding.from_s, finding.rule, std::string_view(finding.what));
  });
  return std::exchange(findings_, {});
}

}  // namespace gaitway::kinematic
