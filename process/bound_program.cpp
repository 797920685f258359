// fork and exec, with what lies in between.
#include "gaitway/process/bound_program.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

namespace gaitway::process {

pid_t start(const BoundProgram& program) {
  std::vector<std::string> words = program.words;
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child != 0) return child;
  // Async-signal-safe calls alone: other threads may have held any lock.
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0);
  if (program.niceness != 0) setpriority(PRIO_PROCESS, 0, program.niceness);
  if (program.kept >= 0) fcntl(program.kept, F_SETFD, 0);
  if (program.output >= 0) {
    dup2(program.output, STDOUT_FILENO);
    dup2(program.output, STDERR_FILENO);
  }
  if (getppid() == parent) execv(argv[0], argv.data());
  _exit(127);
}

}  // namespace gaitway::process
