// Reads the settings of a plug-in's process strictly.
#include "gaitway/isolation/settings.hpp"

#include <algorithm>
#include <string>
#include <string_view>

#include "gaitway/input/yaml_value.hpp"

namespace gaitway::core {
namespace {

using input::YamlValue;

constexpr std::int64_t kNetworkHang_ns = 500'000'000;

bool read_network(const YamlValue& value) {
  const std::string text = value.text();
  if (text != "serve" && text != "none") {
    value.refuse("must be 'serve' or 'none'",
                 "'serve' lets the plug-in accept connections, 'none' keeps it from the network");
  }
  return text == "serve";
}

std::filesystem::path read_folder(const YamlValue& value, bool serves_network) {
  if (!serves_network) {
    value.refuse("is for plug-ins with 'network: serve' alone", "Add 'network: serve', or leave it out");
  }
  const std::string text = value.text();
  if (text.empty()) {
    value.refuse("must not be empty", "Name a folder, or leave the key out");
  }
  return std::filesystem::absolute(value.file().parent_path() / text).lexically_normal();
}

}  // namespace

ChildSettings read_child_settings(const YamlValue& plugin, bool isolated) {
  ChildSettings settings;
  for (const std::string_view key : {"network", "writes", "descriptors", "memory"}) {
    if (const auto value = plugin.find(key); value && !isolated) {
      value->refuse("is for plug-ins in processes of their own alone",
                    "Add 'isolation: process', or leave it out");
    }
  }
  if (const auto network = plugin.find("network")) {
    settings.serves_network = read_network(*network);
  }
  if (const auto writes = plugin.find("writes")) {
    settings.writes = read_folder(*writes, settings.serves_network);
  }
  if (const auto descriptors = plugin.find("descriptors")) {
    settings.descriptor_limit = static_cast<std::uint32_t>(descriptors->integer(16, 4096));
  }
  if (const auto memory = plugin.find("memory")) {
    settings.memory_limit_bytes = static_cast<std::uint64_t>(
        memory->number_with_unit(input::kSizeUnits_bytes, std::int64_t{64} << 20U, std::int64_t{64} << 30U));
  }
  return settings;
}

IsolationOptions options_for(const ChildSettings& settings, IsolationOptions options) noexcept {
  if (settings.descriptor_limit != 0) {
    options.descriptor_limit = settings.descriptor_limit;
  }
  if (settings.memory_limit_bytes != 0 && options.memory_limit_bytes != 0) {
    options.memory_limit_bytes = settings.memory_limit_bytes;
  }
  if (settings.serves_network) {
    // It has no priority, and nobody waits for what it does.
    options.hang_ns = std::max(options.hang_ns, kNetworkHang_ns);
  }
  return options;
}

}  // namespace gaitway::core
