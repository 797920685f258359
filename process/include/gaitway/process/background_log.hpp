// A log that its writer never waits for: lines are handed over in memory, and a thread of its own takes them
// to the disk. What a slow or full disk has no room for is lost, counted and told.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "gaitway/process/log_file.hpp"

namespace gaitway::process {

struct BackgroundLogOptions {
  std::size_t waiting_bytes = std::size_t{256} << 10;  // for the disk, at most; a power of two
  // A line, with its end, that stands in the log where others are missing: how many, and why. None: nothing
  // stands there.
  std::function<std::string(std::uint64_t lost, const std::string& reason)> gap_line{};
  // Hears, in the log's thread, that lines are being lost, and when that is over; each once, for people.
  // None: nobody does.
  std::function<void(const std::string& news)> tell{};
};

// As print of a BackgroundLogOptions::tell: "PROGRAM: NEWS" on stderr.
[[nodiscard]] std::function<void(const std::string&)> tell_on_stderr(std::string program);

struct LogCount {
  std::uint64_t lines = 0;  // on the disk, or in the system's memory on the way to it
  std::uint64_t lost = 0;
};

class BackgroundLog {
 public:
  // Starts the thread.
  explicit BackgroundLog(LogFile file, BackgroundLogOptions options = {});
  BackgroundLog(const BackgroundLog&) = delete;
  BackgroundLog& operator=(const BackgroundLog&) = delete;
  // As close().
  ~BackgroundLog();

  // One thread, in real time: one line, with its end, is copied; no allocation, no lock, and one system call
  // at most, that wakes the log's thread. False: there was no room, and the line is lost.
  bool add(std::string_view line) noexcept;
  // Writes what waits, and ends: others may write the file then. A disk that takes nothing for half a second
  // is left to itself. What has not arrived by then counts as lost.
  LogCount close() noexcept;
  // Any thread, so far.
  [[nodiscard]] LogCount count() const noexcept;

 private:
  class Desk;
  std::shared_ptr<Desk> desk_;  // the thread's, too
  std::optional<LogCount> closed_;
};

}  // namespace gaitway::process
