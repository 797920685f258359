// Finds the file, checks its header, copies it inside the kernel, opens the copy, checks the border.
#include "gaitway/instance/plugin_library.hpp"

#include <dlfcn.h>
#include <elf.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/sendfile.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <string_view>

#include "gaitway/process/installation.hpp"

namespace gaitway::core {
namespace {

constexpr const char* kEntrySymbol = "gaitway_plugin_entry";

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

[[noreturn]] void refuse_library(const std::filesystem::path& file, const std::string& what) {
  throw PluginError(fmt::format("{}: {}", file.string(), what));
}

void check_header(const std::filesystem::path& file, int fd, std::int64_t size) {
  Elf64_Ehdr header{};
  const ssize_t got = pread(fd, &header, sizeof header, 0);
  constexpr ssize_t kUpToMachine = offsetof(Elf64_Ehdr, e_machine) + sizeof header.e_machine;
  if (got < kUpToMachine || std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0) {
    refuse_library(
        file,
        fmt::format("is no shared library: it has no ELF header ({} bytes). Was it built to its end?", size));
  }
  if (header.e_ident[EI_CLASS] != ELFCLASS64 || header.e_ident[EI_DATA] != kData ||
      header.e_machine != kMachine) {
    Elf64_Ehdr own{};
    own.e_ident[EI_DATA] = kData;
    own.e_machine = kMachine;
    refuse_library(file, fmt::format("is a library for {}, this machine is {}. Build it for this one",
                                     machine_name(header), machine_name(own)));
  }
  if (got < static_cast<ssize_t>(sizeof header) || header.e_type != ET_DYN) {
    refuse_library(file,
                   "is an ELF file, but no shared library. Build it with gaitway_plugin(), or with -shared");
  }
  const auto tables =
      std::max<std::uint64_t>(header.e_shoff + std::uint64_t{header.e_shnum} * header.e_shentsize,
                              header.e_phoff + std::uint64_t{header.e_phnum} * header.e_phentsize);
  if (tables > static_cast<std::uint64_t>(size)) {
    refuse_library(
        file, fmt::format("is cut off: it has {} bytes, its tables reach to {}. Was it built to its end?",
                          size, tables));
  }
}

// What the loader says, with the library's own name instead of its copy's.
std::string loader_error(const std::string& copy, const std::filesystem::path& file) {
  std::string text = dlerror();
  for (std::size_t at = text.find(copy); at != std::string::npos; at = text.find(copy)) {
    text.replace(at, copy.size(), file.filename().string());
  }
  return text;
}

}  // namespace

std::filesystem::path find_plugin_file(const std::string& library, const std::filesystem::path& base,
                                       const SearchPath& path) {
  SearchPath places;
  if (library.find('/') != std::string::npos) {
    places.push_back(base / library);
  } else {
    for (const std::filesystem::path& folder : path) {
      places.push_back(folder / library);
    }
  }
  std::string tried;
  for (const std::filesystem::path& place : places) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(place, ignored)) {
      return place;
    }
    tried += (tried.empty() ? "" : ", ") + place.string();
  }
  const char* const remedy = is_python(library) ? "Write './' before what lies beside the configuration"
                                                : "Build it, or put its folder into GAITWAY_PLUGIN_PATH";
  throw PluginError(fmt::format("no library '{}'; tried {}. {}", library,
                                tried.empty() ? "nowhere: the search path is empty" : tried, remedy));
}

