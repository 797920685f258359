// What a child can still tell when it dies, and when it has used up what it may use.
#pragma once

#include <cstdint>

#include "exchange.hpp"

namespace gaitway::core {

// Deaths inside this plug-in's library are told as offsets into it.
void describe_deaths_in(const gaitway_plugin& entry) noexcept;
// A signal that ends this process writes here what it knows; the process still ends by that signal.
void leave_last_words_in(LastWords& words) noexcept;

enum class Resource : std::uint32_t { none = 0, memory = 1, descriptors = 2 };
// What is as good as used up.
[[nodiscard]] Resource exhausted_resource() noexcept;

}  // namespace gaitway::core
