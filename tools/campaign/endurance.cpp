// Plays the hours, each robot in a process of its own.
#include "tools/campaign/endurance.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <fstream>
#include <list>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>

#include "gaitway/facts/random_stream.hpp"
#include "gaitway/process/working_copy.hpp"
#include "gaitway/simulator/cosimulation.hpp"
#include "tools/campaign/fault_run.hpp"
#include "tools/campaign/fault_trial.hpp"

namespace gaitway::tools {
namespace {

constexpr double kFirstFault_s = 5.0;
constexpr double kBetweenOrders_s = 10.0;  // of walks: a robot that stands is asked anew
constexpr double kRemembered_s = 10.0;     // faults that may explain a fall
constexpr double kRepaired_s = 8.0;        // after the last fault: the longest of them takes 5 s
constexpr double kAfterFall_s = 2.0;       // that a fall's scenario shows
constexpr double kStep_m = 0.05;           // way that counts as walking
constexpr double kToldEvery_s = 60.0;
constexpr std::int64_t kLook_ns = 100'000'000;  // at the way

std::uint64_t resident_KiB() {
  std::uint64_t all = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) / 1024;
}

// Whether the fault goes by itself.
bool passes(const simulator::ScenarioEvent& event) {
  return std::visit(
      [](const auto& action) {
        using Action = std::decay_t<decltype(action)>;
        if constexpr (std::is_same_v<Action, simulator::JointDiesFault>) {
          return false;
        } else if constexpr (std::is_same_v<Action, simulator::PluginFault> ||
                             std::is_same_v<Action, simulator::SensorFault> ||
                             std::is_same_v<Action, simulator::MainControllerSilentFault> ||
                             std::is_same_v<Action, simulator::MessageControllerSilentFault>) {
          return action.duration_s > 0.0;
        } else {
          return true;
        }
      },
      event.action);
}

class EnduranceWalk {
 public:
  EnduranceWalk(const TrialRobot& robot, const std::vector<FaultRow>& rows, const EnduranceOptions& options,
                int number)
      : robot_(robot),
        rows_(rows),
        options_(options),
        random_(static_cast<std::uint64_t>(number), 0xE2D0'4A2CE0ULL),
        seed_(static_cast<std::uint64_t>(number)) {
    run_.robot = number;
  }

  EnduranceRun play(const std::function<void(double played_s)>& tell);

 private:
  void begin();
  void order_walk();
  void draw_fault();
  void note_event(const std::string& action);
  void look_at_joints();
  void watch_way();
  void note_fall();
  [[nodiscard]] double now_s() const { return static_cast<double>(walk_->now_ns()) * 1e-9; }

  const TrialRobot& robot_;
  const std::vector<FaultRow>& rows_;
  const EnduranceOptions& options_;
  facts::RandomStream random_;
  std::uint64_t seed_;
  EnduranceRun run_;
  std::unique_ptr<simulator::Cosimulation> walk_;
  double before_s_ = 0.0;  // played with robots that have fallen
  double next_fault_s_ = 0.0, next_order_s_ = 0.0, last_fault_s_ = 0.0;
  std::deque<std::pair<simulator::ScenarioEvent, std::string>> waiting_;  // with their texts
  std::deque<std::pair<double, std::string>> met_;
  std::string events_;  // that this robot has met, as a scenario has them
  Eigen::Vector2d place_m_ = Eigen::Vector2d::Zero();
  double walked_at_s_ = 0.0;
};

void EnduranceWalk::begin() {
  walk_.reset();  // two of them would need twice the memory
  walk_ = std::make_unique<simulator::Cosimulation>(robot_.model, walk_options(robot_, seed_));
  next_fault_s_ = kFirstFault_s;
  next_order_s_ = kWalkFrom_s;
  last_fault_s_ = walked_at_s_ = 0.0;
  waiting_.clear();
  met_.clear();
  events_.clear();
  place_m_ = walk_->plant().truth().base.translation().head<2>();
}

void EnduranceWalk::order_walk() {
  next_order_s_ += kBetweenOrders_s;
  const double speed = options_.speed_m_per_s * (0.5 + 0.5 * random_.uniform());
  const double turn = 0.4 * (random_.uniform() - 0.5);
  note_event(fmt::format("walk: [{}, 0, {}]", speed, turn));
  walk_->apply(
      {now_s(), simulator::WalkEvent{.velocity_m_per_s = {speed, 0.0}, .turn_rate_rad_per_s = turn}});
}

void EnduranceWalk::note_event(const std::string& action) {
  events_ += fmt::format("  - {{at_s: {:.3f}, {}}}\n", now_s(), action);
}

void EnduranceWalk::draw_fault() {
  look_at_joints();
  const FaultRow& row = rows_[random_.next() % rows_.size()];
  ++run_.faults[row.name];
  FaultTrial trial{.row = row.name, .instant_s = now_s(), .actions = row.draw(random_)};
  std::vector<simulator::ScenarioEvent> events = events_of(trial, robot_.model);
  for (std::size_t i = 0; i < events.size(); ++i) {
    waiting_.emplace_back(std::move(events[i]), trial.actions[i].text);
  }
  met_.emplace_front(now_s(), row.name);
  last_fault_s_ = now_s();
  next_fault_s_ = now_s() - options_.mean_pause_s * std::log(1.0 - random_.uniform());
}

void EnduranceWalk::look_at_joints() {
  if (now_s() - last_fault_s_ < kRepaired_s) return;
  ++run_.looks;
  for (int joint = 0; joint < walk_->joints().size(); ++joint) {
    const bool right =
        walk_->joints().joint(joint).reference_count() == walk_->message_controller().expected_count(joint);
    run_.wrong_joints += right ? 0 : 1;
  }
}

void EnduranceWalk::watch_way() {
  const Eigen::Vector2d place_m = walk_->plant().truth().base.translation().head<2>();
  const double way_m = (place_m - place_m_).norm();
  if (way_m >= kStep_m) {
    run_.walked_m += way_m;
    place_m_ = place_m;
    walked_at_s_ = now_s();
  }
  run_.longest_stand_s = std::max(run_.longest_stand_s, now_s() - walked_at_s_);
}

void EnduranceWalk::note_fall() {
  EnduranceFall fall{.at_s = before_s_ + now_s(), .rows = {}, .seed = seed_, .scenario = {}};
  fall.scenario = fmt::format(
      "# A fall of the fault campaign's hours: play it with --seed {}.\n"
      "seconds: {:.3f}\nevents:\n{}",
      seed_, now_s() + kAfterFall_s, events_);
  for (const auto& [at_s, row] : met_) {
    if (now_s() - at_s <= kRemembered_s) fall.rows.push_back(row);
  }
  run_.falls.push_back(std::move(fall));
  before_s_ += now_s();
  seed_ += static_cast<std::uint64_t>(options_.robots);
  begin();
}

EnduranceRun EnduranceWalk::play(const std::function<void(double)>& tell) {
  const double end_s = 3600.0 * options_.hours;
  double next_told_s = kToldEvery_s;
  begin();
  while (before_s_ + now_s() < end_s) {
    if (now_s() >= next_order_s_) order_walk();
    if (now_s() >= next_fault_s_) draw_fault();
    for (std::size_t left = waiting_.size(); left > 0; --left) {
      auto [event, text] = std::move(waiting_.front());
      waiting_.pop_front();
      if (event.at_s <= now_s()) {
        note_event(text);
        walk_->apply(event);
      } else {
        waiting_.emplace_back(std::move(event), std::move(text));
      }
    }
    walk_->advance_millisecond();
    if (walk_->now_ns() % kLook_ns == 0) watch_way();
    if (walk_->plant().fallen()) note_fall();
    const double played_s = before_s_ + now_s();
    if (run_.memory_first_KiB == 0 && played_s >= 0.1 * end_s) run_.memory_first_KiB = resident_KiB();
    if (played_s >= next_told_s) {
      next_told_s += kToldEvery_s;
      tell(played_s);
    }
  }
  run_.played_s = end_s;
  run_.memory_last_KiB = resident_KiB();
  return std::move(run_);
}

nlohmann::ordered_json to_json(const EnduranceRun& run) {
  nlohmann::ordered_json falls = nlohmann::ordered_json::array();
  for (const EnduranceFall& fall : run.falls) {
    falls.push_back(
        {{"at_s", fall.at_s}, {"faults", fall.rows}, {"seed", fall.seed}, {"scenario", fall.scenario}});
  }
  return {{"robot", run.robot},
          {"played_s", run.played_s},
          {"walked_m", run.walked_m},
          {"faults", run.faults},
          {"falls", falls},
          {"looks", run.looks},
          {"wrong_joints", run.wrong_joints},
          {"longest_stand_s", run.longest_stand_s},
          {"memory_first_KiB", run.memory_first_KiB},
          {"memory_last_KiB", run.memory_last_KiB}};
}

EnduranceRun endurance_from_json(const nlohmann::ordered_json& json) {
  EnduranceRun run;
  json.at("robot").get_to(run.robot);
  json.at("played_s").get_to(run.played_s);
  json.at("walked_m").get_to(run.walked_m);
  json.at("faults").get_to(run.faults);
  for (const auto& fall : json.at("falls")) {
    run.falls.push_back({fall.at("at_s").get<double>(), fall.at("faults").get<std::vector<std::string>>(),
                         fall.at("seed").get<std::uint64_t>(), fall.at("scenario").get<std::string>()});
  }
  json.at("looks").get_to(run.looks);
  json.at("wrong_joints").get_to(run.wrong_joints);
  json.at("longest_stand_s").get_to(run.longest_stand_s);
  json.at("memory_first_KiB").get_to(run.memory_first_KiB);
  json.at("memory_last_KiB").get_to(run.memory_last_KiB);
  return run;
}

}  // namespace

std::uint64_t EnduranceRun::fault_count() const {
  return std::accumulate(faults.begin(), faults.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const auto& row) { return sum + row.second; });
}

