// `gaitway`: runs the simulated robot itself, and hands every other command to its own program.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string_view>

#include "tools/command_line.hpp"

namespace {

using gaitway::tools::kCommands;

constexpr std::string_view kOwnCommand = "run";

// The command that another program runs; nullptr: it is for this one, or there is none of that name.
const gaitway::tools::Command* other_command(int argc, char** argv) {
  if (argc < 2 || argv[1] == kOwnCommand) {
    return nullptr;
  }
  const auto* const command = std::ranges::find_if(
      kCommands, [argv](const auto& one) { return one.name == std::string_view(argv[1]); });
  return command == kCommands.end() ? nullptr : command;
}

// Becomes the command's program, which lies beside this one; returns only where that fails.
int become(const gaitway::tools::Command& command, char** argv) {
  const std::filesystem::path program =
      std::filesystem::read_symlink("/proc/self/exe").parent_path() / fmt::format("gaitway-{}", command.name);
  execv(program.c_str(), argv);
  if (errno == ENOENT && command.of_python) {
    execvp(program.filename().c_str(), argv + 1);  // its name is its own
    fmt::print(
        stderr,
        "gaitway: '{0}' comes with the Python package, which is not here: {1} is not in the path. Install "
        "the wheel: pip install 'gaitway[{0}]'\n",
        command.name, program.filename().string());
  } else if (errno == ENOENT) {
    fmt::print(stderr,
               "gaitway: '{0}' is a program of its own, which is not here: {1}. In the source tree './dev "
               "gaitway {0}' "
               "builds it, and so does 'ninja gaitway-{0}' in the build folder\n",
               command.name, program.string());
  } else {
    fmt::print(stderr, "gaitway: {}: cannot be run: {}\n", program.string(), std::strerror(errno));
  }
  return gaitway::tools::kExitBadInput;
}

// All commands are listed here; only one of them runs here.
void declare(const gaitway::tools::CommandLine& program) {
  program.footer(
      "Examples:\n"
      "  gaitway run --walk 0.15 --seconds 20\n"
      "  gaitway new-plugin my_gait --kind trajectory\n"
      "  gaitway run --help");
  for (const gaitway::tools::Command& command : kCommands) {
    if (command.name == kOwnCommand) {
      gaitway::tools::add_run(program);
    } else {
      static_cast<void>(gaitway::tools::add_command(program, command.name));
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (const gaitway::tools::Command* const command = other_command(argc, argv)) {
    return become(*command, argv);
  }
  return gaitway::tools::run_program(argc, argv, declare);
}
