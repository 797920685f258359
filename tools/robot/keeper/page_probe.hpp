// Whether a user interface module still answers: asks it for the head of its page, again and again, without
// waiting for the answer. Another program's page on that port is no answer.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <string>

#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::tools {

// Whether something listens there already. Not known, and so false, of what is no numeric address.
[[nodiscard]] bool port_is_taken(const std::string& address, int port);

class PageProbe {
 public:
  static constexpr std::int64_t kBetween_ns = 1'000'000'000;
  static constexpr std::int64_t kPatience_ns = 2'000'000'000;  // then it asks anew

  // Of this computer: a numeric address that it listens on. Any ("0.0.0.0", "::") is asked on the loopback.
  PageProbe(std::string address, int port);

  // Asks, or looks for the answer, as the time has come for it. The answers of this process so far.
  std::uint64_t step(std::int64_t now_ns, pid_t process);
  // Who answers in its place; told once. Empty: nobody, or as before.
  [[nodiscard]] std::string take_stranger();

 private:
  void ask(std::int64_t now_ns);
  void look(std::int64_t now_ns, pid_t process);
  void on_answer(pid_t process);

  std::string address_;
  int port_;
  process::FileDescriptor connection_;
  bool asked_ = false;
  std::int64_t begin_ns_ = 0, due_ns_ = 0;
  std::uint64_t answers_ = 0;
  std::string stranger_;
  bool stranger_is_news_ = false;
};

}  // namespace gaitway::tools
