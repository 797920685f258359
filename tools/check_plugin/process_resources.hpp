// What this process holds at the moment: memory, descriptors, threads.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace gaitway::plugin_check {

struct ProcessResources {
  std::int64_t heap_bytes =
      0;  // allocated and not freed since the count began; 0 in a build with a sanitizer
  std::int64_t resident_bytes = 0;
  int descriptors = 0;
  int threads = 0;
};
ProcessResources process_resources();

// Whether the file is still mapped.
bool is_mapped(const std::filesystem::path& file);

}  // namespace gaitway::plugin_check
