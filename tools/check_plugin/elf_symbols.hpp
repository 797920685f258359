// What an ELF shared library says about itself: what it exports, what keeps it in memory, and which function
// lies where.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace gaitway::plugin_check {

struct ElfFunction {
  std::uint64_t begin = 0;  // from the start of the library
  std::uint64_t end = 0;
  std::string name;  // demangled
};

struct ElfSymbols {
  std::vector<std::string> exported;   // names, demangled
  std::vector<std::string> unique;     // of those with STB_GNU_UNIQUE
  std::vector<ElfFunction> functions;  // in the order of their addresses, local ones as well
  bool no_delete = false;              // linked with -z nodelete
  bool thread_local_data = false;      // has a TLS segment

  // "name", or "" where no function is known.
  [[nodiscard]] std::string function_at(std::uint64_t address) const;
};

// Throws std::runtime_error: not readable, no 64-bit ELF file, tables outside of the file.
ElfSymbols read_elf_symbols(const std::filesystem::path& file);

}  // namespace gaitway::plugin_check