std::vector<FaultRow> passing_rows(const std::vector<FaultRow>& table, const urdf::RobotModel& robot) {
  std::vector<FaultRow> rows;
  std::ranges::copy_if(table, std::back_inserter(rows), [&robot](const FaultRow& row) {
    facts::RandomStream random(1, 1);
    const FaultTrial trial{.row = row.name, .actions = row.draw(random)};
    return row.expected == FaultExpectation::survives && std::ranges::all_of(events_of(trial, robot), passes);
  });
  return rows;
}

std::vector<EnduranceRun> run_endurance(const TrialRobot& robot, const std::vector<FaultRow>& rows,
                                        const EnduranceOptions& options) {
  struct Work {
    int number = 0;
    process::WorkingCopy copy;
  };
  std::vector<EnduranceRun> runs(static_cast<std::size_t>(options.robots));
  std::vector<double> played_s(runs.size(), 0.0);
  std::list<Work> at_work;
  int next = 1;
  while (next <= options.robots || !at_work.empty()) {
    for (; next <= options.robots && static_cast<int>(at_work.size()) < options.jobs; ++next) {
      at_work.push_back({next, process::WorkingCopy([&, next](const process::WorkingCopy::Tell& tell) {
                           EnduranceWalk walk(robot, rows, options, next);
                           const EnduranceRun run = walk.play(
                               [&tell](double so_far_s) { tell(nlohmann::ordered_json(so_far_s).dump()); });
                           tell(to_json(run).dump());
                         })});
    }
    std::vector<pollfd> told;
    for (const Work& work : at_work) told.push_back({work.copy.descriptor(), POLLIN, 0});
    if (poll(told.data(), told.size(), -1) < 0) continue;  // interrupted
    auto work = at_work.begin();
    for (const pollfd& one : told) {
      const auto here = work++;
      if (one.revents == 0) continue;
      const auto index = static_cast<std::size_t>(here->number - 1);
      for (const std::string& line : here->copy.listen()) {
        const auto json = nlohmann::ordered_json::parse(line);
        if (json.is_object()) runs[index] = endurance_from_json(json);
        played_s[index] = json.is_object() ? runs[index].played_s : json.get<double>();
      }
      if (here->copy.done()) at_work.erase(here);
    }
    if (options.progress) {
      options.progress(std::accumulate(played_s.begin(), played_s.end(), 0.0) /
                       (3600.0 * options.hours * options.robots));
    }
  }
  return runs;
}

