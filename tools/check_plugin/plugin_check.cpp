// The order of the checks, their processes, and what their endings mean.
#include "tools/check_plugin/plugin_check.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <future>
#include <mutex>

#include "gaitway/instance/configuration.hpp"
#include "tools/check_plugin/board.hpp"
#include "tools/check_plugin/nominal_record.hpp"
#include "tools/check_plugin/worker_process.hpp"

namespace gaitway::plugin_check {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kMostDeaths = 4;  // of one check's processes, before it is given up

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

WatchLimits limits_of(const CheckOptions& options) {
  return {.silence = std::chrono::milliseconds(options.full ? 15000 : 6000),
          .total = std::chrono::minutes(options.full ? 15 : 2)};
}

// What a check's process said, and how it ended.
struct Outcome {
  CheckResult result;
  std::string not_usable;
  bool unusable = false;
  int untried = 0;  // cases for which there was no time
  WorkerEnding ending;
  std::vector<OutputDigest> digests;
};

void read_lines(const Board& board, Outcome& outcome) {
  for (const nlohmann::ordered_json& line : board.lines()) {
    if (line.contains("finding")) {
      const auto& finding = line["finding"];
      outcome.result.findings.push_back({finding["what"], finding["where"], finding["remedy"]});
    } else if (line.contains("figure")) {
      outcome.result.figures[line["figure"]["name"].get<std::string>()] = line["figure"]["value"];
    } else if (line.contains("remark")) {
      outcome.result.remark = line["remark"];
    } else if (line.contains("untried")) {
      ++outcome.untried;
    } else if (line.contains("skipped")) {
      outcome.result.skipped = line["skipped"];
    } else if (line.contains("not_usable")) {
      outcome.unusable = true;
      outcome.not_usable = line["not_usable"];
    }
  }
}

Finding finding_of(const WorkerEnding& ending) {
  return {ending.what, ending.place,
          ending.ending == Ending::hung ? "look for a loop or a wait without an end"
                                        : "run it in a debugger, or build it with -fsanitize=address"};
}

class Checker {
 public:
  Checker(const CheckOptions& options, const std::function<void(const CheckResult&)>& finished)
      : options_(options), finished_(finished), limits_(limits_of(options)) {
    read_parameters();
    record_walk();
  }

  Report run();

 private:
  void read_parameters();
  void record_walk();
  [[nodiscard]] Job job(const std::string& check, const std::string& variant = "") const;
  // All cases of a check, in as many processes as it takes.
  Outcome run_check(const Job& job) const;
  Outcome compare_runs(const std::string& check) const;
  bool run_gates(Report& report);
  void run_rest(Report& report);
  void add(Report& report, CheckResult result);
  void skip_rest(Report& report, const std::string& why);

