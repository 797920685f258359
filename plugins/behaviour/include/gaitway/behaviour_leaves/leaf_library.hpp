// What a library of leaves shows, besides being a plug-in or whatever it is: its leaves, so that trees that
// have them can be checked and drawn without a robot (`gaitway behaviour check --with LIBRARY.so`).
//
//   void register_own(behaviour::Registry& registry, const std::shared_ptr<Robot>& robot);
//   GAITWAY_BEHAVIOUR_LEAVES(register_own)
#pragma once

#include <cstdint>
#include <memory>

#include "gaitway/behaviour/registry.hpp"
#include "gaitway/behaviour_leaves/leaves.hpp"

namespace gaitway::behaviour_leaves {

// Registry and LeafSpec cross the border as C++ objects: both sides must have them of the same make. Raise
// the number with every change of theirs.
inline constexpr std::uint64_t kLeafLibraryMake = (std::uint64_t{1} << 32U) |
                                                  (std::uint64_t{sizeof(behaviour::LeafSpec)} << 16U) |
                                                  sizeof(behaviour::PortSpec);

inline constexpr const char* kLeafLibraryMakeSymbol = "gaitway_behaviour_leaves_make";
inline constexpr const char* kLeafLibrarySymbol = "gaitway_behaviour_leaves";
using LeafLibraryMake = std::uint64_t (*)() noexcept;
using LeafLibraryRegister = void (*)(behaviour::Registry&);  // may throw std::invalid_argument

}  // namespace gaitway::behaviour_leaves

// `register_own(registry, robot)` adds the library's own leaves to those that are registered. Once a library,
// outside of any namespace.
#define GAITWAY_BEHAVIOUR_LEAVES(register_own)                                                              \
  extern "C" __attribute__((visibility("default"))) std::uint64_t gaitway_behaviour_leaves_make() noexcept; \
  extern "C" std::uint64_t gaitway_behaviour_leaves_make() noexcept {                                       \
    return gaitway::behaviour_leaves::kLeafLibraryMake;                                                     \
  }                                                                                                         \
  extern "C" __attribute__((visibility("default"))) void gaitway_behaviour_leaves(                          \
      gaitway::behaviour::Registry& registry);                                                              \
  extern "C" void gaitway_behaviour_leaves(gaitway::behaviour::Registry& registry) {                        \
    register_own(registry, std::make_shared<gaitway::behaviour_leaves::Robot>());                           \
  }