nlohmann::ordered_json endurance_json(const std::vector<EnduranceRun>& runs) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const EnduranceRun& run : runs) {
    all.push_back(to_json(run));
    for (auto& fall : all.back()["falls"]) fall.erase("scenario");
  }
  return all;
}

std::string fall_file(const EnduranceRun& run, std::size_t fall) {
  return fmt::format("fall_{}_{}.yaml", run.robot, fall);
}

std::string endurance_markdown(const EnduranceOptions& options, const std::vector<EnduranceRun>& runs) {
  std::string text = fmt::format(
      "{} h of each robot, a fault every {} s on average, up to {} m/s.\n\n"
      "| robot | faults | falls | joints not put right after {} s | way m | longest stand s | memory after a "
      "tenth, "
      "at the end KiB |\n|---|---|---|---|---|---|---|\n",
      options.hours, options.mean_pause_s, options.speed_m_per_s, kRepaired_s);
  for (const EnduranceRun& run : runs) {
    text += fmt::format("| {} | {} | {} | {} of {} looks | {:.0f} | {:.1f} | {}, {} |\n", run.robot,
                        run.fault_count(), run.falls.size(), run.wrong_joints, run.looks, run.walked_m,
                        run.longest_stand_s, run.memory_first_KiB, run.memory_last_KiB);
  }
  for (const EnduranceRun& run : runs) {
    for (std::size_t i = 0; i < run.falls.size(); ++i) {
      const EnduranceFall& fall = run.falls[i];
      text += fmt::format(
          "\nRobot {} fell at {:.1f} s, after: {}. Play it: gaitway run --scenario {} --seed {}\n", run.robot,
          fall.at_s,
          fall.rows.empty() ? "no fault in ten seconds" : fmt::format("{}", fmt::join(fall.rows, ", ")),
          fall_file(run, i), fall.seed);
    }
  }
  return text;
}

}  // namespace gaitway::tools
