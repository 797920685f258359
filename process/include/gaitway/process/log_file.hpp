// A log of lines that a kill or a full disk cannot spoil: every line in the file is whole, what could not be
// written is counted, and the file stays within its bounds.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::process {

struct LogOptions {
  enum class Start {
    anew,   // what the file held is gone
    go_on,  // after the last whole line of what it holds
  };
  Start start = Start::anew;
  // A file that would become larger is renamed to FILE.1, in the place of the one before, and a new one
  // begins. 0: no bound.
  std::uint64_t most_bytes = 0;
  std::string head{};  // the first line of each file, with its end; or empty
};

// Each block of lines goes to the system with one write, so a killed process leaves all that was appended;
// only of the block that is being written the end may be missing, or stand there in part: go_on and readers
// drop such a part of a line. Not for several threads at once.
class LogFile {
 public:
  // Throws std::runtime_error that names the file and the reason: it cannot be made, or another process
  // writes it.
  explicit LogFile(std::filesystem::path file, LogOptions options = {});
  // An open descriptor that others may write to as well, such as stderr. It is not closed.
  LogFile(int descriptor, std::string name);

  // Lines, each with its end. As many as the disk takes, each whole; the others are counted and lost. False:
  // some were lost. Waits for the disk; tries it anew each time. Never throws.
  bool append(std::string_view lines) noexcept;
  // Down to the disk itself, so that not even a power cut takes away what was appended.
  void sync() noexcept;
  // Others may write it from now on, and nothing more may be appended.
  void close() noexcept { own_ = FileDescriptor(); }

  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  [[nodiscard]] std::uint64_t lines() const noexcept { return lines_; }
  [[nodiscard]] std::uint64_t lost() const noexcept { return lost_; }
  // Why lines were lost the last time; empty: none were.
  [[nodiscard]] const std::string& error() const noexcept { return error_; }

 private:
  void open(const std::filesystem::path& file, LogOptions::Start start);
  [[nodiscard]] bool begin_next_file() noexcept;
  [[nodiscard]] bool mend() noexcept;
  [[nodiscard]] bool has_head() noexcept;
  // Bytes of the lines that stand in the file now.
  std::size_t put(std::string_view lines) noexcept;

  std::string name_;
  LogOptions options_;
  FileDescriptor own_;
  int descriptor_ = -1;
  bool regular_ = false;          // and of our own: it can be cut off and renamed
  bool torn_ = false;             // part of a line stands at the end
  std::uint64_t size_bytes_ = 0;  // of whole lines
  std::uint64_t lines_ = 0, lost_ = 0;
  std::string error_;
};

}  // namespace gaitway::process
