// inotify; editors that write a new file and rename it are seen, too.
#include "tools/dev/source_watch.hpp"

#include <sys/inotify.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>

namespace gaitway::tools {
namespace {

bool is_source(std::string_view name) {
  constexpr std::array<std::string_view, 7> kEndings{".cpp",   ".cc",           ".c", ".hpp", ".h",
                                                     ".cmake", "CMakeLists.txt"};
  return !name.starts_with('.') &&
         std::any_of(kEndings.begin(), kEndings.end(),
                     [name](std::string_view ending) { return name.ends_with(ending); });
}

}  // namespace

SourceWatch::SourceWatch(const std::filesystem::path& project, const std::filesystem::path& build)
    : inotify_(inotify_init1(IN_CLOEXEC | IN_NONBLOCK)) {
  watch(project);
  for (auto entry = std::filesystem::recursive_directory_iterator(project);
       entry != std::filesystem::recursive_directory_iterator(); ++entry) {
    if (!entry->is_directory()) {
      continue;
    }
    const bool skipped =
        entry->path().filename().string().starts_with('.') ||
        (std::filesystem::exists(build) && std::filesystem::equivalent(entry->path(), build));
    if (skipped) {
      entry.disable_recursion_pending();
    } else {
      watch(entry->path());
    }
  }
}

void SourceWatch::watch(const std::filesystem::path& folder) const {
  if (!inotify_ || inotify_add_watch(inotify_.get(), folder.c_str(), IN_CLOSE_WRITE | IN_MOVED_TO) < 0) {
    throw std::runtime_error(folder.string() + ": cannot be watched: " + std::strerror(errno));
  }
}

bool SourceWatch::take_change() const {
  alignas(inotify_event) std::array<char, 4096> buffer{};
  bool changed = false;
  while (true) {
    const ssize_t bytes = read(inotify_.get(), buffer.data(), buffer.size());
    if (bytes <= 0) {
      return changed;
    }
    for (ssize_t at = 0; at < bytes;) {
      inotify_event event{};
      std::memcpy(&event, buffer.data() + at, sizeof event);
      const char* const name = buffer.data() + at + static_cast<ssize_t>(sizeof event);
      changed = changed || (event.len > 0 && is_source({name, strnlen(name, event.len)}));
      at += static_cast<ssize_t>(sizeof event) + event.len;
    }
  }
}

}  // namespace gaitway::tools
