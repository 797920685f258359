// Bus logs in candump's format: one line a frame, "(seconds.microseconds) can0 123#0011223344556677".
// Extended identifiers have eight digits; a remote frame is "123#R" and the number of bytes it asks for,
// unless that is zero; what an interface reports about errors is an extended frame with bit 29 of the
// identifier set
// ("20000004#…", classes and bytes of linux/can/error.h).
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/can/frame.hpp"

namespace gaitway::can {

class CandumpWriter {
 public:
  // Throws std::runtime_error naming the file when it cannot be created.
  explicit CandumpWriter(const std::filesystem::path& file);
  // Writes what is buffered, so that the log of a run that ends with an exception is whole, too.
  ~CandumpWriter();
  CandumpWriter(CandumpWriter&&) noexcept = default;
  CandumpWriter& operator=(CandumpWriter&&) = delete;
  // `time_ns` must not be negative.
  void write(std::int64_t time_ns, const Frame& frame);
  // A report about errors: its classes (29 bits) and its bytes.
  void write_error(std::int64_t time_ns, std::uint32_t classes, const std::array<std::uint8_t, 8>& data);
  // Writes what is buffered and closes; throws std::runtime_error naming the file when something was not
  // written.
  void close();

 private:
  void begin_line(std::int64_t time_ns);
  void append_hex(std::uint32_t value, int digits);
  void append_bytes(std::span<const std::uint8_t> bytes);
  void end_line();
  void flush();
  std::filesystem::path path_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  std::string buffer_;
  bool failed_ = false;
};

struct LoggedFrame {
  std::int64_t time_ns = 0;
  Frame frame;         // of a report about errors: its classes as identifier, extended
  bool error = false;  // no frame of the bus but an interface's report about errors
};

// One line; throws std::invalid_argument saying which rule it breaks.
LoggedFrame parse_candump_line(std::string_view line);
// A whole log; throws std::runtime_error naming file, line and rule.
std::vector<LoggedFrame> read_candump_log(const std::filesystem::path& file);

}  // namespace gaitway::can
