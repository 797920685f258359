// `gaitway behaviour`: behaviour trees are checked and drawn, and the leaves that they may have are listed.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "gaitway/behaviour/draw.hpp"
#include "gaitway/behaviour/read.hpp"
#include "gaitway/behaviour_leaves/mission.hpp"
#include "gaitway/behaviour_leaves/node_model.hpp"
#include "gaitway/process/text_file.hpp"
#include "tools/behaviour/leaf_library.hpp"
#include "tools/behaviour/leaf_list.hpp"
#include "tools/command_line.hpp"

namespace gaitway::tools {
namespace {

using behaviour::Description;
using nlohmann::json;

struct CheckOptions {
  std::vector<std::string> missions;
  std::vector<std::filesystem::path> libraries;
  bool json = false;
};

struct DrawOptions {
  std::string mission;
  std::vector<std::filesystem::path> libraries;
  std::filesystem::path out;
};

struct LeavesOptions {
  std::vector<std::filesystem::path> libraries;
  bool json = false;
  bool model = false;
};

std::size_t depth_of(const Description& tree) {
  std::int32_t most = 0;
  for (const behaviour::DescribedNode& node : tree.nodes) most = std::max(most, node.depth);
  return static_cast<std::size_t>(most) + 1;
}

// "GetUp x2, WalkTo x4".
std::string leaves_of(const Description& tree, const behaviour::Registry& registry) {
  std::map<std::string, int> counts;
  for (const behaviour::DescribedNode& node : tree.nodes) {
    if (registry.find(node.id) != nullptr) ++counts[node.id];
  }
  std::string text;
  for (const auto& [id, count] : counts)
    text += fmt::format("{}{}{}", text.empty() ? "" : ", ", id, count > 1 ? fmt::format(" x{}", count) : "");
  return text.empty() ? "none" : text;
}

json as_json(const std::filesystem::path& file, const behaviour::TreeComplaint& complaint) {
  return {{"file", file.string()},     {"line", complaint.line},   {"node", complaint.path},
          {"field", complaint.field},  {"value", complaint.value}, {"rule", complaint.rule},
          {"remedy", complaint.remedy}};
}

// The result as JSON; what people read is printed on the way.
json check_one(const std::string& name, const behaviour::Registry& registry, bool quiet) {
  json told{{"file", name}, {"fine", false}, {"complaints", json::array()}};
  try {
    const behaviour_leaves::Mission mission = behaviour_leaves::read_mission(name, registry);
    const Description& tree = mission.tree;
    told.update({{"file", mission.file.string()},
                 {"fine", true},
                 {"tree", tree.main_tree},
                 {"nodes", tree.nodes.size()},
                 {"depth", depth_of(tree)},
                 {"stands_up_under_a_person", mission.stand_up.has_value()}});
    if (!quiet) {
      fmt::print("{}: {}, {} node{}, {} deep; leaves: {}\n", mission.file.string(), tree.main_tree,
                 tree.nodes.size(), tree.nodes.size() == 1 ? "" : "s", depth_of(tree),
                 leaves_of(tree, registry));
    }
  } catch (const behaviour::BadTree& bad) {
    for (const auto& complaint : bad.complaints())
      told["complaints"].push_back(as_json(complaint.file, complaint));
    if (!quiet) fmt::print(stderr, "{}\n", bad.what());
  } catch (const input::InputError& bad) {
    told["complaints"].push_back({{"file", name}, {"rule", bad.what()}});
    if (!quiet) fmt::print(stderr, "{}\n", bad.what());
  }
  return told;
}

int check(const CheckOptions& options) {
  const behaviour::Registry registry = registry_with(options.libraries);
  json all = json::array();
  bool fine = true;
  for (const std::string& mission : options.missions) {
    all.push_back(check_one(mission, registry, options.json));
    fine = fine && all.back().at("fine").get<bool>();
  }
  if (options.json) fmt::print("{}\n", all.dump(2));
  return fine ? kExitFine : kExitBadInput;
}

int draw_tree(const DrawOptions& options) {
  const behaviour::Registry registry = registry_with(options.libraries);
  const behaviour_leaves::Mission mission = behaviour_leaves::read_mission(options.mission, registry);
  const std::filesystem::path out = options.out.empty() ? mission.file.stem().concat(".svg") : options.out;
  if (out.extension() != ".svg") {
    throw std::invalid_argument(
        fmt::format("--out {}: a tree is drawn as SVG. Give a file whose name ends with .svg", out.string()));
  }
  process::write_text_file(out, behaviour::draw(mission.tree));
  fmt::print("{}\n", out.string());
  return kExitFine;
}

int list_leaves(const LeavesOptions& options) {
  const behaviour::Registry registry = registry_with(options.libraries);
  if (options.model) {
    fmt::print("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<root BTCPP_format=\"4\">\n{}</root>\n",
               behaviour_leaves::tree_nodes_model(registry));
  } else if (options.json) {
    fmt::print("{}\n", leaves_json(registry).dump(2));
  } else {
    fmt::print("{}", leaves_text(registry));
  }
  return kExitFine;
}

constexpr const char* kWith =
    "A library with further leaves, as a plug-in of the kind `behaviour` is; may be repeated";

}  // namespace

void declare_program(const CommandLine& app) {
  const CommandLine command = add_command(app, "behaviour");
  command.needs_subcommand();
  const CommandLine checks = command.subcommand("check", "Read trees, and tell all that is wrong with them");
  CheckOptions& checked = checks.runs(check);
  checks.repeated("mission", checked.missions, "Files, or names of shipped missions").required();
  checks.repeated("--with", checked.libraries, kWith);
  checks.option("--json", checked.json, "The result as JSON");

  const CommandLine draws = command.subcommand("draw", "A tree as a picture, its sub-trees put in");
  DrawOptions& drawn = draws.runs(draw_tree);
  draws.option("mission", drawn.mission, "A file, or the name of a shipped mission").required();
  draws.option("--out", drawn.out, "SVG file; otherwise NAME.svg");
  draws.repeated("--with", drawn.libraries, kWith);

  const CommandLine leaves =
      command.subcommand("leaves", "The leaves that trees may have, with ports and units");
  LeavesOptions& listed = leaves.runs(list_leaves);
  const Option as_json = leaves.option("--json", listed.json, "The list as JSON");
  leaves.option("--model", listed.model, "As TreeNodesModel, for Groot: import it as models")
      .excludes(as_json);
  leaves.repeated("--with", listed.libraries, kWith);
  command.footer(
      "Examples:\n"
      "  gaitway behaviour check my_mission.xml\n"
      "  gaitway behaviour draw find_and_walk_to_tag --out tree.svg\n"
      "  gaitway behaviour leaves --model > leaves.xml\n"
      "  gaitway behaviour check my_mission.xml --with build/libmy_leaves.so\n"
      "Exit code: 0 fine, 1 something is wrong with a tree, or the input was bad.");
}

}  // namespace gaitway::tools
