// Reads behaviour trees in the XML format of BehaviorTree.CPP 4 and checks them against a registry.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/behaviour/description.hpp"
#include "gaitway/behaviour/registry.hpp"
#include "gaitway/input/complaint.hpp"

namespace gaitway::behaviour {

struct TreeComplaint : input::Complaint {
  std::string path;  // of the node, from the tree's ID: "Patrol/Sequence/GoTo"; empty: it is about no node
};

// Everything that is wrong with a file. what() has a line for each complaint.
class BadTree : public input::InputError {
 public:
  explicit BadTree(std::vector<TreeComplaint> complaints);
  // In the file's order; at least one, at most kMostComplaints.
  [[nodiscard]] const std::vector<TreeComplaint>& complaints() const noexcept { return complaints_; }

 private:
  std::vector<TreeComplaint> complaints_;
};
inline constexpr std::size_t kMostComplaints = 100;

// Throws BadTree, and input::InputError for a file that can't be read.
[[nodiscard]] Description read_tree(const std::filesystem::path& file, const Registry& registry);
// The same of a text; `file` is what complaints call it.
[[nodiscard]] Description parse_tree(std::string_view text, const std::filesystem::path& file,
                                     const Registry& registry);
// The tree of that ID in place of the file's main tree; nothing: the file has none of that name.
[[nodiscard]] std::optional<Description> parse_tree_of_id(std::string_view text,
                                                          const std::filesystem::path& file,
                                                          const Registry& registry, std::string_view id);

}  // namespace gaitway::behaviour
