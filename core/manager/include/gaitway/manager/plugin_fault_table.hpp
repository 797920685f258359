// Faults that are injected into plug-ins' steps, to show that they are contained: filled by whoever plays a
// scenario, looked at by the plug-in manager.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string_view>
#include <utility>

namespace gaitway::core {

enum class PluginFaultKind : std::uint8_t {
  none,
  throws,        // the step ends in an exception
  not_a_number,  // each output's fields begin with a NaN
  jumps,         // ... with a number that lies 1000 beyond
  overruns       // the step takes longer
};

// As people write them.
inline constexpr std::array<std::pair<std::string_view, PluginFaultKind>, 4> kPluginFaultNames{
    {{"throws", PluginFaultKind::throws},
     {"not_a_number", PluginFaultKind::not_a_number},
     {"jumps", PluginFaultKind::jumps},
     {"overruns", PluginFaultKind::overruns}}};

struct PluginFault {
  PluginFaultKind kind = PluginFaultKind::none;
  std::int64_t cost_ns = 0;  // declared time of the step, in a run whose wall time does not count
};

// For one thread. Nothing allocates.
class PluginFaultTable {
 public:
  static constexpr std::size_t kCapacity = 32;

  // From now until `until_ns`; takes the place of an earlier fault of that plug-in. False: no room.
  bool inject(std::string_view plugin, const PluginFault& fault,
              std::int64_t until_ns = std::numeric_limits<std::int64_t>::max()) noexcept {
    const Entry* const own = find(plugin);
    const Entry* const free = own != nullptr ? own : find({});
    if (free == nullptr || plugin.size() > free->name.size()) {
      return false;
    }
    Entry* const entry = &entries_[static_cast<std::size_t>(free - entries_.data())];
    entry->length = plugin.size();
    std::ranges::copy(plugin, entry->name.begin());
    entry->fault = fault;
    entry->until_ns = until_ns;
    return true;
  }
  [[nodiscard]] PluginFault at(std::string_view plugin, std::int64_t now_ns) const noexcept {
    const Entry* const entry = find(plugin);
    return entry != nullptr && now_ns < entry->until_ns ? entry->fault : PluginFault{};
  }

 private:
  struct Entry {
    std::array<char, 48> name{};
    std::size_t length = 0;
    PluginFault fault;
    std::int64_t until_ns = 0;
  };
  [[nodiscard]] const Entry* find(std::string_view plugin) const noexcept {
    const auto found = std::ranges::find_if(entries_, [plugin](const Entry& entry) {
      return std::string_view(entry.name.data(), entry.length) == plugin;
    });
    return found == entries_.end() ? nullptr : &*found;
  }

  std::array<Entry, kCapacity> entries_{};
};

}  // namespace gaitway::core
