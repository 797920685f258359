// Work without the interpreter's lock, and an interpreter that ends while others are at it.
#pragma once

#include <Python.h>

#include <stdexcept>
#include <thread>

namespace gaitway::python {

// For a thread that runs on when its interpreter ends: Python sees SystemExit, which ends a thread quietly.
class InterpreterEnds : public std::runtime_error {
 public:
  InterpreterEnds() : std::runtime_error("the interpreter ends") {}
};

// While it lives, the calling thread is without the interpreter's lock. Python ends a thread that asks for
// the lock of an ended interpreter by unwinding it, which C++ answers with an abort: so an interpreter that
// ends waits for all who are outside, and lets nobody out but the thread that ends it.
class Outside {
 public:
  // With the lock held. Throws InterpreterEnds.
  Outside();
  Outside(const Outside&) = delete;
  Outside& operator=(const Outside&) = delete;
  ~Outside();

  // On any thread that works for this one, often enough to keep nobody waiting. Throws InterpreterEnds.
  void require_interpreter() const;
  // On its own thread: takes the lock and lets Python answer signals, such as a keyboard's interrupt. Throws
  // InterpreterEnds, and nb::python_error for what a handler has raised.
  void answer_signals();

 private:
  std::thread::id owner_ = std::this_thread::get_id();
  PyThreadState* state_;
};

// When the interpreter ends, before anything is torn down; with the lock held.
void wait_for_those_outside();

}  // namespace gaitway::python
