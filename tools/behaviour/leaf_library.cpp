// Loads libraries of leaves (gaitway/behaviour_leaves/leaf_library.hpp). Their leaves are registered, never
// made.
#include "tools/behaviour/leaf_library.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <exception>
#include <stdexcept>

#include "gaitway/behaviour_leaves/leaf_library.hpp"

namespace gaitway::tools {
namespace {

void add_library(behaviour::Registry& registry, const std::filesystem::path& file) {
  const auto refuse = [&file](const std::string& what) -> void {
    throw std::invalid_argument(fmt::format("--with {}: {}", file.string(), what));
  };
  // With a '/', or it would be looked for among the system's libraries.
  void* const library = dlopen(std::filesystem::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    const char* const why = dlerror();
    refuse(fmt::format("cannot be loaded: {}", why != nullptr ? why : "no reason is known"));
  }
  const auto make = reinterpret_cast<behaviour_leaves::LeafLibraryMake>(
      dlsym(library, behaviour_leaves::kLeafLibraryMakeSymbol));
  const auto add = reinterpret_cast<behaviour_leaves::LeafLibraryRegister>(
      dlsym(library, behaviour_leaves::kLeafLibrarySymbol));
  if (make == nullptr || add == nullptr)
    refuse(
        "has no behaviour leaves. Name them by GAITWAY_BEHAVIOUR_LEAVES, as `gaitway new-plugin --kind "
        "behaviour` does");
  if (make() != behaviour_leaves::kLeafLibraryMake)
    refuse("was built for another version of Gaitway. Build it anew");
  try {
    add(registry);
  } catch (const std::exception& error) {
    refuse(error.what());
  }
}

}  // namespace

behaviour::Registry registry_with(const std::vector<std::filesystem::path>& libraries) {
  behaviour::Registry registry;
  behaviour_leaves::register_leaves(registry);
  for (const std::filesystem::path& library : libraries) add_library(registry, library);
  return registry;
}

}  // namespace gaitway::tools
