// The `gaitway_plugin_child` process: one plug-in of a main controller that keeps it at arm's length. Started
// by the plug-in manager alone.
#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string_view>

#include "bounds.hpp"
#include "child_program.hpp"

#if defined(__SANITIZE_ADDRESS__)
// A plug-in's death is for the manager to tell.
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() {
  return "handle_segv=0:handle_abort=0:handle_sigbus=0:handle_sigfpe=0:handle_sigill=0:detect_leaks=0:"
         "use_sigaltstack=0";
}
#endif

int main(int argc, char** argv) {
  using namespace gaitway;
  constexpr int kExitBadInput = 1;
  if (argc != 5 || fcntl(core::kChildSocket, F_GETFD) < 0) {
    std::fprintf(
        stderr,
        "gaitway_plugin_child is started by the main controller, for plug-ins with `isolation: process` "
        "in its configuration\n");
    return kExitBadInput;
  }
  prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0);
  if (getppid() != static_cast<pid_t>(std::strtol(argv[1], nullptr, 10))) {
    return 0;  // it is gone already
  }
  const core::ChildBounds bounds{.memory_limit_bytes = std::strtoull(argv[2], nullptr, 10),
                                 .descriptor_limit = std::strtoull(argv[3], nullptr, 10),
                                 .local_sockets = std::string_view(argv[4]) == core::kLocalSockets};
  core::enter_child_bounds(bounds, core::kChildSocket + 1);
  try {
    // _exit: what the plug-in left for the process's end must not run beside a manager that waits.
    std::fflush(nullptr);
    _exit(core::ChildProgram(process::FileDescriptor(core::kChildSocket)).run());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gaitway_plugin_child: %s\n", error.what());
    _exit(kExitBadInput);
  }
}
