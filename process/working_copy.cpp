// A copy of this process by fork(), which tells of its work over a pipe. Each line begins with a letter that
// says what it is.
#include "gaitway/process/working_copy.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

namespace gaitway::process {
namespace {

constexpr char kTold = '+', kFailure = '!';

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

void write_all(int pipe, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(pipe, text.data(), text.size());
    if (written < 0 && errno != EINTR) {
      _exit(1);  // nobody listens any more
    }
    text.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
  }
}

// Neither destructors nor exit handlers run: what they would clean up is the first process's.
[[noreturn]] void work_and_exit(int pipe, pid_t parent,
                                const std::function<void(const WorkingCopy::Tell&)>& work) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) {
    _exit(1);  // it ended before it could be watched
  }
  try {
    work([pipe](const std::string& line) { write_all(pipe, kTold + line + '\n'); });
  } catch (const std::exception& error) {
    std::string text = error.what();
    std::replace(text.begin(), text.end(), '\n', '\v');
    write_all(pipe, kFailure + text + '\n');
  }
  _exit(0);
}

}  // namespace

WorkingCopy::WorkingCopy(const std::function<void(const Tell&)>& work) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    fail("no pipe for a copy of the process");
  }
  pipe_ = FileDescriptor(ends[0]);
  const FileDescriptor writing(ends[1]);
  const pid_t parent = getpid();
  process_ = fork();
  if (process_ < 0) {
    fail("no copy of the process");
  }
  if (process_ == 0) {
    work_and_exit(writing.get(), parent, work);
  }
}

WorkingCopy::WorkingCopy(WorkingCopy&& other) noexcept
    : process_(std::exchange(other.process_, -1)),
      pipe_(std::move(other.pipe_)),
      heard_(std::move(other.heard_)) {}

WorkingCopy::~WorkingCopy() {
  if (process_ > 0) {
    kill(process_, SIGKILL);
    while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
}

std::vector<std::string> WorkingCopy::listen() {
  std::array<char, 4096> buffer{};
  ssize_t got = 0;
  while ((got = read(pipe_.get(), buffer.data(), buffer.size())) < 0) {
    if (errno != EINTR) {
      fail("cannot hear a copy of the process");
    }
  }
  if (got == 0) {
    check_end();
    return {};
  }
  heard_.append(buffer.data(), static_cast<std::size_t>(got));
  std::vector<std::string> lines;
  std::size_t start = 0;
  for (std::size_t end = 0; (end = heard_.find('\n', start)) != std::string::npos; start = end + 1) {
    std::string line = heard_.substr(start + 1, end - start - 1);
    if (heard_[start] == kFailure) {
      std::replace(line.begin(), line.end(), '\v', '\n');
      throw std::runtime_error(line);
    }
    lines.push_back(std::move(line));
  }
  heard_.erase(0, start);
  return lines;
}

void WorkingCopy::check_end() {
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  if (WIFSIGNALED(status)) {
    throw std::runtime_error(std::string("a copy of the process was ended: ") + strsignal(WTERMSIG(status)));
  }
  if (WEXITSTATUS(status) != 0) {
    throw std::runtime_error("a copy of the process ended with code " + std::to_string(WEXITSTATUS(status)));
  }
}

}  // namespace gaitway::process
