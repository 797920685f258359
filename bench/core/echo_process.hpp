// The peer of an isolated plug-in: a second process that answers over a page of shared memory and does
// nothing else.
#pragma once

#include <sys/types.h>

#include <cstdint>

#include "gaitway/msgclient/segment.hpp"
#include "isolation/exchange.hpp"

namespace gaitway::core {

enum class EchoWait : std::uint8_t {
  futex,            // each side sleeps at once and is always woken by a system call
  spin_then_futex,  // as the manager and its plug-in hosts wait
};

class EchoProcess {
 public:
  // Throws std::system_error.
  explicit EchoProcess(EchoWait wait);
  ~EchoProcess();
  EchoProcess(const EchoProcess&) = delete;
  EchoProcess& operator=(const EchoProcess&) = delete;

  void round_trip() noexcept;

 private:
  struct Page {
    Doorbell call, answer;
  };
  [[noreturn]] void answer_for_ever() noexcept;
  void signal(Doorbell& bell, std::uint32_t number) const noexcept;
  void wait(Doorbell& bell, std::uint32_t old) noexcept;

  EchoWait wait_;
  msgclient::Segment segment_;
  Page* page_;
  Spin spin_;
  std::uint32_t number_ = 0;
  pid_t child_ = -1;
};

}  // namespace gaitway::core
