// Bus logs in candump's format: one line a frame, "(seconds.microseconds) can0 123#0011223344556677".
// Extended identifiers have eight digits; a remote frame is "123#R" and the number of bytes it asks for,
// unless that is zero; what an interface reports about errors is an extended frame with bit 29 of the
// identifier set
// ("20000004#…", classes and bytes of linux/can/error.h).
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/can/frame.hpp"
#include "gaitway/process/background_log.hpp"
#include "gaitway/process/log_file.hpp"

namespace gaitway::can {

struct CandumpOptions {
  // Who writes waits for no disk: a thread takes each line there by itself (process/background_log.hpp).
  // Otherwise lines go there in blocks, by whoever writes them.
  bool in_real_time = false;
  process::LogOptions::Start start = process::LogOptions::Start::anew;
  std::uint64_t most_bytes = 0;  // of a file; see process::LogOptions
  // Hears, for people, that lines are being lost, and when that is over; in real time only.
  std::function<void(const std::string& news)> tell{};
};

// Every line in the file is whole. A full disk costs lines, which are counted, and nothing else.
class CandumpWriter {
 public:
  // Throws std::runtime_error naming the file when it cannot be created.
  explicit CandumpWriter(const std::filesystem::path& file, CandumpOptions options = {});
  // As finish(), so that the log of a run that ends with an exception is whole, too.
  ~CandumpWriter();
  CandumpWriter(CandumpWriter&&) noexcept = default;
  CandumpWriter& operator=(CandumpWriter&&) = delete;
  // `time_ns` must not be negative.
  void write(std::int64_t time_ns, const Frame& frame);
  // A report about errors: its classes (29 bits) and its bytes.
  void write_error(std::int64_t time_ns, std::uint32_t classes, const std::array<std::uint8_t, 8>& data);
  // Takes what waits on its way to the disk. In real time nothing waits here.
  void flush() noexcept;
  // Frames in the file, and those that are missing, so far.
  [[nodiscard]] process::LogCount count() const noexcept;
  // Writes what waits, and ends: how many frames are in the log, and how many are missing.
  process::LogCount finish() noexcept;
  // The same; throws std::runtime_error naming the file when some are missing.
  void close();
  // Why, the last time; in real time it was told. Empty: none are missing, or it was told.
  [[nodiscard]] std::string error() const;

 private:
  void begin_line(std::int64_t time_ns);
  void append_hex(std::uint32_t value, int digits);
  void append_bytes(std::span<const std::uint8_t> bytes);
  void end_line();
  std::filesystem::path path_;
  std::unique_ptr<process::LogFile> file_;  // one of the two
  std::unique_ptr<process::BackgroundLog> background_;
  std::string buffer_;
};

struct LoggedFrame {
  std::int64_t time_ns = 0;
  Frame frame;         // of a report about errors: its classes as identifier, extended
  bool error = false;  // no frame of the bus but an interface's report about errors
};

// One line; throws std::invalid_argument saying which rule it breaks.
LoggedFrame parse_candump_line(std::string_view line);
// A whole log; throws std::runtime_error naming file, line and rule. A last line without its end is what a
// killed writer has left of it, and dropped.
std::vector<LoggedFrame> read_candump_log(const std::filesystem::path& file);

}  // namespace gaitway::can
