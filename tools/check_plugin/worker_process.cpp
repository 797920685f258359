// fork and exec, and a watch that sees an end at once and a silence after its limit.
#include "tools/check_plugin/worker_process.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>

#include "gaitway/process/file_descriptor.hpp"
#include "tools/check_plugin/plugin_check.hpp"

namespace gaitway::core {
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ParameterEntry, name, text, line)
}

namespace gaitway::plugin_check {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Job, check, variant, plugin, robot, configuration, parameters, seed, full,
                                   budget_ms, first_case)

namespace {

using Clock = std::chrono::steady_clock;

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  std::ranges::transform(texts, std::back_inserter(pointers), [](std::string& text) { return text.data(); });
  pointers.push_back(nullptr);
  return pointers;
}

std::string ending_text(int status, const Board& board) {
  const BoardPage& page = board.page();
  if (page.crash[0] != '\0') {
    return {page.crash.data(), strnlen(page.crash.data(), page.crash.size())};
  }
  return WIFSIGNALED(status) ? fmt::format("killed by {}", strsignal(WTERMSIG(status)))
                             : fmt::format("the process ended with code {}", WEXITSTATUS(status));
}

WorkerEnding watch(pid_t child, Board& board, const WatchLimits& limits) {
  const process::FileDescriptor handle(static_cast<int>(syscall(SYS_pidfd_open, child, 0)));
  const auto start = Clock::now();
  auto heard = start;
  std::uint32_t beat = board.page().beat;
  int status = 0;
  while (true) {
    pollfd wait{handle.get(), POLLIN, 0};
    poll(&wait, handle ? 1 : 0, 50);
    if (waitpid(child, &status, WNOHANG) == child) {
      break;
    }
    const auto now = Clock::now();
    if (const std::uint32_t heard_beat = board.page().beat; heard_beat != beat) {
      beat = heard_beat;
      heard = now;
    }
    if (now - heard > limits.silence || now - start > limits.total) {
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
      const double seconds = std::chrono::duration<double>(now - heard).count();
      return {Ending::hung, fmt::format("does not return: no answer for {:.0f} s", seconds), board.place()};
    }
  }
  const bool fine = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  return fine ? WorkerEnding{} : WorkerEnding{Ending::crashed, ending_text(status, board), board.place()};
}

[[noreturn]] void become_worker(char* const* arguments, int board, int record) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  dup2(board, kBoardDescriptor);
  if (record >= 0) {
    dup2(record, kRecordDescriptor);
  }
  execv("/proc/self/exe", arguments);
  _exit(127);
}

}  // namespace

WorkerEnding run_worker_process(const Job& job, Board& board, int record_fd, const WatchLimits& limits) {
  std::vector<std::string> arguments{"gaitway", kWorkerCommand, to_text(job)};
  const std::vector<char*> argument_pointers = pointers_to(arguments);
  const pid_t child = fork();
  if (child < 0) {
    throw CheckError(fmt::format("no process for the check '{}': {}", job.check, std::strerror(errno)));
  }
  if (child == 0) {
    become_worker(argument_pointers.data(), board.fd(), record_fd);
  }
  return watch(child, board, limits);
}

WorkerEnding run_forked(Board& board, const WatchLimits& limits, const std::function<void()>& work) {
  const pid_t child = fork();
  if (child < 0) {
    throw CheckError(fmt::format("no process for the walk: {}", std::strerror(errno)));
  }
  if (child == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    work();
    _exit(0);
  }
  return watch(child, board, limits);
}

std::string to_text(const Job& job) {
  return nlohmann::json(job).dump();
}

Job read_job(const std::string& text) {
  return nlohmann::json::parse(text).get<Job>();
}

}  // namespace gaitway::plugin_check
