// Whether a plug-in keeps the rules of the plug-in interface: every rule is tried in a process of its own, so
// that a crash or a hang of the plug-in is a finding and nothing else.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace gaitway::plugin_check {

struct CheckOptions {
  std::filesystem::path plugin;
  std::filesystem::path robot;                     // folder with robot.urdf and robot.yaml
  std::filesystem::path walk_config;               // plug-ins of the walk whose topics are the inputs
  std::vector<std::filesystem::path> plugin_path;  // where those are looked for
  std::optional<std::filesystem::path> config;     // the checked plug-in's parameters
  std::uint64_t seed = 1;
  bool full = false;
  double budget_ms = 0.0;  // 0: by the plug-in's period
};

struct Finding {
  std::string what;
  std::string where;
  std::string remedy;
};

struct CheckResult {
  std::string check;
  std::vector<Finding> findings;
  std::string skipped;                                                // why; empty: it was done
  std::string remark;                                                 // what was looked at, in a few words
  nlohmann::ordered_json figures = nlohmann::ordered_json::object();  // what was measured
  double seconds = 0.0;
};

struct Report {
  std::filesystem::path plugin;
  std::string name;  // of the descriptor, as far as it could be read
  std::string version;
  std::uint64_t seed = 0;
  bool full = false;
  std::vector<CheckResult> results;  // in the order of the documentation
  double seconds = 0.0;

  [[nodiscard]] std::size_t finding_count() const noexcept;
};

// The input is bad: no such file, no walk to take the inputs from.
class CheckError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Runs all checks; `finished` is told of each one as it ends. Throws CheckError. The running executable must
// hand its arguments to run_worker() when the first is kWorkerCommand.
Report check_plugin(const CheckOptions& options, const std::function<void(const CheckResult&)>& finished);

// One line for people, and more below it for each finding.
std::string to_text(const CheckResult& result);
nlohmann::ordered_json to_json(const Report& report);

inline constexpr const char* kWorkerCommand = "plugin-check-worker";
// What the processes of the checks run; `job` comes from check_plugin(). Does not return an error: what it
// finds goes to the process that started it.
int run_worker(const char* job);

}  // namespace gaitway::plugin_check
