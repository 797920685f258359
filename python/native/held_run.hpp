// A run as an interpreter holds it: refuses use after close, in another process than its own, and from two
// threads at once. And many of them, run by native threads.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <stdexcept>
#include <thread>
#include <vector>

#include "robot_run.hpp"

namespace gaitway::python {

class ClosedError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};
class ForkError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};
class BusyError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Whether this is the process in which it was made.
class OwnProcess {
 public:
  OwnProcess();
  [[nodiscard]] bool is_here() const noexcept;
  // Throws ForkError.
  void require_here(const char* what) const;

 private:
  int id_;
};

class HeldRun {
 public:
  HeldRun(std::shared_ptr<const RobotSetup> setup, std::uint64_t seed);
  HeldRun(const HeldRun&) = delete;
  HeldRun& operator=(const HeldRun&) = delete;
  // In a copy of the process its memory is the original's, and is left alone.
  ~HeldRun();

  // With the interpreter's lock held. Throws ClosedError, ForkError, BusyError.
  RobotRun& get();
  void close();
  [[nodiscard]] bool closed() const noexcept { return !run_; }

  // Between the two another thread may let it run, without the interpreter's lock.
  RobotRun& begin_use();
  void end_use() noexcept { busy_ = false; }

 private:
  std::unique_ptr<RobotRun> run_;
  std::shared_ptr<const RobotSetup> setup_;
  OwnProcess process_;
  std::atomic<bool> busy_ = false;
};

// While it lives, these runs are in use.
class Use {
 public:
  // Throws as HeldRun::get, BusyError also where one run comes twice; then none is in use.
  explicit Use(std::span<HeldRun* const> runs);
  Use(const Use&) = delete;
  Use& operator=(const Use&) = delete;
  ~Use();
  [[nodiscard]] const std::vector<RobotRun*>& runs() const noexcept { return runs_; }

 private:
  std::vector<HeldRun*> held_;
  std::vector<RobotRun*> runs_;
};

// The calling thread, and as many more as it takes.
class RunPool {
 public:
  // Throws std::invalid_argument for less than one thread, std::runtime_error where there can't be so many.
  explicit RunPool(int threads);
  RunPool(const RunPool&) = delete;
  RunPool& operator=(const RunPool&) = delete;
  ~RunPool();

  // Calls `work(i)` for each 0 <= i < count, once, on any of the threads; when all have ended, throws what
  // the first of them threw. Throws ForkError, and BusyError where another thread is in it.
  void each(std::size_t count, const std::function<void(std::size_t)>& work);
  [[nodiscard]] int threads() const noexcept { return threads_; }

 private:
  struct Shared;
  static void help(Shared& shared);
  void end_helpers();

  int threads_;
  OwnProcess process_;
  std::unique_ptr<Shared> shared_;
  std::vector<std::thread> helpers_;
  std::atomic<bool> busy_ = false;
};

}  // namespace gaitway::python
