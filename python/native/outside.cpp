// Counts who is outside, and tells them when the interpreter ends.
#include "outside.hpp"

#include <nanobind/nanobind.h>
#include <pthread.h>

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <utility>

namespace gaitway::python {
namespace {

// One a process; never destroyed, since threads may be outside to the last.
struct Presence {
  std::mutex lock;
  std::condition_variable came_back;
  int outside = 0;
  std::atomic<bool> ends = false;
  std::thread::id ended_by;  // set before `ends`
};

Presence& presence() {
  static Presence* one = nullptr;
  static const bool made = [] {
    one = new Presence;
    // Of a copied process nobody is outside: only the thread that copied it is there, and it held the lock.
    pthread_atfork(nullptr, nullptr, [] { one = new Presence; });
    return true;
  }();
  static_cast<void>(made);
  return *one;
}

bool ends_for(std::thread::id thread) {
  const Presence& all = presence();
  return all.ends.load(std::memory_order_acquire) && all.ended_by != thread;
}

}  // namespace

Outside::Outside() {
  if (ends_for(owner_)) throw InterpreterEnds();
  {
    const std::scoped_lock lock(presence().lock);
    ++presence().outside;
  }
  state_ = PyEval_SaveThread();
}

Outside::~Outside() {
  PyEval_RestoreThread(state_);
  {
    const std::scoped_lock lock(presence().lock);
    --presence().outside;
  }
  presence().came_back.notify_all();
}

void Outside::require_interpreter() const {
  if (ends_for(owner_)) throw InterpreterEnds();
}

void Outside::answer_signals() {
  require_interpreter();
  PyEval_RestoreThread(state_);
  std::optional<nanobind::python_error> raised;
  if (PyErr_CheckSignals() != 0) raised.emplace();
  state_ = PyEval_SaveThread();
  if (raised) throw nanobind::python_error(std::move(*raised));
}

void wait_for_those_outside() {
  Presence& all = presence();
  all.ended_by = std::this_thread::get_id();
  all.ends.store(true, std::memory_order_release);
  nanobind::set_leak_warnings(false);  // threads that are cut off never give back what they hold
  PyThreadState* const state = PyEval_SaveThread();
  {
    std::unique_lock lock(all.lock);
    all.came_back.wait(lock, [&all] { return all.outside == 0; });
  }
  PyEval_RestoreThread(state);
}

}  // namespace gaitway::python
