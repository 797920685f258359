// What one process of a check is asked to do, and how it is started, watched over and ended.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "gaitway/instance/configuration.hpp"
#include "tools/check_plugin/board.hpp"

namespace gaitway::plugin_check {

struct Job {
  std::string check;
  std::string variant;  // of a check that runs more than once
  std::filesystem::path plugin;
  std::filesystem::path robot;
  std::filesystem::path configuration;  // the file of `parameters`
  std::vector<core::ParameterEntry> parameters;
  std::uint64_t seed = 1;
  bool full = false;
  double budget_ms = 0.0;
  std::uint32_t first_case = 0;  // those before were done by a process that died
};

std::string to_text(const Job& job);
Job read_job(const std::string& text);

// Numbers of the two descriptors that the process is born with.
inline constexpr int kBoardDescriptor = 100;
inline constexpr int kRecordDescriptor = 101;

enum class Ending : std::uint8_t { finished, crashed, hung };

struct WorkerEnding {
  Ending ending = Ending::finished;
  std::string what;   // of a crash: the signal, and where in the plug-in; of a hang: how long
  std::string place;  // what it was doing
};

struct WatchLimits {
  std::chrono::milliseconds silence{5000};  // between two calls into the plug-in
  std::chrono::milliseconds total{120000};
};

// Runs this executable with kWorkerCommand. `record_fd`: the recorded walk, or -1.
WorkerEnding run_worker_process(const Job& job, Board& board, int record_fd, const WatchLimits& limits);

// The same watch over a copy of this process that runs `work`, for what is not the plug-in's own check.
WorkerEnding run_forked(Board& board, const WatchLimits& limits, const std::function<void()>& work);

}  // namespace gaitway::plugin_check
