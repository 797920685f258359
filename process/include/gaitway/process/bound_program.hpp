// Starts another program that does not outlive the thread that started it: whatever becomes of this process,
// the kernel ends that one, too.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace gaitway::process {

struct BoundProgram {
  std::vector<std::string> words;  // the program's path, and its arguments
  int kept = -1;                   // a descriptor that it inherits under its own number; -1: none
  int output = -1;                 // where its standard output and standard error go; -1: where ours do
  int niceness = 0;                // so much less of the processor than others
};

// Its process; -1 with errno set: there is none. It has no signal blocked. May be called in a process with
// threads.
[[nodiscard]] pid_t start(const BoundProgram& program);

}  // namespace gaitway::process
