// The `gaitway_plugin_child` process: one plug-in of a main controller that keeps it at arm's length. Started
// by the plug-in manager alone.
#include <unistd.h>

#include <cstdio>
#include <memory>

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
  using namespace gaitway::core;
  std::fflush(nullptr);
  std::unique_ptr<PluginLibrary> library;
  _exit(run_child({argv + 1, static_cast<std::size_t>(argc) - 1},
                  [&](const std::string& name, const std::filesystem::path& base, const SearchPath& path) {
                    library = std::make_unique<PluginLibrary>(name, base, path);
                    return PluginCode{library->entry(), library->file()};
                  }));
}
