// Check `values`: outputs are finite, in range and continuous on good inputs, and finite and in range
// whatever happens to the inputs.
#include <fmt/format.h>

#include <set>

#include "tools/check_plugin/call_guard.hpp"
#include "tools/check_plugin/check_run.hpp"
#include "tools/check_plugin/topic_rules.hpp"

namespace gaitway::plugin_check {
namespace {

constexpr std::uint64_t kFaultBegin = 80;
constexpr std::uint64_t kFaultEnd = 240;
constexpr std::uint64_t kCaseEnd = 400;
constexpr std::uint64_t kRecovery = 80;  // ticks
constexpr int kMostFindings = 3;         // of a case

class Watcher {
 public:
  Watcher(CheckRun& run, OutputRules& rules, bool continuity)
      : run_(run), rules_(rules), continuity_(continuity) {}

  void look(const Specimen& specimen, const std::list<Port>& ports) {
    for (const Port& port : ports) {
      if (!port.is_output() || !port.published) {
        continue;
      }
      ++published_;
      if (const auto number = rules_.non_finite(port)) {
        report(*number, specimen,
               "publish nothing, or the last good value, where a number cannot be computed");
      } else if (const auto range = rules_.out_of_range(port)) {
        report(*range, specimen, "limit what is published, and check what is divided by");
      } else if (const auto jump = continuity_ ? rules_.jump(port) : std::nullopt) {
        report(*jump, specimen, "start from the last value and fade to the new one");
      }
    }
  }
  [[nodiscard]] std::uint64_t published() const noexcept { return published_; }

 private:
  void report(const std::string& what, const Specimen& specimen, const char* remedy) {
    const std::string topic = what.substr(0, what.find_first_of("[ "));
    if (reported_.size() < kMostFindings && reported_.insert(topic).second) {
      run_.finding(what, fmt::format("tick {}", specimen.board().page().tick.load()), remedy);
    }
  }

  CheckRun& run_;
  OutputRules& rules_;
  bool continuity_;
  std::set<std::string> reported_;
  std::uint64_t published_ = 0;
};

struct Case {
  std::string name;
  InputFault fault;
};

std::vector<Case> cases_of(const std::list<Port>& ports) {
  using Kind = InputFault::Kind;
  std::vector<Case> cases{{"all inputs frozen", {Kind::frozen}},
                          {"all inputs missing", {Kind::missing}},
                          {"all inputs not a number", {Kind::not_a_number}}};
  std::set<std::string> topics;
  bool joints = false;
  for (const Port& port : ports) {
    if (port.recorded != nullptr && topics.insert(port.topic).second) {
      cases.push_back({fmt::format("'{}' frozen", port.topic), {Kind::frozen, port.topic}});
      cases.push_back({fmt::format("'{}' missing", port.topic), {Kind::missing, port.topic}});
      cases.push_back({fmt::format("'{}' not a number", port.topic), {Kind::not_a_number, port.topic}});
      joints |= port.topic == "joint_states" || port.topic == "joint_plan";
    }
  }
  for (const std::uint32_t count : {0U, 1U, 21U, 23U, 64U, 65U, 0xffffffffU}) {
    if (joints) {
      cases.push_back({fmt::format("joint_count = {}", count), {Kind::joint_count, "", count}});
    }
  }
  return cases;
}

// Every output on the undisturbed walk. Returns how many values were published.
std::uint64_t try_nominal(CheckRun& run, const SpecimenLibrary& library, const urdf::RobotModel& robot) {
  OutputRules rules(robot);
  Watcher watcher(run, rules, true);
  Specimen specimen(library, run.job(), &run.record());
  specimen.create();
  specimen.activate();
  bool refused = false;
  for (std::uint64_t n = 0; n < run.record().ticks(); ++n) {
    const std::uint64_t thrown = exceptions_thrown();
    // A throw is the finding of the check `real_time`.
    if (!specimen.step(run.record(), n) && !refused && exceptions_thrown() == thrown) {
      refused = true;
      run.finding(fmt::format("a step fails on good inputs: {}", specimen.error()),
                  fmt::format("tick {}", run.board().page().tick.load()), "a failed step costs a batch");
    }
    watcher.look(specimen, specimen.host().ports());
  }
  specimen.abandon();
  return watcher.published();
}

void try_fault(CheckRun& run, const SpecimenLibrary& library, const urdf::RobotModel& robot,
               const Case& tried, bool publishes) {
  OutputRules rules(robot);
  Watcher watcher(run, rules, false);
  Specimen specimen(library, run.job(), &run.record());
  specimen.create();
  specimen.activate();
  // What was never there is missing from the start.
  const std::uint64_t begin = tried.fault.kind == InputFault::Kind::missing ? 0 : kFaultBegin;
  std::uint64_t before_recovered = 0;
  for (std::uint64_t n = 0; n < kCaseEnd; ++n) {
    const bool faulty = n >= begin && n < kFaultEnd;
    specimen.step(run.record(), n, faulty ? tried.fault : InputFault{});
    watcher.look(specimen, specimen.host().ports());
    if (n + kRecovery == kCaseEnd) {
      before_recovered = watcher.published();
    }
  }
  if (publishes && watcher.published() == before_recovered) {
    run.finding("publishes nothing any more, although its inputs are good again", "",
                "forget a fault when it is over; a value that is not a number may not enter a filter");
  }
  specimen.abandon();
}

}  // namespace

void check_values(CheckRun& run) {
  const urdf::RobotModel robot = urdf::load_robot(run.job().robot);
  const SpecimenLibrary library(run.job().plugin, run.board());
  const bool first = run.begin("good inputs");
  std::uint64_t published = first ? try_nominal(run, library, robot) : 1;
  Specimen declared(library, run.job(), &run.record());
  declared.create();
  const std::vector<Case> cases = cases_of(declared.host().ports());
  declared.abandon();
  // Where good inputs give bad values, bad inputs say nothing.
  const bool usable = run.findings() == 0;
  for (const Case& tried : cases) {
    if (usable && run.begin(tried.name)) {
      try_fault(run, library, robot, tried, published > 0);
    }
  }
  if (first) {
    run.figure("published", published);
  }
  run.remark(fmt::format("{} values on a walk, {} kinds of bad input", published, cases.size()));
}

}  // namespace gaitway::plugin_check
