// A copy of this process that does a piece of work and tells of it in lines.
#pragma once

#include <sys/types.h>

#include <functional>
#include <string>
#include <vector>

#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::process {

// The copy has all that the process has at that moment, but for its threads: make one where there is a single
// thread. It ends with the work, or with the process that made it.
class WorkingCopy {
 public:
  // A line has no line feed in it.
  using Tell = std::function<void(const std::string& line)>;

  // Throws std::system_error when there is no process to be had.
  explicit WorkingCopy(const std::function<void(const Tell&)>& work);
  WorkingCopy(WorkingCopy&& other) noexcept;
  WorkingCopy& operator=(WorkingCopy&&) = delete;
  ~WorkingCopy();  // ends the copy at once if it still works

  // Waits until the copy tells something, or ends. Throws std::runtime_error with what its work threw, or
  // with how the process came to its end.
  [[nodiscard]] std::vector<std::string> listen();
  // It has done its work, and all that it told was heard.
  [[nodiscard]] bool done() const noexcept { return process_ < 0; }
  // Readable when listen() need not wait.
  [[nodiscard]] int descriptor() const noexcept { return pipe_.get(); }

 private:
  void check_end();

  pid_t process_ = -1;
  FileDescriptor pipe_;
  std::string heard_;  // of a line that has not yet come to its end
};

}  // namespace gaitway::process
