// Bus logs in candump's format: one line a frame, "(seconds.microseconds) can0 123#0011223344556677".
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
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
  // Writes what is buffered and closes; throws std::runtime_error naming the file when something was not
  // written.
  void close();

 private:
  void flush();
  std::filesystem::path path_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  std::string buffer_;
  bool failed_ = false;
};

struct LoggedFrame {
  std::int64_t time_ns = 0;
  Frame frame;
};

// One line; throws std::invalid_argument saying which rule it breaks.
LoggedFrame parse_candump_line(std::string_view line);
// A whole log; throws std::runtime_error naming file, line and rule.
std::vector<LoggedFrame> read_candump_log(const std::filesystem::path& file);

}  // namespace gaitway::can
