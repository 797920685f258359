// The `gaitway_python_child` process: becomes the interpreter that runs one plug-in in Python. Started by the
// plug-in manager in the place of gaitway_plugin_child, with the same words.
#include <fcntl.h>
#include <fmt/format.h>
#include <string.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "isolation/bounds.hpp"
#include "isolation/child_program.hpp"
#include "isolation/messages.hpp"

namespace {

using namespace gaitway;
namespace fs = std::filesystem;

constexpr const char* kScript = "gaitway/_plugin_child.py";
constexpr std::string_view kRefuse = "--refuse";  // of that script, while it has no way to the manager

// The manager's request is taken first: one that is left in a socket when it closes is an error at the other
// end, in front of what was sent.
void refuse(const std::string& text) {
  const process::FileDescriptor socket(core::kChildSocket);
  std::vector<std::byte> request;
  static_cast<void>(core::receive_packet(socket, request, core::Wait::yes));
  core::send_packet(socket, core::PacketWriter(core::ChildMessage::library_failed).text(text).bytes(),
                    core::Wait::yes);
}

// The folder that holds the package: of a build tree or of a wheel, which has this program in the package.
fs::path package_folder(const fs::path& program) {
  const fs::path root = program.parent_path().parent_path();
  for (const fs::path& folder : {root / "lib" / "python", root.parent_path()}) {
    if (fs::exists(folder / kScript)) return folder;
  }
  throw core::PluginError(
      fmt::format("a plug-in in Python needs Gaitway's Python package, which is not in {}. "
                  "pip install gaitway-*.whl, and run the gaitway of that",
                  (root / "lib" / "python").string()));
}

// GAITWAY_PYTHON, that of the virtual environment into which the package was installed, or that of the path.
std::string interpreter_for(const fs::path& package) {
  if (const char* const given = std::getenv("GAITWAY_PYTHON"); given != nullptr && given[0] != '\0')
    return given;
  const fs::path beside = (package / "../../../bin/python3").lexically_normal();
  return access(beside.c_str(), X_OK) == 0 ? beside.string() : "python3";
}

// One run is as the other: hashes, and sums of numbers in the order of one thread.
void settle_environment() {
  setenv("PYTHONHASHSEED", "0", 1);
  for (const char* const threads : {"OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"}) {
    setenv(threads, "1", 1);
  }
}

[[noreturn]] void become_interpreter(int argc, char** argv) {
  std::string program = fs::read_symlink("/proc/self/exe");
  const fs::path package = package_folder(program);
  std::string interpreter = interpreter_for(package), script = package / kScript;
  settle_environment();
  std::vector<char*> words{interpreter.data(), script.data(), program.data()};
  words.insert(words.end(), argv + 1, argv + argc);
  words.push_back(nullptr);
  execvp(interpreter.c_str(), words.data());
  throw core::PluginError(fmt::format("the interpreter '{}' cannot be run: {}. Name one in GAITWAY_PYTHON",
                                      interpreter, strerror(errno)));
}

}  // namespace

int main(int argc, char** argv) {
  if (fcntl(core::kChildSocket, F_GETFD) < 0) {
    std::fprintf(stderr, "gaitway_python_child is started by the main controller, for plug-ins in Python\n");
    return 1;
  }
  if (argc == 3 && argv[1] == kRefuse) {
    refuse(argv[2]);
    return 0;
  }
  core::enter_child_bounds({},
                           core::kChildSocket + 1);  // the interpreter's start is not to delay the manager
  try {
    become_interpreter(argc, argv);
  } catch (const std::exception& error) {
    refuse(error.what());
  }
  return 0;
}
