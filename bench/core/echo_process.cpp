// The second process that the isolation benchmark exchanges numbers with: fork, a memfd, two numbers.
#include "echo_process.hpp"

#include <linux/futex.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <new>
#include <system_error>

namespace gaitway::core {

EchoProcess::EchoProcess(EchoWait wait)
    : wait_(wait),
      segment_(msgclient::Segment::create("gaitway echo", sizeof(Page))),
      page_(new (segment_.data()) Page) {
  child_ = fork();
  if (child_ < 0) {
    throw std::system_error(errno, std::generic_category(), "the peer's process");
  }
  if (child_ == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0);
    answer_for_ever();
  }
}

EchoProcess::~EchoProcess() {
  kill(child_, SIGKILL);
  waitpid(child_, nullptr, 0);
}

void EchoProcess::round_trip() noexcept {
  const std::uint32_t before = number_++;
  signal(page_->call, number_);
  wait(page_->answer, before);
}

void EchoProcess::answer_for_ever() noexcept {
  for (std::uint32_t number = 0;; ++number) {
    wait(page_->call, number);
    signal(page_->answer, number + 1);
  }
}

void EchoProcess::signal(Doorbell& bell, std::uint32_t number) const noexcept {
  if (wait_ == EchoWait::spin_then_futex) {
    ring(bell, number);
    return;
  }
  bell.number.store(number);
  syscall(SYS_futex, &bell.number, FUTEX_WAKE, 1, nullptr, nullptr, 0);
}

void EchoProcess::wait(Doorbell& bell, std::uint32_t old) noexcept {
  if (wait_ == EchoWait::spin_then_futex) {
    while (!spin_.sees_change(bell, old)) {
      sleep_on(bell, old, -1);
    }
    return;
  }
  while (bell.number.load() == old) {
    syscall(SYS_futex, &bell.number, FUTEX_WAIT, old, nullptr, nullptr, 0);
  }
}

}  // namespace gaitway::core
