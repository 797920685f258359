// An XML document as elements and attributes that know their lines; reads what behaviour trees need of
// XML 1.0.
//
// Left out, and refused by name: document types and so entities of one's own, other encodings than UTF-8.
// Comments and processing instructions are passed over. No function calls itself, so that depth costs no
// stack.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/input/complaint.hpp"

namespace gaitway::behaviour {

inline constexpr std::size_t kMostElements = 100'000;
inline constexpr std::size_t kMostAttributes = 64;  // of one element
inline constexpr std::size_t kMostLevels = 2'000;   // far more than a tree may have: that is told by its name

struct XmlAttribute {
  std::string name;
  std::string value;  // entities replaced
  int line = 0;
};

struct XmlElement {
  std::string name;
  int line = 0;
  std::vector<XmlAttribute> attributes{};
  bool has_text = false;  // other than white space
  std::int32_t parent = -1;
  std::int32_t first_child = -1;
  std::int32_t next_sibling = -1;

  [[nodiscard]] const XmlAttribute* find(std::string_view wanted) const noexcept;
};

// What is wrong with the XML itself. The reader stops there: what follows can't be understood.
struct XmlError : std::runtime_error {
  explicit XmlError(input::Complaint complaint)
      : std::runtime_error(complaint.rule), what_is_wrong(std::move(complaint)) {}
  input::Complaint what_is_wrong;
};

// Elements in the order in which they begin; the first is the root. Throws XmlError.
[[nodiscard]] std::vector<XmlElement> parse_xml(std::string_view text, const std::filesystem::path& file);

}  // namespace gaitway::behaviour
