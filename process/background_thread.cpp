// By pthreads, since std::thread chooses neither stack nor scheduling.
#include "background_thread.hpp"

#include <pthread.h>
#include <sched.h>
#include <signal.h>

#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

namespace gaitway::process {
namespace {

constexpr std::size_t kStack_bytes = std::size_t{256} << 10;

void* run_work(void* given) {
  const std::unique_ptr<std::function<void()>> work(static_cast<std::function<void()>*>(given));
  (*work)();
  return nullptr;
}

}  // namespace

void start_background_thread(std::function<void()> work) {
  auto given = std::make_unique<std::function<void()>>(std::move(work));
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, kStack_bytes);
  pthread_attr_setdetachstate(&attributes, PTHREAD_CREATE_DETACHED);
  pthread_attr_setinheritsched(&attributes, PTHREAD_EXPLICIT_SCHED);  // not the maker's SCHED_FIFO
  pthread_attr_setschedpolicy(&attributes, SCHED_OTHER);
  const sched_param ordinary{};
  pthread_attr_setschedparam(&attributes, &ordinary);
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);  // the thread inherits it
  pthread_t thread{};
  const int failed = pthread_create(&thread, &attributes, run_work, given.get());
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  pthread_attr_destroy(&attributes);
  if (failed != 0) {
    throw std::runtime_error(std::string("no thread for what is written beside the work: ") +
                             std::strerror(failed));
  }
  static_cast<void>(given.release());  // the thread's
}

}  // namespace gaitway::process
