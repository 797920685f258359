// From tinyxml2's document to a list of elements; what tinyxml2 found wrong, in words; what it passes over.
#include "xml_document.hpp"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "xml_characters.hpp"

namespace gaitway::behaviour {
namespace {

// Stands behind the file's text: where it is not the last thing that was read, reading ended before.
constexpr std::string_view kEnd = "\n<end-of-file/>";

struct Fault {
  int line = 0;
  std::string field{};
  std::string rule{};
  std::string remedy{};
};

// The name within tinyxml2's own words: "Error=... : XMLElement name=Sequence".
std::string named(const tinyxml2::XMLDocument& document) {
  const std::string_view words = document.ErrorStr();
  constexpr std::string_view kMark = "XMLElement name=";
  const std::size_t at = words.find(kMark);
  return at == std::string_view::npos ? "" : std::string(words.substr(at + kMark.size()));
}

// What tinyxml2 could not read.
Fault what_failed(const tinyxml2::XMLDocument& document) {
  const std::string name = named(document);
  const std::string tag = name.empty() ? "" : "<" + name + ">";
  const int line = std::max(1, document.ErrorLineNum());
  switch (document.ErrorID()) {
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT:
      return {line, tag, fmt::format("is not closed by </{}>", name),
              fmt::format("Add </{}>, or take away the end tag that stands in its place", name)};
    case tinyxml2::XML_ERROR_PARSING_ELEMENT:
      return {line, tag, "the tag has no end, or something in it is no attribute",
              "Write NAME=\"value\" between blanks, then > or />; &lt; for a '<'"};
    case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE:
      return {line, tag, "an attribute has no value, no quotes around it, or is there twice",
              "Write each once, as NAME=\"value\""};
    case tinyxml2::XML_ERROR_PARSING_COMMENT:
      return {line, "", "a comment does not end", "Add -->"};
    case tinyxml2::XML_ERROR_PARSING_CDATA:
      return {line, "", "a CDATA section does not end", "Add ]]>"};
    case tinyxml2::XML_ERROR_PARSING_UNKNOWN:
      return {line, "<!", "document types are not read, nor entities that they define", "Remove it"};
    case tinyxml2::XML_ERROR_PARSING_DECLARATION:
      return {line, "<?", "stands only at the file's beginning, and ends with ?>", "Remove it"};
    case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED:
      return {line, "", fmt::format("more than {} levels of elements", kMostLevels), "Use sub-trees"};
    default:
      return {line, tag, "what begins here is not closed, or is no element",
              "Close each element by </NAME> or />; write &lt; for a '<'"};
  }
}

// What a line holds, for whoever looks for the place; cut off where it is long.
std::string written_in(std::string_view text, int line) {
  constexpr std::size_t kMost = 60;
  for (int i = 1; i < line; ++i) text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  text = text.substr(0, text.find('\n'));
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r"), text.size()));
  text = text.substr(0, text.find_last_not_of(" \t\r") + 1);
  std::string shown(text.substr(0, kMost));
  while (shown.size() < text.size() && !shown.empty() && first_forbidden(shown)) shown.pop_back();
  return shown + (shown.size() < text.size() ? "..." : "");
}

// The declaration's encoding, if it is one that would be misread.
std::optional<std::string> strange_encoding(std::string_view declaration) {
  const std::size_t at = declaration.find("encoding");
  const std::size_t quote = at == std::string_view::npos ? at : declaration.find_first_of("\"'", at);
  if (quote == std::string_view::npos) return std::nullopt;
  const std::string_view name =
      declaration.substr(quote + 1, declaration.find(declaration[quote], quote + 1) - quote - 1);
  for (const std::string_view known : {"UTF-8", "utf-8", "US-ASCII", "us-ascii", "ASCII"}) {
    if (name == known) return std::nullopt;
  }
  return std::string(name);
}

// Walks through the document, at most as deep as tinyxml2 has read, and stops at the first thing that it had
// better refused.
class Elements final : public tinyxml2::XMLVisitor {
 public:
  explicit Elements(const tinyxml2::XMLElement* end) : end_(end) {}

  std::vector<XmlElement> elements;
  std::optional<Fault> fault{};

