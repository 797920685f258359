// The findings of a check as text and as JSON.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "tools/check_plugin/plugin_check.hpp"

namespace gaitway::plugin_check {
namespace {

constexpr std::size_t kMostShown = 8;  // findings of a check, as text

std::string_view outcome_of(const CheckResult& result) {
  if (!result.findings.empty()) {
    return "finding";
  }
  return result.skipped.empty() ? "ok" : "skipped";
}

}  // namespace

std::size_t Report::finding_count() const noexcept {
  return std::accumulate(
      results.begin(), results.end(), std::size_t{0},
      [](std::size_t sum, const CheckResult& result) { return sum + result.findings.size(); });
}

std::string to_text(const CheckResult& result) {
  const std::string_view outcome = outcome_of(result);
  std::string text = fmt::format("  {:<14} {:<8} {}", result.check, outcome,
                                 outcome == "skipped" ? result.skipped : result.remark);
  text.erase(text.find_last_not_of(' ') + 1);
  text += '\n';
  for (std::size_t i = 0; i < std::min(result.findings.size(), kMostShown); ++i) {
    const Finding& finding = result.findings[i];
    text += fmt::format("    {}\n", finding.what);
    text += finding.where.empty() ? "" : fmt::format("      where:  {}\n", finding.where);
    text += fmt::format("      remedy: {}\n", finding.remedy);
  }
  if (result.findings.size() > kMostShown) {
    text += fmt::format("    and {} more; --json has all of them\n", result.findings.size() - kMostShown);
  }
  return text;
}

nlohmann::ordered_json to_json(const Report& report) {
  nlohmann::ordered_json checks = nlohmann::ordered_json::array();
  for (const CheckResult& result : report.results) {
    nlohmann::ordered_json findings = nlohmann::ordered_json::array();
    for (const Finding& finding : result.findings) {
      findings.push_back({{"what", finding.what}, {"where", finding.where}, {"remedy", finding.remedy}});
    }
    checks.push_back({{"check", result.check},
                      {"outcome", outcome_of(result)},
                      {"remark", result.skipped.empty() ? result.remark : result.skipped},
                      {"findings", findings},
                      {"figures", result.figures},
                      {"seconds", result.seconds}});
  }
  return {{"plugin", report.plugin.string()},
          {"name", report.name},
          {"version", report.version},
          {"seed", report.seed},
          {"full", report.full},
          {"findings", report.finding_count()},
          {"seconds", report.seconds},
          {"checks", std::move(checks)}};
}

}  // namespace gaitway::plugin_check
