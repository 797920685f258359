// Missions: behaviour trees in files, by path or by the name of a shipped one.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/behaviour/description.hpp"
#include "gaitway/behaviour/registry.hpp"

namespace gaitway::behaviour_leaves {

// The tree of a mission's file that may run while a person commands, when the robot has fallen under that
// command.
inline constexpr std::string_view kStandUpTree = "StandUp";

struct Mission {
  std::filesystem::path file;
  behaviour::Description tree;
  std::optional<behaviour::Description> stand_up;  // none: the file has no such tree
};

// In alphabetical order.
[[nodiscard]] std::vector<std::string> shipped_missions();

// A name is that of a shipped one unless there is a file of that path. Throws input::InputError.
[[nodiscard]] std::filesystem::path find_mission(const std::string& name_or_path);
// Throws behaviour::BadTree and input::InputError.
[[nodiscard]] Mission read_mission(const std::string& name_or_path, const behaviour::Registry& registry);

}  // namespace gaitway::behaviour_leaves
