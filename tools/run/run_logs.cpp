// Collects lines, and brings them to the disk once a second.
#include "tools/run/run_logs.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "gaitway/core/events.hpp"
#include "gaitway/process/text_file.hpp"

namespace gaitway::tools {
namespace {

constexpr std::chrono::seconds kBetweenFlushes{1};
constexpr std::uint64_t kEvents_bytes = std::uint64_t{16} << 20;  // of what runs for long; and those before
constexpr std::uint64_t kSpare_bytes = std::uint64_t{256} << 10;

nlohmann::ordered_json loss_json(std::uint64_t lines, std::uint64_t lost, const std::string& reason) {
  nlohmann::ordered_json result = {{"lines", lines}, {"lost", lost}};
  if (lost != 0) result["reason"] = reason;
  return result;
}

}  // namespace

// A main controller that was started again begins a log of its own.
void EventsFile::follow(const core::EventLog& events) {
  if (std::exchange(serial_, events.serial()) != events.serial()) next_ = 0;
  if (next_ < events.first()) {
    left_out_ += events.first() - next_;
    next_ = events.first();
  }
  for (; next_ < events.total(); ++next_) core::append_event_line(waiting_, events[next_]);
  if (!waiting_.empty()) log_.append(waiting_);
  waiting_.clear();
}

RunLogs::RunLogs(const std::filesystem::path& folder, const urdf::RobotModel& robot, RunRecorder& recorder,
                 std::function<void(const std::string&)> tell)
    : folder_(folder),
      recorder_(recorder),
      room_(folder, kSpare_bytes),
      events_(folder / "events.jsonl", recorder.keeps_samples() ? 0 : kEvents_bytes),
      tell_(std::move(tell)),
      next_(std::chrono::steady_clock::now()) {
  if (recorder.keeps_samples()) states_.emplace(folder / "states.csv", robot);
  for (const char* const result : {"summary.json", "report.html", "walk.png"}) {
    std::filesystem::remove(folder / result);
  }
}

void RunLogs::look(const core::EventLog& events, const Summary& summary) {
  if (states_) states_->follow(recorder_.samples());
  events_.follow(events);
  const auto now = std::chrono::steady_clock::now();
  if (now < next_) return;
  next_ = now + kBetweenFlushes;
  flush(events);
  nlohmann::ordered_json so_far = summary();
  write_summary(so_far, false);
}

void RunLogs::finish(const core::EventLog& events) {
  recorder_.finish();
  flush(events);
  room_.give_back();
}

void RunLogs::flush(const core::EventLog& events) {
  if (states_) {
    states_->follow(recorder_.samples());
    states_->flush();
  }
  events_.follow(events);
  recorder_.flush();
  tell_losses();
}

void RunLogs::tell_losses() {
  const BusLogCount bus = recorder_.bus_log();
  if (bus.lost != 0) tell_once("bus.log", bus.error);
  if (states_ && states_->log().lost() != 0) tell_once("states.csv", states_->log().error());
  if (events_.log().lost() != 0) tell_once("events.jsonl", events_.log().error());
}

void RunLogs::tell_once(const std::string& name, const std::string& news) {
  if (told_.insert(name).second) {
    tell_(fmt::format("{}: lines are being lost: {}", (folder_ / name).string(), news));
  }
}

void RunLogs::write_summary(nlohmann::ordered_json& summary, bool ended) {
  summary["ended"] = ended;
  if (!ended) {
    summary["outcome"] = "not ended";
    summary["result"] = "has not ended: so far as it has come, or had, when it was killed";
  }
  summary["logs"] = json();
  const auto write = [&] { process::replace_text_file(folder_ / "summary.json", summary.dump(2) + "\n"); };
  if (ended) {
    try_to(write);
    return;
  }
  room_.give_back();
  try {
    write();
  } catch (const std::runtime_error& error) {
    if (told_.insert("summary.json").second) tell_(error.what());
  }
  room_.take();
}

void RunLogs::try_to(const std::function<void()>& write) {
  try {
    write();
  } catch (const std::runtime_error& error) {
    all_results_ = false;
    tell_(error.what());
  }
}

bool RunLogs::complete() const {
  return all_results_ && recorder_.bus_log().lost == 0 && (!states_ || states_->log().lost() == 0) &&
         events_.lost() == 0;
}

nlohmann::ordered_json RunLogs::json() const {
  const BusLogCount bus = recorder_.bus_log();
  nlohmann::ordered_json result = {{"complete", complete()},
                                   {"bus.log", loss_json(bus.lines, bus.lost, bus.error)}};
  if (states_) {
    result["states.csv"] = loss_json(states_->log().lines(), states_->log().lost(), states_->log().error());
  }
  result["events.jsonl"] = loss_json(events_.log().lines(), events_.lost(),
                                     events_.log().lost() != 0 ? events_.log().error() : "too many at once");
  return result;
}

}  // namespace gaitway::tools
