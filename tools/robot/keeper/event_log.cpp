// One write a line, to a file that is opened anew each time: it may be moved away, and lines are rare.
#include "tools/robot/keeper/event_log.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <system_error>
#include <utility>

#include "gaitway/process/file_descriptor.hpp"
#include "gaitway/process/real_time.hpp"
#include "gaitway/process/wall_clock.hpp"

namespace gaitway::tools {

EventFile::EventFile(std::filesystem::path file, std::uintmax_t most_bytes)
    : file_(std::move(file)), most_bytes_(most_bytes) {}

void EventFile::tell(const std::string& text) {
  std::error_code unknown;
  const std::uintmax_t size = std::filesystem::file_size(file_, unknown);
  if (!unknown && size >= most_bytes_) {
    std::filesystem::rename(file_, file_.string() + ".1", unknown);
  }
  const std::string time = process::date_and_time_of(process::monotonic_ns());
  if (lost_ > 0 && append(fmt::format("{} {} lines before this one could not be written\n", time, lost_))) {
    lost_ = 0;
  }
  if (!append(fmt::format("{} {}\n", time, text))) {
    ++lost_;
  }
}

bool EventFile::append(const std::string& line) const {
  constexpr mode_t kOwnerWrites = 0640;
  const process::FileDescriptor out(
      open(file_.c_str(), O_CREAT | O_WRONLY | O_APPEND | O_CLOEXEC, kOwnerWrites));
  return out && write(out.get(), line.data(), line.size()) == static_cast<ssize_t>(line.size());
}

}  // namespace gaitway::tools
