// Reads XML in one pass, with a list of the elements that are open in place of a stack of calls.
#include "xml_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "xml_characters.hpp"

namespace gaitway::behaviour {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";

class XmlReader {
 public:
  XmlReader(std::string_view text, const std::filesystem::path& file) : text_(text), file_(file) {}

  std::vector<XmlElement> read() {
    check_characters();
    if (text_.starts_with("\xEF\xBB\xBF")) place_ = 3;
    check_encoding();
    while (place_ < text_.size()) read_piece();
    if (!open_.empty()) {
      const XmlElement& left = elements_[open_.back()];
      refuse_at(left.line, "<" + left.name + ">", "is not closed", fmt::format("Add </{}>", left.name));
    }
    if (elements_.empty()) refuse("", "must have a root element", "Begin with <root BTCPP_format=\"4\">");
    return std::move(elements_);
  }

 private:
  [[noreturn]] void refuse_at(int line, std::string field, std::string rule, std::string remedy) const {
    throw XmlError(
        {file_, line, std::move(field), "", "malformed XML: " + std::move(rule), std::move(remedy)});
  }
  [[noreturn]] void refuse(std::string field, std::string rule, std::string remedy) {
    refuse_at(line(), std::move(field), std::move(rule), std::move(remedy));
  }

  // Of place_. Counts on from where it was asked the last time.
  int line() {
    line_ += static_cast<int>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(counted_),
                                         text_.begin() + static_cast<std::ptrdiff_t>(place_), '\n'));
    counted_ = place_;
    return line_;
  }

  void check_characters() {
    if (const auto bad = first_forbidden(text_)) {
      place_ = *bad;
      refuse("",
             fmt::format("byte 0x{:02X} is no character of XML in UTF-8",
                         static_cast<unsigned char>(text_[*bad])),
             "Save the file as UTF-8, without control characters");
    }
  }

  // What the XML declaration says.
  void check_encoding() {
    if (!text_.substr(place_).starts_with("<?xml")) return;
    const std::string_view declaration = text_.substr(place_, text_.find("?>", place_) - place_);
    const std::size_t at = declaration.find("encoding");
    if (at == std::string_view::npos) return;
    const std::size_t quote = declaration.find_first_of("\"'", at);
    if (quote == std::string_view::npos) return;
    const std::string_view name =
        declaration.substr(quote + 1, declaration.find(declaration[quote], quote + 1) - quote - 1);
    for (const std::string_view known : {"UTF-8", "utf-8", "US-ASCII", "us-ascii", "ASCII"}) {
      if (name == known) return;
    }
    refuse("encoding", fmt::format("'{}' is not read, only UTF-8", name), "Save the file as UTF-8");
  }

  void read_piece() {
    if (text_[place_] != '<') return read_text();
    const std::string_view rest = text_.substr(place_);
    if (rest.starts_with("<!--")) return skip_to("-->", 4, "a comment");
    if (rest.starts_with("<![CDATA[")) {
      require_open("text");
      elements_[open_.back()].has_text = true;
      return skip_to("]]>", 9, "a CDATA section");
    }
    if (rest.starts_with("<!")) {
      refuse("<!DOCTYPE", "document types are not read, nor entities that they define", "Remove it");
    }
    if (rest.starts_with("<?")) return skip_to("?>", 2, "a processing instruction");
    if (rest.starts_with("</")) return close_element();
    open_element();
  }

  void skip_to(std::string_view end, std::size_t from, const char* what) {
    const std::size_t found = text_.find(end, place_ + from);
    if (found == std::string_view::npos)
      refuse("", fmt::format("{} does not end", what), fmt::format("Add {}", end));
    place_ = found + end.size();
  }

  void require_open(const char* what) {
    if (open_.empty()) refuse("", fmt::format("{} outside the root element", what), "Remove it");
  }

  void read_text() {
    const std::size_t end = std::min(text_.find('<', place_), text_.size());
    const std::string_view text = text_.substr(place_, end - place_);
    if (text.find_first_not_of(kBlanks) != std::string_view::npos) {
      require_open("text");
      (void)decoded(text);
      elements_[open_.back()].has_text = true;
    }
    place_ = end;
  }

  std::string_view read_name(const char* what) {
    const std::size_t length = name_length(text_.substr(place_));
    if (length == 0)
      refuse("", fmt::format("{} is expected", what), "Write &lt; for a '<' that begins no element");
    place_ += length;
    return text_.substr(place_ - length, length);
  }

  bool skip_blanks() {
    const std::size_t before = place_;
    place_ = std::min(text_.find_first_not_of(kBlanks, place_), text_.size());
    return place_ > before;
  }

  bool take(std::string_view token) {
    if (!text_.substr(place_).starts_with(token)) return false;
    place_ += token.size();
    return true;
  }

  void open_element() {
    XmlElement element;
    element.line = line();
    ++place_;
    element.name = read_name("the name of an element");
    if (open_.empty() && !elements_.empty()) {
      refuse("<" + element.name + ">", "a second root element", "Put it into the first one");
    }
    if (elements_.size() >= kMostElements) {
      refuse("", fmt::format("more than {} elements", kMostElements), "Use sub-trees");
    }
    if (open_.size() >= kMostLevels) {
      refuse("", fmt::format("more than {} levels of elements", kMostLevels), "Use sub-trees");
    }
    bool closed = false;
    for (;;) {
      const bool apart = skip_blanks();
      if (take("/>")) {
        closed = true;
        break;
      }
      if (take(">")) break;
      if (place_ >= text_.size()) {
        refuse_at(element.line, "<" + element.name, "the tag does not end", "Add > or />");
      }
      if (!apart) refuse("<" + element.name, "a blank is missing before an attribute", "");
      read_attribute(element);
    }
    append(std::move(element), closed);
  }

  void read_attribute(XmlElement& element) {
    XmlAttribute attribute;
    attribute.line = line();
    attribute.name = read_name("the name of an attribute");
    const std::string field = fmt::format("<{}> {}", element.name, attribute.name);
    skip_blanks();
    if (!take("="))
      refuse(field, "an attribute needs a value", fmt::format("Write {}=\"...\"", attribute.name));
    skip_blanks();
    const char quote = place_ < text_.size() ? text_[place_] : '\0';
    if (quote != '"' && quote != '\'') refuse(field, "a value stands between quotes", "");
    const std::size_t end = text_.find(quote, place_ + 1);
    if (end == std::string_view::npos) refuse(field, "the value's second quote is missing", "");
    const std::string_view raw = text_.substr(place_ + 1, end - place_ - 1);
    if (raw.find('<') != std::string_view::npos)
      refuse(field, "a '<' in a value, or a missing quote", "Write &lt;");
    attribute.value = decoded(raw);
    if (element.find(attribute.name) != nullptr) refuse(field, "the attribute is there twice", "Remove one");
    if (element.attributes.size() >= kMostAttributes) {
      refuse(field, fmt::format("more than {} attributes", kMostAttributes), "");
    }
    place_ = end + 1;
    element.attributes.push_back(std::move(attribute));
  }

  void append(XmlElement element, bool closed) {
    const auto index = static_cast<std::int32_t>(elements_.size());
    if (!open_.empty()) {
      element.parent = static_cast<std::int32_t>(open_.back());
      std::int32_t& last = last_child_[open_.back()];
      (last < 0 ? elements_[open_.back()].first_child
                : elements_[static_cast<std::size_t>(last)].next_sibling) = index;
      last = index;
    }
    elements_.push_back(std::move(element));
    last_child_.push_back(-1);
    if (!closed) open_.push_back(static_cast<std::size_t>(index));
  }

  void close_element() {
    place_ += 2;
    const std::string_view name = read_name("the name of an element");
    if (open_.empty()) refuse(fmt::format("</{}>", name), "closes what is not open", "Remove it");
    const XmlElement& open = elements_[open_.back()];
    if (open.name != name) {
      refuse(fmt::format("</{}>", name), fmt::format("closes <{}> of line {}", open.name, open.line),
             fmt::format("Write </{}>", open.name));
    }
    skip_blanks();
    if (!take(">")) refuse(fmt::format("</{}", name), "the tag does not end", "Add >");
    open_.pop_back();
  }

  // With entities replaced and, as XML has it, white space as blanks.
  std::string decoded(std::string_view raw) {
    std::string text;
    text.reserve(raw.size());
    for (std::size_t i = 0; i < raw.size();) {
      if (raw[i] != '&') {
        text += raw[i] == '\n' || raw[i] == '\t' || raw[i] == '\r' ? ' ' : raw[i];
        ++i;
        continue;
      }
      const std::size_t end = raw.find(';', i);
      const std::string_view entity = raw.substr(i + 1, end == std::string_view::npos ? 0 : end - i - 1);
      const std::optional<std::string> meant = entity_text(entity);
      if (!meant) {
        refuse(fmt::format("&{}", entity.substr(0, 40)), "is no entity that is known",
               "Known are &lt; &gt; &amp; &quot; &apos; and characters' numbers; write &amp; for '&'");
      }
      text += *meant;
      i = end + 1;
    }
    return text;
  }

  std::string_view text_;
  const std::filesystem::path& file_;
  std::size_t place_ = 0;
  std::size_t counted_ = 0;
  int line_ = 1;
  std::vector<XmlElement> elements_;
  std::vector<std::int32_t> last_child_;  // of each element
  std::vector<std::size_t> open_;
};

}  // namespace

const XmlAttribute* XmlElement::find(std::string_view wanted) const noexcept {
  const auto found = std::ranges::find(attributes, wanted, &XmlAttribute::name);
  return found == attributes.end() ? nullptr : &*found;
}

std::vector<XmlElement> parse_xml(std::string_view text, const std::filesystem::path& file) {
  return XmlReader(text, file).read();
}

}  // namespace gaitway::behaviour
