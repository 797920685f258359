// Prints what is new in a main controller's list of events, a few lines at a time.
#pragma once

#include <cstdint>
#include <string>

#include "gaitway/manager/event_log.hpp"

namespace gaitway::core {

// For binaries: writes to stderr, which takes its time.
class EventPrinter {
 public:
  // `program`: what each line begins with.
  explicit EventPrinter(std::string program) : program_(std::move(program)) {}
  // Leaves out all but a few of what has come since the last call, and says how many.
  void print(const EventLog& events);

 private:
  std::string program_;
  std::uint64_t next_ = 0;
};

}  // namespace gaitway::core
