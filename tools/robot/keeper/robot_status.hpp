// How a robot and its parts are, as its supervisor writes it down and `gaitway robot status` shows it.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace gaitway::tools {

struct PartStatus {
  std::string name;
  std::string state;                           // waits, starts, works, ends, off
  pid_t process = 0;                           // 0: there is none
  pid_t worker = 0;                            // the one of its processes that does the work
  std::int64_t since_ns = 0, progress_ns = 0;  // CLOCK_MONOTONIC
  std::uint64_t restarts = 0;
  std::uint64_t failures = 0;  // one after the other
  bool real_time = false;
  std::string reason;            // of its last end; empty: it has not ended
  std::int64_t last_end_ns = 0;  // CLOCK_MONOTONIC, too
};

struct RobotStatus {
  pid_t supervisor = 0;
  std::int64_t written_ns = 0, up_ns = 0;
  bool may_be_commanded = false;
  std::int64_t commanded_since_ns = 0;
  std::string why_not;           // why it may not be commanded; empty: it may
  std::string commander;         // who commands it; empty: that is not known
  std::uint64_t lost_lines = 0;  // of the event file
  std::string events;            // that file
  std::vector<PartStatus> parts;

  [[nodiscard]] bool all_work() const;
  void deny_command(const std::string& why);  // where whoever reads it knows better
};

// Replaces the file as a whole; false: it could not be.
bool write_status(const std::filesystem::path& file, const RobotStatus& status);
// Nothing: there is none.
[[nodiscard]] std::optional<RobotStatus> read_status(const std::filesystem::path& file);
// As JSON, for programs. `supervised`: the supervisor lives.
[[nodiscard]] std::string status_text(const RobotStatus& status, bool supervised, std::int64_t now_ns);
// As a table, for people.
[[nodiscard]] std::string status_table(const RobotStatus& status, bool supervised, std::int64_t now_ns);

}  // namespace gaitway::tools