  bool VisitEnter(const tinyxml2::XMLElement& read, const tinyxml2::XMLAttribute* attribute) override {
    if (&read == end_) return false;
    if (open_ < 0 && !elements.empty()) {
      return refuse({read.GetLineNum(), fmt::format("<{}>", read.Name()), "a second root element",
                     "Put it into the first"});
    }
    const auto index = static_cast<std::int32_t>(elements.size());
    XmlElement element{.name = read.Name(), .line = read.GetLineNum(), .parent = open_};
    for (; attribute != nullptr; attribute = attribute->Next()) {
      if (!add_attribute(element, *attribute)) return false;
    }
    if (open_ >= 0) {
      std::int32_t& last = last_child_[static_cast<std::size_t>(open_)];
      (last < 0 ? at(open_).first_child : at(last).next_sibling) = index;
      last = index;
    }
    elements.push_back(std::move(element));
    last_child_.push_back(-1);
    open_ = index;
    return true;
  }

  // Also where VisitEnter() has said no: then nothing is left to be done.
  bool VisitExit(const tinyxml2::XMLElement& read) override {
    if (fault || &read == end_) return false;
    open_ = at(open_).parent;
    return true;
  }

  bool Visit(const tinyxml2::XMLText& text) override {
    if (open_ < 0) return refuse({text.GetLineNum(), "", "text outside the root element", "Remove it"});
    at(open_).has_text = true;
    return true;
  }

  bool Visit(const tinyxml2::XMLUnknown& unknown) override {
    const std::string_view word = unknown.Value();
    return refuse({unknown.GetLineNum(), fmt::format("<!{}", word.substr(0, word.find_first_of(" \t\r\n"))),
                   "document types are not read, nor entities that they define", "Remove it"});
  }

  bool Visit(const tinyxml2::XMLDeclaration& declaration) override {
    const auto strange = strange_encoding(declaration.Value());
    return !strange ||
           refuse({declaration.GetLineNum(), "encoding",
                   fmt::format("'{}' is not read, only UTF-8", *strange), "Save the file as UTF-8"});
  }

 private:
  XmlElement& at(std::int32_t index) { return elements[static_cast<std::size_t>(index)]; }

  bool refuse(Fault found) {
    fault = std::move(found);
    return false;
  }

  bool add_attribute(XmlElement& element, const tinyxml2::XMLAttribute& read) {
    const std::string field = fmt::format("<{}> {}", element.name, read.Name());
    const std::string_view raw = read.Value();
    if (raw.find('<') != std::string_view::npos)
      return refuse({read.GetLineNum(), field, "a '<' in a value, or a missing quote", "Write &lt;"});
    XmlAttribute attribute{.name = read.Name(), .value = std::string(raw), .line = read.GetLineNum()};
    if (const auto unknown = replace_entities(attribute.value)) {
      return refuse({attribute.line, fmt::format("{} &{}", field, unknown->substr(0, 40)),
                     "is no entity that is known",
                     "Known are &lt; &gt; &amp; &quot; &apos; and characters' numbers; write &amp; for '&'"});
    }
    element.attributes.push_back(std::move(attribute));
    return true;
  }

  const tinyxml2::XMLElement* end_;
  std::int32_t open_ = -1;
  std::vector<std::int32_t> last_child_{};  // of each element
};

// What is told before tinyxml2 sees the text: what it would not see, and what would take it its time. It
// compares each attribute's name with all before it, ends at a zero, and takes </a/> for <a/>.
class FirstLook {
 public:
  explicit FirstLook(std::string_view text) : text_(text) {}

  std::optional<Fault> find() {
    if (const auto bad = first_forbidden(text_)) {
      return Fault{line_of(*bad), "",
                   fmt::format("byte 0x{:02X} is no character of XML in UTF-8",
                               static_cast<unsigned char>(text_[*bad])),
                   "Save the file as UTF-8, without control characters"};
    }
    std::size_t tags = 0;
    for (std::size_t at = text_.find('<'); at < text_.size() && !fault_; at = text_.find('<', at)) {
      if (++tags > kMostTags)
        return Fault{line_of(at), "", fmt::format("more than {} tags", kMostTags), "Use sub-trees"};
      at = behind(at);
    }
    return std::move(fault_);
  }

