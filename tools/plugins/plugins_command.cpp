// `gaitway plugins`: which plug-ins there are, and what each says of itself.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "gaitway/input/text.hpp"
#include "gaitway/isolation/plugin_probe.hpp"
#include "gaitway/process/installation.hpp"
#include "tools/command_line.hpp"

namespace gaitway::tools {
namespace {

struct PluginsOptions {
  std::vector<std::filesystem::path> files;                          // these alone
  std::vector<std::filesystem::path> plugin_path;                    // these alone; empty: the search path
  std::filesystem::path robot = process::default_robot_directory();  // what the plug-ins are told
  bool json = false;
};

using nlohmann::ordered_json;

constexpr std::array<std::string_view, core::kAccesses.size()> kAccessNames{
    "read", "read_previous", "read_optional", "write", "read_previous_optional"};

std::string_view access_name(core::Access access) {
  return kAccessNames[static_cast<std::size_t>(access)];
}

std::vector<std::filesystem::path> libraries_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".so" && core::is_plugin_library(entry.path())) {
      files.push_back(entry.path());
    }
  }
  std::ranges::sort(files);
  return files;
}

std::vector<std::filesystem::path> libraries_of(const PluginsOptions& options) {
  for (const std::filesystem::path& file : options.files) {
    if (!std::filesystem::is_regular_file(file)) {
      throw std::invalid_argument(
          fmt::format("'{}': is no file. Name a plug-in's library, or its file in Python", file.string()));
    }
  }
  if (!options.files.empty()) {
    return options.files;
  }
  for (const std::filesystem::path& folder : options.plugin_path) {
    if (!std::filesystem::is_directory(folder)) {
      throw std::invalid_argument(
          fmt::format("--plugin-path {}: is no folder. Name one that holds plug-ins", folder.string()));
    }
  }
  std::vector<std::filesystem::path> files;
  for (const std::filesystem::path& folder :
       options.plugin_path.empty() ? core::plugin_search_path({}) : options.plugin_path) {
    if (std::filesystem::is_directory(folder)) {
      const std::vector<std::filesystem::path> found = libraries_in(folder);
      files.insert(files.end(), found.begin(), found.end());
    }
  }
  return files;
}

ordered_json as_json(const core::PluginDescription& plugin) {
  ordered_json topics = ordered_json::array(), parameters = ordered_json::array();
  for (const core::TopicUse& topic : plugin.topics) {
    topics.push_back(
        {{"name", topic.topic}, {"type", topic.type_name}, {"access", access_name(topic.access)}});
  }
  for (const core::Parameter& parameter : plugin.parameters) {
    const std::string_view kind = core::parameter_kind_name(parameter.kind);
    ordered_json described{{"name", parameter.name},       {"kind", kind},
                           {"unit", parameter.unit},       {"default", parameter.fallback},
                           {"description", parameter.doc}, {"live", parameter.live}};
    const bool is_number = kind == "number" || kind == "integer";
    if (is_number && std::isfinite(parameter.lowest)) {
      described["lowest"] = parameter.lowest;
    }
    if (is_number && std::isfinite(parameter.highest)) {
      described["highest"] = parameter.highest;
    }
    parameters.push_back(described);
  }
  return {{"name", plugin.name},
          {"version", plugin.version},
          {"description", plugin.text},
          {"library", plugin.file.string()},
          {"period", plugin.period == Period::tick ? "tick" : "batch"},
          {"topics", topics},
          {"parameters", parameters}};
}

std::string topics_of(const core::PluginDescription& plugin, bool written) {
  std::string text;
  for (const core::TopicUse& topic : plugin.topics) {
    if ((topic.access == core::Access::write) == written) {
      text += (text.empty() ? "" : ", ") + topic.topic;
      text += core::is_of_tick_before(topic.access) ? " (of the tick before)" : "";
      text += written || core::needs_writer(topic.access) ? "" : " (optional)";
    }
  }
  return text.empty() ? "nothing" : text;
}

std::string describe(const core::PluginDescription& plugin) {
  std::string text = fmt::format("{} {}  {}\n", plugin.name, plugin.version, plugin.text);
  text += fmt::format("  library     {}\n", plugin.file.string());
  text += fmt::format("  stepped     every {}\n",
                      plugin.period == Period::tick ? "10 ms" : "80 ms, for each batch");
  text += fmt::format("  reads       {}\n", topics_of(plugin, false));
  text += fmt::format("  writes      {}\n", topics_of(plugin, true));
  for (const core::Parameter& parameter : plugin.parameters) {
    const bool has_unit = !parameter.unit.empty() && parameter.unit != "1";
    text +=
        fmt::format("  {:<11} {} = {}{}{}{}\n", &parameter == plugin.parameters.data() ? "parameters" : "",
                    parameter.name, parameter.fallback, has_unit ? " " + parameter.unit : "",
                    parameter.live ? ", may be changed while it runs" : "",
                    parameter.doc.empty() ? "" : "  " + parameter.doc);
  }
  return text;
}

int list_plugins(const PluginsOptions& options) {
  const core::ProbeOptions probe{.robot_directory = options.robot,
                                 .plugin_path = core::plugin_search_path(options.plugin_path)};
  ordered_json list = ordered_json::array();
  int exit_code = 0;
  for (const std::filesystem::path& file : libraries_of(options)) {
    try {
      const core::PluginDescription plugin = core::probe_plugin(file, probe);
      if (options.json) {
        list.push_back(as_json(plugin));
      } else {
        fmt::print("{}", input::terminal_text(describe(plugin)));
      }
    } catch (const core::PluginError& error) {
      fmt::print(stderr, "gaitway: not usable: {}\n", input::terminal_text(error.what()));
      exit_code = 1;
    }
  }
  if (options.json) {
    fmt::print("{}\n", list.dump(2));
  }
  return exit_code;
}

}  // namespace

void declare_program(const CommandLine& app) {
  const CommandLine command = add_command(app, "plugins");
  PluginsOptions& options = command.runs(list_plugins);
  command.repeated("files", options.files,
                   "Plug-ins to ask, FILE.so or FILE.py, instead of those that are found");
  command.repeated("--plugin-path", options.plugin_path,
                   "Folder to look in, instead of GAITWAY_PLUGIN_PATH and the shipped plug-ins; may be given "
                   "again");
  command.option("--robot", options.robot, "Robot that the plug-ins are asked for");
  command.option("--json", options.json, "For programs");
  command.footer(
      "Examples:\n"
      "  gaitway plugins\n"
      "  gaitway plugins --plugin-path build --json\n"
      "  gaitway plugins sway.py\n"
      "Exit code: 0 all are usable, 1 one is not, or the input was bad.");
}

}  // namespace gaitway::tools
