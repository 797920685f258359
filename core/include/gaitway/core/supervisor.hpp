// The main controller under supervision: a crash in a plug-in ends its process; another one is started at
// once, without that plug-in. Meanwhile the message controller plays its safe tail. And one that has lost its
// message controller is started again when there is another one.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace gaitway::core {

struct SupervisorOptions {
  std::string program;                    // the main controller's executable
  std::vector<std::string> arguments;     // of the worker
  bool quiet = false;                     // reports deaths only
  std::filesystem::path memory_socket{};  // of the message controller; empty: it is not waited for
};

// Of a worker that has no message controller, or not any more.
inline constexpr int kExitLost = 3;

inline constexpr int kMostRestarts = 3;
inline constexpr std::int64_t kRestartWindow_ns = 60'000'000'000;
// A worker that has made ticks and makes none for so long hangs, and is ended.
inline constexpr std::int64_t kHang_ns = 1'000'000'000;
// And before its first tick one in which the same plug-in is being constructed or activated for so long.
inline constexpr std::int64_t kStartHang_ns = 5'000'000'000;
inline constexpr int kExitGivenUp = 4;

// Starts the worker with `--step-watch FD` and, after a crash or a hang, `--culprit NAME` of the plug-in that
// was being stepped or set up; a SIGKILL or SIGSTOP from outside is no plug-in's fault, and is not counted:
// the next start is at once, but a second after the one before at the earliest. One that ends with kExitLost
// is started again as soon as somebody answers at the memory block's socket. Returns when it ended by itself
// otherwise (its exit code), when it was told to by SIGINT or SIGTERM, or after more than kMostRestarts
// deaths in kRestartWindow_ns (kExitGivenUp). Throws std::system_error.
int supervise(const SupervisorOptions& options);

}  // namespace gaitway::core
