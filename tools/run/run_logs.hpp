// The files of a run that grow while it runs, so that a kill leaves what had happened, and a full disk costs
// lines and not the run: samples (states.csv), events (events.jsonl), and a summary that says that it is not
// the last one. The recorder's bus.log belongs to them.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <span>
#include <string>

#include "gaitway/instance/event_log.hpp"
#include "gaitway/process/log_file.hpp"
#include "gaitway/process/spare_room.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "tools/run/run_recorder.hpp"

namespace gaitway::tools {

// states.csv: a header line with units, then one line a sample; opens in PlotJuggler.
class StatesCsv {
 public:
  // Throws std::runtime_error naming the file when it cannot be created.
  StatesCsv(const std::filesystem::path& file, const urdf::RobotModel& robot);
  // Takes up what is new since the last call; to the disk in blocks.
  void follow(std::span<const RunSample> samples);
  void flush();
  [[nodiscard]] const process::LogFile& log() const noexcept { return log_; }

 private:
  process::LogFile log_;
  std::string waiting_;
  std::size_t taken_ = 0;
};

// events.jsonl: all that plug-ins, manager and message controller had to say.
class EventsFile {
 public:
  // `most_bytes`: see process::LogOptions.
  EventsFile(const std::filesystem::path& file, std::uint64_t most_bytes)
      : log_(file, {.most_bytes = most_bytes}) {}
  void follow(const core::EventLog& events);
  // Those that the log of the main controller gave up between two calls are lost as well.
  [[nodiscard]] std::uint64_t lost() const noexcept { return log_.lost() + left_out_; }
  [[nodiscard]] const process::LogFile& log() const noexcept { return log_; }

 private:
  process::LogFile log_;
  std::string waiting_;
  std::uint64_t serial_ = 0;  // of the log that next_ is of; 0: of none yet
  std::uint64_t next_ = 0, left_out_ = 0;
};

class RunLogs {
 public:
  using Summary = std::function<nlohmann::ordered_json()>;

  // Results of a run before are gone from then on: they would not belong to what else lies in the folder.
  // `tell` hears, for people, which log begins to lose lines. Throws std::runtime_error naming a file that
  // cannot be created, or that another run writes.
  RunLogs(const std::filesystem::path& folder, const urdf::RobotModel& robot, RunRecorder& recorder,
          std::function<void(const std::string& news)> tell);

  // After each millisecond. Once a second of wall time all goes to the disk, with a summary that is not
  // ended.
  void look(const core::EventLog& events, const Summary& summary);
  // Once the run has ended: writes what waits, and no more.
  void finish(const core::EventLog& events);
  // Writes a summary, with what has become of the logs; a run that has `ended` or not. What the disk does not
  // take is told, and no longer complete.
  void write_summary(nlohmann::ordered_json& summary, bool ended);
  // Writes a result by `write`; what the disk does not take is told.
  void try_to(const std::function<void()>& write);
  // Nothing is missing.
  [[nodiscard]] bool complete() const;

 private:
  void flush(const core::EventLog& events);
  void tell_losses();
  void tell_once(const std::string& name, const std::string& news);
  [[nodiscard]] nlohmann::ordered_json json() const;

  std::filesystem::path folder_;
  RunRecorder& recorder_;
  process::SpareRoom room_;          // for the summary and the report
  std::optional<StatesCsv> states_;  // of a recorder that keeps samples
  EventsFile events_;
  std::function<void(const std::string&)> tell_;
  std::set<std::string> told_;
  bool all_results_ = true;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace gaitway::tools
