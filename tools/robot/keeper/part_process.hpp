// One part of the robot as a process: started with a lock of its own, so that there is never a second one in
// the same folder, with its output in a log file. It outlives whoever started it, and can be taken over.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::tools {

// A log file keeps its newest half when it has grown to this size.
inline constexpr std::uintmax_t kLogBytes = 1'000'000;

// Cuts the file down to its newest half when it is too large, under the eyes of who appends to it. What is
// written in that moment may be lost.
void bound_log(const std::filesystem::path& file, std::uintmax_t most_bytes = kLogBytes);

class PartProcess {
 public:
  struct Place {
    std::filesystem::path folder;  // of NAME.lock
    std::filesystem::path log;     // of NAME.log
  };
  PartProcess(std::string name, std::vector<std::string> words, const Place& place);

  // Takes over the one that an earlier supervisor left behind; false: there is none. Throws
  // std::runtime_error when it is another robot's or on another bus, or cannot be known.
  bool take_over();
  // Further options of the one that was taken over that differ from those of its next start, an option of
  // another version's among them: "--seed, --config". Empty: none.
  [[nodiscard]] const std::string& differences() const noexcept { return differences_; }
  // The one that lives, whatever its words are, to end it.
  bool take_over_whatever();
  // Throws std::runtime_error with the reason: also when another one of this name is in the folder.
  void start();
  void send(int signal) const;  // to its first process
  // It and all that it has started, at once.
  void end_group() const;
  // It ended: how ("was ended by signal 9 (Killed)", with its last words). To be asked when ended_fd() is
  // readable, or at any time.
  [[nodiscard]] std::optional<std::string> take_end();
  // It has been stopped, waits for a disk…: what the kernel says of it, for people; empty: nothing special.
  [[nodiscard]] std::string kernel_state() const;
  // How often its threads have gone to sleep by themselves: grows as long as it does its rounds.
  [[nodiscard]] std::uint64_t rounds() const;
  // It asked for real time, and has it.
  [[nodiscard]] bool is_real_time() const;
  // The process that does the work, where the first one keeps another: that one, else itself.
  [[nodiscard]] pid_t worker() const;
  // The last line that it has said of itself, or of those the last with this text in it.
  [[nodiscard]] std::string last_words(std::string_view with = {}) const;

  [[nodiscard]] pid_t pid() const noexcept { return process_; }  // 0: there is none
  [[nodiscard]] int ended_fd() const noexcept { return pidfd_.get(); }
  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  [[nodiscard]] const std::filesystem::path& log_file() const noexcept { return log_; }

 private:
  struct Record {
    pid_t process = 0;
    std::vector<std::string> words;
  };
  [[nodiscard]] process::FileDescriptor open_lock() const;
  [[nodiscard]] Record read_record() const;
  [[nodiscard]] bool adopt(bool whatever);
  void compare(const Record& record);
  [[nodiscard]] process::FileDescriptor take_lock() const;
  [[noreturn]] void become(const process::FileDescriptor& lock, const process::FileDescriptor& log) const;

  std::string name_, differences_;
  std::vector<std::string> words_;
  std::filesystem::path lock_, log_;
  std::uintmax_t log_begin_ = 0;  // where this process's log begins
  pid_t process_ = 0;
  bool is_child_ = false;
  process::FileDescriptor pidfd_;
};

}  // namespace gaitway::tools
