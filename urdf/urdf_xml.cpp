// Parses a URDF's XML and tells what is wrong with it as XML.
#include "gaitway/urdf/urdf_xml.hpp"

#include <fmt/format.h>
#include <tinyxml.h>

#include <algorithm>
#include <cctype>
#include <string_view>

#include "gaitway/input/complaint.hpp"

namespace gaitway::urdf {
namespace {

// Where the tag ends that begins at `place`: behind the first '>' outside quotes.
std::size_t end_of_tag(std::string_view text, std::size_t place) {
  char quote = '\0';
  for (; place < text.size(); ++place) {
    const char letter = text[place];
    if (quote != '\0') {
      quote = letter == quote ? '\0' : quote;
    } else if (letter == '"' || letter == '\'') {
      quote = letter;
    } else if (letter == '>') {
      return place + 1;
    }
  }
  return text.size();
}

// Looks over the tags before the parser does, which calls itself for each level of elements: refuses more
// levels than a URDF has, and what the parser would tell wrongly.
class Outline {
 public:
  Outline(const std::filesystem::path& file, std::string_view text) : file_(file), text_(text) {}

  void check() {
    while ((place_ = text_.find('<', place_)) != std::string_view::npos) {
      const std::string_view rest = text_.substr(place_);
      if (rest.starts_with("<!--")) {
        skip(4, "-->");
      } else if (rest.starts_with("<![CDATA[")) {
        skip(9, "]]>");
      } else if (rest.starts_with("<!DOCTYPE")) {
        refuse("<!DOCTYPE", "a URDF has no DOCTYPE, and its entities are not read", "Remove it");
      } else if (rest.starts_with("<?")) {
        const std::size_t end = end_of_tag(text_, place_);
        skip(2, ">");
        if (place_ != end) {
          refuse("<?", "malformed XML: a '>' stands between quotes", "Write <?xml version=\"1.0\"?>");
        }
      } else if (rest.starts_with("</")) {
        depth_ = std::max(0, depth_ - 1);
        skip(2, ">");
      } else if (begins_element(rest)) {
        enter();
      } else {
        skip(1, ">");
      }
    }
  }

 private:
  static bool begins_element(std::string_view rest) {
    const auto letter = static_cast<unsigned char>(rest.size() > 1 ? rest[1] : '\0');
    return std::isalpha(letter) != 0 || letter == '_' || letter >= 0x7F;
  }
  void enter() {
    constexpr int kDeepest = 32;
    if (++depth_ > kDeepest) {
      refuse("", fmt::format("elements must not be nested more than {} deep", kDeepest),
             "A URDF needs six levels: look for tags that are not closed");
    }
    place_ = end_of_tag(text_, place_);
    depth_ -= text_.substr(0, place_).ends_with("/>") ? 1 : 0;
  }
  void skip(std::size_t start_bytes, std::string_view end) {
    const std::size_t found = text_.find(end, place_ + start_bytes);
    place_ = found == std::string_view::npos ? text_.size() : found + end.size();
  }
  [[noreturn]] void refuse(const std::string& field, const std::string& rule,
                           const std::string& remedy) const {
    const std::string_view before = text_.substr(0, place_);
    input::refuse({file_, 1 + static_cast<int>(std::count(before.begin(), before.end(), '\n')), field, "",
                   rule, remedy});
  }

  const std::filesystem::path& file_;
  std::string_view text_;
  std::size_t place_ = 0;
  int depth_ = 0;
};

}  // namespace

const TiXmlElement& parse_urdf_xml(const std::filesystem::path& file, const std::string& text,
                                   TiXmlDocument& document) {
  Outline(file, text).check();
  document.Parse(text.c_str());
  if (document.Error()) {
    input::refuse({file, document.ErrorRow(), fmt::format("column {}", document.ErrorCol()), "",
                   fmt::format("malformed XML: {}", document.ErrorDesc()),
                   "Check tags and quotes there and above"});
  }
  const TiXmlElement* robot = document.RootElement();
  if (!robot || robot->ValueStr() != "robot") {
    input::refuse({file, robot ? robot->Row() : 0, "", "", "the outermost element must be <robot>",
                   "A URDF reads <robot name=\"...\"> ... </robot>"});
  }
  return *robot;
}

}  // namespace gaitway::urdf