 private:
  [[nodiscard]] int line_of(std::size_t place) const {
    return 1 + static_cast<int>(std::ranges::count(text_.substr(0, place), '\n'));
  }

  // The place behind what begins there; of what has no end, that of the text.
  std::size_t behind(std::size_t begin) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kPassedOver{
        {{"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<?", "?>"}}};
    for (const auto& [start, end] : kPassedOver) {
      if (text_.substr(begin).starts_with(start)) return text_.find(end, begin + start.size());
    }
    return behind_tag(begin);
  }

  std::size_t behind_tag(std::size_t begin) {
    std::size_t attributes = 0, at = begin;
    while ((at = text_.find_first_of("\"'>", at)) < text_.size() && text_[at] != '>') {
      if (++attributes > kMostAttributes) {
        fault_ = Fault{line_of(at), "", fmt::format("more than {} attributes", kMostAttributes), ""};
        return at;
      }
      const std::size_t end = text_.find(text_[at], at + 1);
      if (end == std::string_view::npos) return end;
      at = end + 1;
    }
    if (at < text_.size() && text_.substr(begin).starts_with("</") &&
        (attributes > 0 || text_[at - 1] == '/')) {
      const std::string tag(text_.substr(begin, std::min<std::size_t>(at + 1 - begin, 40)));
      fault_ = Fault{line_of(begin), tag, "an end tag holds a name alone", "Write </NAME>"};
    }
    return at;
  }

  std::string_view text_;
  std::optional<Fault> fault_{};
};

int last_line(const tinyxml2::XMLNode& node) {
  int line = node.GetLineNum();
  for (const tinyxml2::XMLNode* last = node.LastChild(); last != nullptr; last = last->LastChild())
    line = std::max(line, last->GetLineNum());
  return line;
}

// Where the end's mark was not reached, an end tag at the outside has ended it.
std::optional<Fault> ended_early(const tinyxml2::XMLDocument& document, const tinyxml2::XMLElement* end) {
  if (end != nullptr) return std::nullopt;
  const int line = std::max(1, document.LastChild() != nullptr ? last_line(*document.LastChild()) : 1);
  return Fault{line, "", "an end tag behind this closes what is not open", "Remove it"};
}

}  // namespace

const std::size_t kMostLevels = TINYXML2_MAX_ELEMENT_DEPTH - 2;

const XmlAttribute* XmlElement::find(std::string_view wanted) const noexcept {
  const auto found = std::ranges::find(attributes, wanted, &XmlAttribute::name);
  return found == attributes.end() ? nullptr : &*found;
}

std::vector<XmlElement> parse_xml(std::string_view text, const std::filesystem::path& file) {
  const auto refuse = [&file](const Fault& fault, const std::string& value = "") {
    throw XmlError({file, fault.line, fault.field, value, "malformed XML: " + fault.rule, fault.remedy});
  };
  if (const auto fault = FirstLook(text).find()) refuse(*fault);
  tinyxml2::XMLDocument document(false);  // it would let pass entities that it does not know
  const std::string marked = std::string(text) + std::string(kEnd);
  if (document.Parse(marked.data(), marked.size()) != tinyxml2::XML_SUCCESS) {
    Fault fault = what_failed(document);
    const std::string shown = written_in(text, fault.line);
    if (!fault.field.empty()) refuse(fault, shown);
    fault.field = shown;
    refuse(fault);
  }
  const int end_line = 2 + static_cast<int>(std::ranges::count(text, '\n'));
  const tinyxml2::XMLElement* end = document.LastChildElement("end-of-file");
  if (end != nullptr && end->GetLineNum() != end_line) end = nullptr;
  Elements reader(end);
  document.Accept(&reader);
  if (reader.fault) refuse(*reader.fault);
  if (const auto fault = ended_early(document, end)) refuse(*fault);
  if (reader.elements.empty())
    refuse({1, "", "must have a root element", "Begin with <root BTCPP_format=\"4\">"});
  return std::move(reader.elements);
}

}  // namespace gaitway::behaviour
