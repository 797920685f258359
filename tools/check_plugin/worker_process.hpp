// Starts a process of a check, watches over it, and says how it ended.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "tools/check_plugin/board.hpp"
#include "tools/check_plugin/job.hpp"

namespace gaitway::plugin_check {

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
