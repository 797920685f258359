// Reads /proc/self and asks the interposed allocator.
#include "tools/check_plugin/process_resources.hpp"

#include <unistd.h>

#include <fstream>
#include <iterator>

#include "tools/check_plugin/call_guard.hpp"

namespace gaitway::plugin_check {
namespace {

int entries(const char* folder) {
  return static_cast<int>(
      std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator()));
}

}  // namespace

ProcessResources process_resources() {
  ProcessResources now;
  now.descriptors = entries("/proc/self/fd");
  now.threads = entries("/proc/self/task");
  std::int64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages >> pages;
  now.resident_bytes = pages * sysconf(_SC_PAGESIZE);
  now.heap_bytes = live_memory_bytes();
  return now;
}

bool is_mapped(const std::filesystem::path& file) {
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) {
    if (line.ends_with(file.string())) {
      return true;
    }
  }
  return false;
}

}  // namespace gaitway::plugin_check
