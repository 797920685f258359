// Looks over a DAE's tags for what grows without bound when nodes are put where they are instanced.
#include "dae_outline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <stdexcept>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace gaitway::importer {
namespace {

constexpr std::size_t kDeepest = 64;
constexpr std::size_t kMostNodes = 10'000;  // of a file that instances nodes

[[noreturn]] void refuse_depth() {
  throw std::runtime_error(fmt::format("elements are nested more than {} deep", kDeepest));
}

struct Node {
  std::vector<std::size_t> holds;       // nodes within it
  std::vector<std::string_view> named;  // what it instances, by id or name
};

// The nodes of a file, with every element's depth within bounds. It divides text into tags as XML parsers do:
// what it would divide otherwise is malformed, and is refused by them.
class Outline {
 public:
  explicit Outline(std::string_view text) : text_(text) {}

  void read() {
    while ((place_ = text_.find('<', place_)) != std::string_view::npos) {
      const std::string_view rest = text_.substr(place_);
      if (rest.starts_with("<!--")) {
        skip(4, "-->");
      } else if (rest.starts_with("<![CDATA[")) {
        skip(9, "]]>");
      } else if (rest.starts_with("<!")) {
        throw std::runtime_error("a DOCTYPE is not read");
      } else if (rest.starts_with("<?")) {
        skip(2, "?>");
      } else if (rest.starts_with("</")) {
        skip(2, ">");
        if (!open_.empty()) open_.pop_back();
      } else {
        enter();
      }
    }
  }
  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  // The nodes that an instance may mean. The library's ids come before names.
  [[nodiscard]] std::vector<std::size_t> called(std::string_view name) const {
    std::vector<std::size_t> found;
    const auto add = [&](const Nodes& nodes) {
      const auto [first, last] = nodes.equal_range(name);
      for (auto node = first; node != last; ++node) {
        if (std::find(found.begin(), found.end(), node->second) == found.end()) found.push_back(node->second);
      }
    };
    add(by_id_);
    if (!library_ids_.contains(name)) add(by_name_);
    return found;
  }
  [[nodiscard]] bool has_instances() const { return has_instances_; }
  [[nodiscard]] bool has_plain_names() const { return has_plain_names_; }

 private:
  using Nodes = std::unordered_multimap<std::string_view, std::size_t>;
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  void skip(std::size_t start_bytes, std::string_view end) {
    const std::size_t found = text_.find(end, place_ + start_bytes);
    place_ = found == std::string_view::npos ? text_.size() : found + end.size();
  }
  void skip_space() {
    while (place_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[place_])) != 0) ++place_;
  }
  std::string_view take_name() {
    const std::size_t begin = place_;
    while (place_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[place_])) == 0 &&
           std::string_view("=/>").find(text_[place_]) == std::string_view::npos) {
      ++place_;
    }
    return text_.substr(begin, place_ - begin);
  }

  void enter() {
    if (open_.size() >= kDeepest) refuse_depth();
    ++place_;
    const std::string_view tag = take_name();
    if (open_.size() == 1) in_library_ = tag == "library_nodes";
    const std::size_t around = open_.empty() ? kNone : open_.back();
    std::size_t node = around;
    if (tag == "node" || tag == "visual_scene") {
      node = nodes_.size();
      nodes_.emplace_back();
      if (around != kNone) nodes_[around].holds.push_back(node);
    }
    if (!read_attributes(tag, node)) open_.push_back(node);
  }
  // Whether the element ends with its tag.
  bool read_attributes(std::string_view tag, std::size_t node) {
    for (;;) {
      skip_space();
      if (place_ >= text_.size()) return true;
      if (text_[place_] == '>') {
        ++place_;
        return false;
      }
      if (text_[place_] == '/') {
        skip(0, ">");
        return true;
      }
      const std::string_view name = take_name();
      const std::size_t quote = text_.find_first_of("\"'>", place_);
      if (quote == std::string_view::npos || text_[quote] == '>') throw std::runtime_error("malformed XML");
      const std::size_t end = text_.find(text_[quote], quote + 1);
      if (end == std::string_view::npos) throw std::runtime_error("malformed XML");
      take_attribute(tag, node, name, text_.substr(quote + 1, end - quote - 1));
      place_ = end + 1;
    }
  }
  void take_attribute(std::string_view tag, std::size_t node, std::string_view name, std::string_view value) {
    const bool is_node = tag == "node" || tag == "visual_scene", is_instance = tag == "instance_node";
    if (!(is_node && (name == "id" || name == "name")) && !(is_instance && name == "url")) return;
    has_plain_names_ = has_plain_names_ && value.find_first_of("&\t\r\n") == value.npos;
    if (is_node) {
      (name == "id" ? by_id_ : by_name_).emplace(value, node);
      if (name == "id" && in_library_ && open_.size() == 2) library_ids_.insert(value);
    } else {
      has_instances_ = true;
      if (node != kNone) nodes_[node].named.push_back(value.substr(value.starts_with('#') ? 1 : 0));
    }
  }

  std::string_view text_;
  std::size_t place_ = 0;
  std::vector<std::size_t> open_;  // of each open element: the node in which it lies
  std::vector<Node> nodes_;
  Nodes by_id_, by_name_;
  std::unordered_set<std::string_view> library_ids_;
  bool in_library_ = false;  // <library_nodes> right below the outermost element
  bool has_instances_ = false, has_plain_names_ = true;
};

struct Size {
  std::size_t nodes = 0, levels = 0;
};

// How large each node is with all that it instances. Of several that are called alike the reader takes one:
// each is counted.
class Expansion {
 public:
  explicit Expansion(const Outline& outline)
      : outline_(outline), size_(outline.nodes().size()), is_open_(outline.nodes().size(), false) {}

  void check() {
    for (std::size_t i = 0; i < size_.size(); ++i) (void)size_of(i, 1);
  }

 private:
  Size size_of(std::size_t index, std::size_t level) {
    if (is_open_[index])
      throw std::runtime_error("its nodes hold themselves: an instance_node leads back to where it is");
    if (level > kDeepest) refuse_depth();
    Size& size = size_[index];
    if (size.nodes > 0) return size;
    is_open_[index] = true;
    Size whole{1, 1};
    const auto add = [&](std::size_t part) {
      const Size found = size_of(part, level + 1);
      whole.nodes += found.nodes;
      whole.levels = std::max(whole.levels, found.levels + 1);
      if (whole.levels > kDeepest) refuse_depth();
      if (whole.nodes > kMostNodes) {
        throw std::runtime_error(fmt::format("its instances make more than {} nodes", kMostNodes));
      }
    };
    const Node& node = outline_.nodes()[index];
    for (const std::size_t part : node.holds) add(part);
    for (const std::string_view name : node.named) {
      for (const std::size_t part : outline_.called(name)) add(part);
    }
    is_open_[index] = false;
    return size = whole;
  }

  const Outline& outline_;
  std::vector<Size> size_;
  std::vector<bool> is_open_;
};

}  // namespace

void check_dae(std::string_view text) {
  // Of two bytes a letter: parsers that see it would find tags where this finds none.
  if (text.find('\0') != text.npos) throw std::runtime_error("its text must be UTF-8");
  Outline outline(text);
  outline.read();
  if (!outline.has_instances()) return;
  if (!outline.has_plain_names()) {
    throw std::runtime_error(
        "names of nodes that are instanced must be plain text, without '&' and line ends");
  }
  Expansion(outline).check();
}

}  // namespace gaitway::importer