  const CheckOptions& options_;
  const std::function<void(const CheckResult&)>& finished_;
  WatchLimits limits_;
  std::vector<core::ParameterEntry> parameters_;
  process::FileDescriptor record_;
  std::mutex mutex_;
};

constexpr std::array<const char*, 11> kOrder{"abi",           "descriptor",  "life_cycle", "unload",
                                             "two_instances", "determinism", "real_time",  "values",
                                             "parameters",    "state",       "budget"};

void Checker::read_parameters() {
  if (!options_.config) {
    return;
  }
  const core::Configuration configuration = core::read_configuration(*options_.config);
  const std::string file = options_.plugin.filename().string();
  const auto found = std::ranges::find_if(configuration.plugins, [&file](const core::PluginEntry& entry) {
    return std::filesystem::path(entry.library).filename() == file;
  });
  if (found == configuration.plugins.end()) {
    throw CheckError(fmt::format("{}: has no plug-in with the library {}. Add it, or leave --config out",
                                 options_.config->string(), file));
  }
  parameters_ = found->parameters;
}

void Checker::record_walk() {
  record_ = process::FileDescriptor(memfd_create("plugin_check_walk", MFD_CLOEXEC));
  Board board;
  const WorkerEnding ending = run_forked(board, {std::chrono::minutes(2), std::chrono::minutes(2)}, [&] {
    try {
      record_nominal_walk(options_.robot, options_.walk_config, options_.plugin_path, options_.seed)
          .save(record_.get());
    } catch (const std::exception& error) {
      std::snprintf(board.page().crash.data(), board.page().crash.size(), "%s", error.what());
      _exit(98);
    }
  });
  if (ending.ending != Ending::finished) {
    throw CheckError(fmt::format("there is no walk to take the inputs from: {}", ending.what));
  }
}

Job Checker::job(const std::string& check, const std::string& variant) const {
  return {.check = check,
          .variant = variant,
          .plugin = options_.plugin,
          .robot = options_.robot,
          .configuration = options_.config.value_or("defaults"),
          .parameters = parameters_,
          .seed = options_.seed,
          .full = options_.full,
          .budget_ms = options_.budget_ms,
          .first_case = 0};
}

Outcome Checker::run_check(const Job& asked) const {
  Outcome outcome;
  outcome.result.check = asked.check;
  Job job = asked;
  const auto start = Clock::now();
  for (int deaths = 0; deaths < kMostDeaths; ++deaths) {
    Board board;
    outcome.ending = run_worker_process(job, board, record_.get(), limits_);
    read_lines(board, outcome);
    if (outcome.ending.ending == Ending::finished) {
      const auto digests = board.digests();
      outcome.digests.assign(digests.begin(), digests.end());
      break;
    }
    outcome.result.findings.push_back(finding_of(outcome.ending));
    const std::uint32_t next_case = board.page().case_index + 1;
    if (board.page().case_name[0] == '\0' || outcome.ending.ending == Ending::hung) {
      break;  // before the first case, or it would take too long to go on
    }
    job.first_case = next_case;
  }
  if (outcome.untried > 0) {
    outcome.result.remark += fmt::format("; no time for {} cases, --full tries all", outcome.untried);
    outcome.result.figures["untried"] = outcome.untried;
  }
  outcome.result.seconds = seconds_since(start);
  return outcome;
}

Outcome Checker::compare_runs(const std::string& check) const {
  const bool determinism = check == "determinism";
  Outcome first = run_check(job(check, "first"));
  const Outcome second = run_check(job(check, "second"));
  first.result.seconds += second.result.seconds;
  if (!first.result.findings.empty() || !second.result.findings.empty()) {
    first.result.findings.insert(first.result.findings.end(), second.result.findings.begin(),
                                 second.result.findings.end());
    return first;
  }
  first.result.remark = fmt::format("{} outputs compared", first.digests.size());
  const auto [mine, other] =
      std::mismatch(first.digests.begin(), first.digests.end(), second.digests.begin(), second.digests.end());
  if (mine == first.digests.end() && other == second.digests.end()) {
    return first;
  }
  const std::uint32_t tick = mine == first.digests.end() ? other->tick : mine->tick;
  first.result.findings.push_back(
      determinism
          ? Finding{"gives other outputs for the same inputs in another process",
                    fmt::format("tick {}", tick),
                    "look for variables that nobody initialised, for addresses that decide an order, and for "
                    "clocks and random numbers; valgrind shows the first"}
          : Finding{"gives other outputs when a second instance runs beside it", fmt::format("tick {}", tick),
                    "move static and global variables into the plug-in's class"});
  return first;
}

void Checker::add(Report& report, CheckResult result) {
  const std::lock_guard lock(mutex_);
  finished_(result);
  report.results.push_back(std::move(result));
}

void Checker::skip_rest(Report& report, const std::string& why) {
  for (const char* const check : kOrder) {
    const bool done = std::ranges::any_of(
        report.results, [check](const CheckResult& result) { return result.check == check; });
    if (!done) {
      CheckResult result;
      result.check = check;
      result.skipped = why;
      add(report, result);
    }
  }
}

// What everything else stands on: the file loads, an instance can be made, the right order of calls works.
bool Checker::run_gates(Report& report) {
  const Outcome abi = run_check(job("abi"));
  report.name = abi.result.figures.value("name", "");
  report.version = abi.result.figures.value("version", "");
  add(report, abi.result);
  if (abi.unusable || abi.ending.ending != Ending::finished) {
    skip_rest(report, "the library cannot be loaded");
    return false;
  }
  Outcome descriptor = run_check(job("descriptor"));
  Outcome life_cycle;
  life_cycle.result.check = "life_cycle";
  bool usable = !descriptor.unusable && descriptor.ending.ending == Ending::finished;
  if (descriptor.ending.ending != Ending::finished) {
    life_cycle.result.findings = std::exchange(descriptor.result.findings, {});
  } else if (descriptor.unusable) {
    life_cycle.result.findings.push_back({descriptor.not_usable, "create",
                                          "let it start with its defaults; give "
                                          "parameters that have none with --config"});
  }
  add(report, descriptor.result);
  if (usable) {
    life_cycle = run_check(job("life_cycle"));
    const bool died_in_order = life_cycle.ending.place.starts_with("right order");
    usable = !life_cycle.unusable && !died_in_order;
    if (life_cycle.unusable) {
      life_cycle.result.findings.push_back({life_cycle.not_usable, "right order", "let it succeed"});
    }
  }
  add(report, life_cycle.result);
  if (!usable) {
    skip_rest(report, "the plug-in cannot be run; see life_cycle");
  }
  return usable;
}

void Checker::run_rest(Report& report) {
  // What is not deterministic cannot be compared, and what is shared by instances cannot be handed on.
  const auto comparisons = [&] {
    bool comparable = true;
    for (const char* const check : {"determinism", "two_instances", "state"}) {
      if (comparable) {
        Outcome outcome = check == std::string_view("state") ? run_check(job(check)) : compare_runs(check);
        comparable = outcome.result.findings.empty();
        add(report, std::move(outcome.result));
      }
    }
    add(report, run_check(job("unload")).result);
  };
  const auto others = [&] {
    for (const char* const check : {"real_time", "values", "parameters"}) {
      add(report, run_check(job(check)).result);
    }
  };
  // Two at a time: no time is measured in these.
  std::future<void> beside = std::async(std::launch::async, comparisons);
  others();
  beside.get();
  add(report, run_check(job("budget")).result);
  skip_rest(report, "its outputs cannot be compared; see determinism and two_instances");
}

Report Checker::run() {
  Report report{.plugin = options_.plugin,
                .name = {},
                .version = {},
                .seed = options_.seed,
                .full = options_.full,
                .results = {},
                .seconds = 0.0};
  if (run_gates(report)) {
    run_rest(report);
  }
  std::ranges::sort(report.results, [](const CheckResult& a, const CheckResult& b) {
    const auto place = [](const CheckResult& r) { return std::ranges::find(kOrder, r.check); };
    return place(a) < place(b);
  });
  return report;
}

}  // namespace

Report check_plugin(const CheckOptions& options, const std::function<void(const CheckResult&)>& finished) {
  const auto start = Clock::now();
  CheckOptions absolute = options;
  std::error_code error;
  absolute.plugin = std::filesystem::canonical(options.plugin, error);
  if (error || !std::filesystem::is_regular_file(absolute.plugin)) {
    throw CheckError(fmt::format("{}: there is no such file. Build the plug-in, or correct the path",
                                 options.plugin.string()));
  }
  absolute.robot = std::filesystem::absolute(options.robot);
  Report report = Checker(absolute, finished).run();
  report.seconds = seconds_since(start);
  return report;
}

}  // namespace gaitway::plugin_check
