// Section headers, symbol tables and the dynamic section of a 64-bit ELF file.
#include "tools/check_plugin/elf_symbols.hpp"

#include <cxxabi.h>
#include <elf.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace gaitway::plugin_check {
namespace {

class ElfFile {
 public:
  explicit ElfFile(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    bytes_.assign(std::istreambuf_iterator<char>(stream), {});
    const bool elf = bytes_.size() >= sizeof(Elf64_Ehdr) &&
                     std::memcmp(bytes_.data(), ELFMAG, SELFMAG) == 0 && bytes_[EI_CLASS] == ELFCLASS64;
    if (!elf) {
      throw std::runtime_error("is no 64-bit ELF file");
    }
    const auto header = at<Elf64_Ehdr>(0);
    for (std::uint64_t i = 0; i < header.e_shnum; ++i) {
      sections_.push_back(at<Elf64_Shdr>(header.e_shoff + i * header.e_shentsize));
    }
    for (std::uint64_t i = 0; i < header.e_phnum; ++i) {
      segments_.push_back(at<Elf64_Phdr>(header.e_phoff + i * header.e_phentsize));
    }
  }

  template <class T>
  [[nodiscard]] T at(std::uint64_t offset) const {
    if (offset > bytes_.size() || bytes_.size() - offset < sizeof(T)) {
      throw std::runtime_error("its tables reach beyond its end");
    }
    T value;
    std::memcpy(&value, bytes_.data() + offset, sizeof value);
    return value;
  }
  template <class T>
  [[nodiscard]] std::vector<T> table(const Elf64_Shdr& section) const {
    std::vector<T> entries;
    for (std::uint64_t offset = 0; offset + sizeof(T) <= section.sh_size; offset += sizeof(T)) {
      entries.push_back(at<T>(section.sh_offset + offset));
    }
    return entries;
  }
  [[nodiscard]] std::string text(const Elf64_Shdr& symbols, std::uint32_t offset) const {
    const Elf64_Shdr& strings = sections_.at(symbols.sh_link);
    const std::uint64_t begin = strings.sh_offset + offset;
    if (begin >= bytes_.size()) {
      throw std::runtime_error("its names reach beyond its end");
    }
    return {bytes_.data() + begin, strnlen(bytes_.data() + begin, bytes_.size() - begin)};
  }
  [[nodiscard]] const std::vector<Elf64_Shdr>& sections() const noexcept { return sections_; }
  [[nodiscard]] const std::vector<Elf64_Phdr>& segments() const noexcept { return segments_; }

 private:
  std::vector<char> bytes_;
  std::vector<Elf64_Shdr> sections_;
  std::vector<Elf64_Phdr> segments_;
};

std::string demangled(const std::string& name) {
  int status = 0;
  char* const text = abi::__cxa_demangle(name.c_str(), nullptr, nullptr, &status);
  std::string result = status == 0 && text != nullptr ? text : name;
  std::free(text);  // NOLINT: that is how __cxa_demangle gives its text
  return result;
}

void read_exports(const ElfFile& file, const Elf64_Shdr& section, ElfSymbols& symbols) {
  for (const Elf64_Sym& symbol : file.table<Elf64_Sym>(section)) {
    const unsigned binding = ELF64_ST_BIND(symbol.st_info);
    const unsigned visibility = ELF64_ST_VISIBILITY(symbol.st_other);
    const bool visible = binding != STB_LOCAL && symbol.st_shndx != SHN_UNDEF && symbol.st_shndx != SHN_ABS &&
                         (visibility == STV_DEFAULT || visibility == STV_PROTECTED);
    if (!visible) {
      continue;
    }
    symbols.exported.push_back(demangled(file.text(section, symbol.st_name)));
    if (binding == STB_GNU_UNIQUE) {
      symbols.unique.push_back(symbols.exported.back());
    }
  }
}

void read_functions(const ElfFile& file, const Elf64_Shdr& section, ElfSymbols& symbols) {
  for (const Elf64_Sym& symbol : file.table<Elf64_Sym>(section)) {
    if (ELF64_ST_TYPE(symbol.st_info) == STT_FUNC && symbol.st_shndx != SHN_UNDEF && symbol.st_size > 0) {
      symbols.functions.push_back(
          {symbol.st_value, symbol.st_value + symbol.st_size, demangled(file.text(section, symbol.st_name))});
    }
  }
}

}  // namespace

std::string ElfSymbols::function_at(std::uint64_t address) const {
  auto after = std::upper_bound(functions.begin(), functions.end(), address,
                                [](std::uint64_t a, const ElfFunction& f) { return a < f.begin; });
  if (after == functions.begin() || address >= (--after)->end) {
    return "";
  }
  return after->name;
}

ElfSymbols read_elf_symbols(const std::filesystem::path& file) {
  const ElfFile elf(file);
  ElfSymbols symbols;
  for (const Elf64_Shdr& section : elf.sections()) {
    if (section.sh_type == SHT_DYNSYM) {
      read_exports(elf, section, symbols);
    }
    if (section.sh_type == SHT_DYNSYM || section.sh_type == SHT_SYMTAB) {
      read_functions(elf, section, symbols);
    }
    if (section.sh_type == SHT_DYNAMIC) {
      for (const Elf64_Dyn& entry : elf.table<Elf64_Dyn>(section)) {
        symbols.no_delete |= entry.d_tag == DT_FLAGS_1 && (entry.d_un.d_val & DF_1_NODELETE) != 0;
      }
    }
  }
  for (const Elf64_Phdr& segment : elf.segments()) {
    symbols.thread_local_data |= segment.p_type == PT_TLS;
  }
  std::ranges::sort(symbols.functions, {}, &ElfFunction::begin);
  return symbols;
}

}  // namespace gaitway::plugin_check
