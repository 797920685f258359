// Reads the plug-in list with yaml-cpp; every complaint says where.
#include "gaitway/core/configuration.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "name_suggestion.hpp"

namespace gaitway::core {
namespace {

using Keys = std::vector<std::string>;

class Parser {
 public:
  explicit Parser(std::filesystem::path file) { configuration_.file = std::move(file); }

  Configuration parse(const std::string& text) {
    const YAML::Node root = load(text);
    require_map(root, "the configuration", {"plugins"});
    const YAML::Node plugins = root["plugins"];
    if (!plugins) {
      refuse(root, "the key 'plugins' is missing. List the plug-ins under it, each with a name");
    }
    if (!plugins.IsSequence() || plugins.size() == 0) {
      refuse(plugins, "plugins: must be a list with at least one plug-in, each an entry like '- name: zmp'");
    }
    for (const YAML::Node& plugin : plugins) {
      add(plugin);
    }
    return std::move(configuration_);
  }

 private:
  YAML::Node load(const std::string& text) {
    try {
      return YAML::Load(text);
    } catch (const YAML::Exception& error) {
      refuse_line(error.mark.line + 1,
                  fmt::format("no valid YAML: {}. Check indentation, colons and brackets here", error.msg));
    }
  }

  void add(const YAML::Node& node) {
    const auto number = configuration_.plugins.size();
    require_map(node, fmt::format("plugins[{}]", number), {"name", "library", "parameters"});
    PluginEntry entry;
    entry.line = node.Mark().line + 1;
    entry.name = required_text(node, "name", fmt::format("plugins[{}]", number));
    check_name(node["name"], entry.name);
    entry.library = node["library"] ? required_text(node, "library", entry.name)
                                    : fmt::format("libgaitway_plugin_{}.so", entry.name);
    if (node["parameters"]) {
      entry.parameters = parameters(node["parameters"], entry.name);
    }
    configuration_.plugins.push_back(std::move(entry));
  }

  void check_name(const YAML::Node& node, const std::string& name) {
    constexpr std::size_t kLongest = 40;
    const bool printable = std::all_of(name.begin(), name.end(), [](char c) { return c > ' ' && c < 0x7f; });
    if (name.empty() || name.size() > kLongest || !printable) {
      refuse(node, fmt::format("name: '{}': must have 1 to {} printable characters without spaces", name,
                               kLongest));
    }
    const auto same = [&name](const PluginEntry& other) { return other.name == name; };
    const auto first = std::find_if(configuration_.plugins.begin(), configuration_.plugins.end(), same);
    if (first != configuration_.plugins.end()) {
      refuse(node, fmt::format(
                       "name: '{}' is already the plug-in of line {}. Names must be unique: give one of them "
                       "another name",
                       name, first->line));
    }
  }

  std::vector<ParameterEntry> parameters(const YAML::Node& node, const std::string& plugin) {
    std::vector<ParameterEntry> result;
    if (node.IsNull()) {
      return result;
    }
    require_map(node, fmt::format("parameters of '{}'", plugin), {});
    for (const auto& pair : node) {
      const auto name = pair.first.as<std::string>();
      if (!pair.second.IsScalar()) {
        refuse(pair.first,
               fmt::format("parameter '{}' of '{}' must be one value: a number with or without unit, true or "
                           "false, or a text",
                           name, plugin));
      }
      result.push_back({name, pair.second.Scalar(), pair.first.Mark().line + 1});
    }
    return result;
  }

  std::string required_text(const YAML::Node& node, const std::string& key, const std::string& where) {
    const YAML::Node value = node[key];
    if (!value) {
      refuse(node, fmt::format("{}: the key '{}' is missing", where, key));
    }
    if (!value.IsScalar() || value.Scalar().empty()) {
      refuse(value, fmt::format("{}: {}: must be a text", where, key));
    }
    return value.Scalar();
  }

  // A map without doubled keys, and only with `known` ones; any if `known` is empty.
  void require_map(const YAML::Node& node, const std::string& what, const Keys& known) {
    if (!node.IsMap()) {
      refuse(node, fmt::format("{} must be a map of keys and values", what));
    }
    Keys seen;
    for (const auto& pair : node) {
      if (!pair.first.IsScalar()) {
        refuse(pair.first, fmt::format("{}: a key must be a plain text", what));
      }
      const std::string key = pair.first.Scalar();
      if (!known.empty() && std::find(known.begin(), known.end(), key) == known.end()) {
        refuse(pair.first, fmt::format("{}: unknown key '{}'. {}", what, key, suggest(key, known)));
      }
      if (std::find(seen.begin(), seen.end(), key) != seen.end()) {
        refuse(pair.first, fmt::format("{}: the key '{}' is there twice. Remove one", what, key));
      }
      seen.push_back(key);
    }
  }

  [[noreturn]] void refuse(const YAML::Node& node, const std::string& complaint) {
    refuse_line(std::max(node.Mark().line, 0) + 1, complaint);
  }
  [[noreturn]] void refuse_line(int line, const std::string& complaint) {
    throw ConfigurationError(fmt::format("{}:{}: {}", configuration_.file.string(), line, complaint));
  }

  Configuration configuration_;
};

}  // namespace

Configuration parse_configuration(const std::string& text, const std::filesystem::path& file) {
  return Parser(file).parse(text);
}

Configuration read_configuration(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file)) {
    throw ConfigurationError(
        fmt::format("{}: cannot be read; is there such a file, and may it be read?", file.string()));
  }
  std::ostringstream text;
  text << in.rdbuf();
  return parse_configuration(text.str(), file);
}

}  // namespace gaitway::core
