// Header check, then one copy inside the kernel.
#include "library_copy.hpp"

#include <elf.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/sendfile.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstddef>
#include <cstring>

#include "gaitway/manager/plugin_error.hpp"

namespace gaitway::core {
namespace {

#if defined(__x86_64__)
constexpr Elf64_Half kMachine = EM_X86_64;
#elif defined(__aarch64__)
constexpr Elf64_Half kMachine = EM_AARCH64;
#else
#error "name this machine's ELF number here"
#endif
constexpr unsigned char kData = std::endian::native == std::endian::little ? ELFDATA2LSB : ELFDATA2MSB;

// Where the machine alone does not tell it: how wide its addresses are, and which way round.
std::string machine_name(const Elf64_Ehdr& header) {
  if (header.e_ident[EI_DATA] != kData) {
    return "a machine of the other byte order";
  }
  const bool narrow = header.e_ident[EI_CLASS] == ELFCLASS32;
  switch (header.e_machine) {
    case EM_X86_64:
      return narrow ? "x86-64 with 32-bit addresses (x32)" : "x86-64";
    case EM_AARCH64:
      return narrow ? "64-bit Arm with 32-bit addresses" : "64-bit Arm";
    case EM_386:
      return "32-bit x86";
    case EM_ARM:
      return "32-bit Arm";
    case EM_RISCV:
      return "RISC-V";
    default:
      return fmt::format("ELF machine {}", header.e_machine);
  }
}

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& what) {
  throw PluginError(fmt::format("{}: {}", file.string(), what));
}

void check_header(const std::filesystem::path& file, int fd, std::int64_t size) {
  Elf64_Ehdr header{};
  const ssize_t got = pread(fd, &header, sizeof header, 0);
  constexpr ssize_t kUpToMachine = offsetof(Elf64_Ehdr, e_machine) + sizeof header.e_machine;
  if (got < kUpToMachine || std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0) {
    refuse(
        file,
        fmt::format("is no shared library: it has no ELF header ({} bytes). Was it built to its end?", size));
  }
  if (header.e_ident[EI_CLASS] != ELFCLASS64 || header.e_ident[EI_DATA] != kData ||
      header.e_machine != kMachine) {
    Elf64_Ehdr own{};
    own.e_ident[EI_DATA] = kData;
    own.e_machine = kMachine;
    refuse(file, fmt::format("is a library for {}, this machine is {}. Build it for this one",
                             machine_name(header), machine_name(own)));
  }
  if (got < static_cast<ssize_t>(sizeof header) || header.e_type != ET_DYN) {
    refuse(file, "is an ELF file, but no shared library. Build it with gaitway_plugin(), or with -shared");
  }
  const auto tables =
      std::max<std::uint64_t>(header.e_shoff + std::uint64_t{header.e_shnum} * header.e_shentsize,
                              header.e_phoff + std::uint64_t{header.e_phnum} * header.e_phentsize);
  if (tables > static_cast<std::uint64_t>(size)) {
    refuse(file, fmt::format("is cut off: it has {} bytes, its tables reach to {}. Was it built to its end?",
                             size, tables));
  }
}

}  // namespace

LibraryCopy::LibraryCopy(const std::filesystem::path& file) {
  const process::FileDescriptor source(open(file.c_str(), O_RDONLY | O_CLOEXEC));
  struct stat status {};
  if (!source || fstat(source.get(), &status) != 0) {
    refuse(file, fmt::format("cannot be read: {}", std::strerror(errno)));
  }
  check_header(file, source.get(), status.st_size);
  memory_ = process::FileDescriptor(memfd_create(file.filename().c_str(), MFD_CLOEXEC | MFD_ALLOW_SEALING));
  if (!memory_) {
    refuse(file, fmt::format("no memory for a private copy: {}", std::strerror(errno)));
  }
  for (std::int64_t copied = 0; copied < status.st_size;) {
    const ssize_t count =
        sendfile(memory_.get(), source.get(), nullptr, static_cast<std::size_t>(status.st_size - copied));
    if (count <= 0) {
      refuse(file,
             fmt::format("cannot be copied: {}", count == 0 ? "it became shorter" : std::strerror(errno)));
    }
    copied += count;
  }
  fcntl(memory_.get(), F_ADD_SEALS, F_SEAL_WRITE | F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL);
}

std::string LibraryCopy::path() const {
  return fmt::format("/proc/self/fd/{}", memory_.get());
}

}  // namespace gaitway::core
