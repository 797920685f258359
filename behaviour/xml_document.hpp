// An XML document as elements and attributes that know their lines; tinyxml2 reads it.
//
// That library passes over some of what is not well-formed, and would give half of a file, or another text
// than the file has. Such is refused here: document types, other encodings than UTF-8, bytes that are no
// characters, unknown entities, '<' within a value, a second root, text around the root, an end tag too many
// or with attributes.
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

inline constexpr std::size_t kMostTags = 200'000;   // of elements, their ends and comments
inline constexpr std::size_t kMostAttributes = 64;  // of one element
// Elements within each other, at least: as many as tinyxml2 reads, which calls itself for each. The version
// that is linked decides: 9.0 reads 99 where the innermost one is written <x/>.
extern const std::size_t kMostLevels;

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