void check_border(const gaitway_plugin& entry, const std::filesystem::path& file, std::uint32_t minor) {
  constexpr std::string_view kRemedy = "Build the plug-in anew against this version's headers";
  if (entry.magic != GAITWAY_PLUGIN_MAGIC) {
    throw PluginError(
        fmt::format("{}: '{}' is no plug-in descriptor (magic {:#010x} instead of {:#010x}). {}",
                    file.string(), kEntrySymbol, entry.magic, GAITWAY_PLUGIN_MAGIC, kRemedy));
  }
  if (entry.abi != GAITWAY_PLUGIN_ABI) {
    throw PluginError(
        fmt::format("{}: built for plug-in ABI {}, but this main controller speaks ABI {}.{}. {}",
                    file.string(), entry.abi, GAITWAY_PLUGIN_ABI, minor, kRemedy));
  }
  if (entry.abi_minor > minor) {
    throw PluginError(
        fmt::format("{}: built for plug-in ABI {}.{}, but this main controller speaks ABI {}.{}. Build it "
                    "against older headers, or take a newer main controller",
                    file.string(), entry.abi, entry.abi_minor, GAITWAY_PLUGIN_ABI, minor));
  }
  struct Size {
    std::string_view type;
    std::uint32_t theirs;
    std::size_t first, ours;  // as minor number 0 has it, and as we have it
  };
  const std::array sizes{Size{"gaitway_plugin", entry.plugin_size, 80, sizeof(gaitway_plugin)},
                         Size{"gaitway_host", entry.host_size, 72, sizeof(gaitway_host)},
                         Size{"gaitway_instance", entry.instance_size, 56, sizeof(gaitway_instance)},
                         Size{"gaitway_tick", entry.tick_size, 32, sizeof(gaitway_tick)},
                         Size{"gaitway_topic", entry.topic_size, 40, sizeof(gaitway_topic)},
                         Size{"gaitway_float_field", entry.float_field_size, 40, sizeof(gaitway_float_field)},
                         Size{"gaitway_sample", entry.sample_size, 16, sizeof(gaitway_sample)},
                         Size{"gaitway_parameter", entry.parameter_size, 80, sizeof(gaitway_parameter)},
                         Size{"gaitway_value", entry.value_size, 32, sizeof(gaitway_value)}};
  for (const Size& size : sizes) {
    if (size.theirs < size.first || size.theirs > size.ours) {
      throw PluginError(fmt::format("{}: its {} has {} bytes, this main controller's {}. {}", file.string(),
                                    size.type, size.theirs, size.ours, kRemedy));
    }
  }
  if (entry.name == nullptr || entry.version == nullptr || entry.description == nullptr ||
      entry.create == nullptr) {
    throw PluginError(fmt::format(
        "{}: its descriptor lacks name, version, description or create. Fill them in", file.string()));
  }
}

SearchPath plugin_search_path(const SearchPath& given) {
  SearchPath path;
  const auto add = [&path](const std::filesystem::path& folder) {
    if (!folder.empty() && std::ranges::find(path, folder) == path.end()) {
      path.push_back(folder);
    }
  };
  std::ranges::for_each(given, add);
  if (const char* const variable = std::getenv("GAITWAY_PLUGIN_PATH")) {
    std::string_view rest = variable;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find(':'), rest.size());
      add(rest.substr(0, end));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
  }
  add(process::shipped_plugin_directory());
  return path;
}

LibraryCopy::LibraryCopy(const std::filesystem::path& file) {
  if (is_python(file.native())) {
    refuse_library(file, "is a plug-in in Python, which only its interpreter loads. Here it cannot be used");
  }
  const process::FileDescriptor source(open(file.c_str(), O_RDONLY | O_CLOEXEC));
  struct stat status {};
  if (!source || fstat(source.get(), &status) != 0) {
    refuse_library(file, fmt::format("cannot be read: {}", std::strerror(errno)));
  }
  check_header(file, source.get(), status.st_size);
  memory_ = process::FileDescriptor(memfd_create(file.filename().c_str(), MFD_CLOEXEC | MFD_ALLOW_SEALING));
  if (!memory_) {
    refuse_library(file, fmt::format("no memory for a private copy: {}", std::strerror(errno)));
  }
  for (std::int64_t copied = 0; copied < status.st_size;) {
    const ssize_t count =
        sendfile(memory_.get(), source.get(), nullptr, static_cast<std::size_t>(status.st_size - copied));
    if (count <= 0) {
      refuse_library(
          file, fmt::format("cannot be copied: {}", count == 0 ? "it became shorter" : std::strerror(errno)));
    }
    copied += count;
  }
  fcntl(memory_.get(), F_ADD_SEALS, F_SEAL_WRITE | F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL);
}

std::string LibraryCopy::path() const {
  return fmt::format("/proc/self/fd/{}", memory_.get());
}

PluginLibrary::PluginLibrary(const std::string& library, const std::filesystem::path& base,
                             const SearchPath& path)
    : file_(find_plugin_file(library, base, path)),
      copy_(file_),
      handle_(dlopen(copy_.path().c_str(), RTLD_NOW | RTLD_LOCAL)) {
  if (handle_ == nullptr) {
    throw PluginError(fmt::format("{} cannot be loaded: {}. Is all that it links to installed?",
                                  file_.string(), loader_error(copy_.path(), file_)));
  }
  entry_ = static_cast<const gaitway_plugin*>(dlsym(handle_.get(), kEntrySymbol));
  if (entry_ == nullptr) {
    throw PluginError(
        fmt::format("{}: has no symbol '{}'. A plug-in ends in GAITWAY_PLUGIN(Class, name, version, "
                    "description) and is built with gaitway_plugin()",
                    file_.string(), kEntrySymbol));
  }
  check_border(*entry_, file_);
}

void PluginLibrary::Close::operator()(void* handle) const noexcept {
  dlclose(handle);
}

}  // namespace gaitway::core
