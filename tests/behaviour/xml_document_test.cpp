// The XML that trees are written in: what is read, and what is refused by name.
#include "xml_document.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "xml_characters.hpp"

namespace gaitway::behaviour::test {
namespace {

std::string fault_of(const std::string& text) {
  try {
    (void)parse_xml(text, "t.xml");
  } catch (const XmlError& error) {
    return fmt::format("{}: {}{}{}", error.what_is_wrong.line, error.what_is_wrong.field,
                       error.what_is_wrong.field.empty() ? "" : ": ", error.what_is_wrong.rule);
  }
  return "";
}

TEST(XmlDocument, ElementsKnowTheirLinesAndNeighbours) {
  const auto elements = parse_xml(
      "<?xml version=\"1.0\" encoding='UTF-8'?>\n<!-- <x> -->\n<a one='1'\n   two=\"2\">\n "
      "<b/><c>text</c>\n</a>\n<!-- end -->",
      "t.xml");
  ASSERT_EQ(elements.size(), 3U);
  EXPECT_EQ(elements[0].line, 3);
  ASSERT_EQ(elements[0].attributes.size(), 2U);
  EXPECT_EQ(elements[0].attributes[1].line, 4);
  EXPECT_EQ(elements[0].find("two")->value, "2");
  EXPECT_EQ(elements[0].first_child, 1);
  EXPECT_EQ(elements[1].next_sibling, 2);
  EXPECT_EQ(elements[1].line, 5);
  EXPECT_EQ(elements[2].next_sibling, -1);
  EXPECT_EQ(elements[2].parent, 0);
  EXPECT_TRUE(elements[2].has_text);
  EXPECT_FALSE(elements[0].has_text);
}

TEST(XmlDocument, EntitiesAndWhiteSpaceAreReplaced) {
  const auto elements = parse_xml("<a v=\"&lt;&gt;&amp;&quot;&apos;&#65;&#x20AC;\ty\nz\"/>", "t.xml");
  EXPECT_EQ(elements[0].find("v")->value, "<>&\"'A\u20AC y z");
}

struct Fault {
  const char* name;
  std::string text;
  const char* fault;
};
std::ostream& operator<<(std::ostream& stream, const Fault& fault) {
  return stream << fault.name;
}
class XmlFaults : public testing::TestWithParam<Fault> {};

TEST_P(XmlFaults, AreTold) {
  EXPECT_EQ(fault_of(GetParam().text), std::string(GetParam().fault));
}

std::string attributes(std::size_t count) {
  std::string text = "<a";
  for (std::size_t i = 0; i < count; ++i) text += fmt::format(" a{}=\"\"", i);
  return text + "/>";
}

INSTANTIATE_TEST_SUITE_P(
    All, XmlFaults,
    testing::Values(
        Fault{"Nothing", "", "1: malformed XML: must have a root element"},
        Fault{"TextAlone", "hello", "1: malformed XML: text outside the root element"},
        Fault{"NotClosed", "<a>\n<b>\n</b>", "1: <a>: malformed XML: is not closed"},
        Fault{"ClosedWrongly", "<a>\n<b></a></b>", "2: </a>: malformed XML: closes <b> of line 2"},
        Fault{"ClosedTwice", "<a/></a>", "1: </a>: malformed XML: closes what is not open"},
        Fault{"TwoRoots", "<a/>\n<b/>", "2: <b>: malformed XML: a second root element"},
        Fault{"TagWithoutEnd", "<a>\n<b x=\"1\"", "2: <b: malformed XML: the tag does not end"},
        Fault{"EndTagWithoutEnd", "<a></a", "1: </a: malformed XML: the tag does not end"},
        Fault{"LooseLess", "<a>1 < 2</a>", "1: malformed XML: the name of an element is expected"},
        Fault{"AttributeWithoutValue", "<a b/>", "1: <a> b: malformed XML: an attribute needs a value"},
        Fault{"AttributeWithoutQuotes", "<a b=1/>", "1: <a> b: malformed XML: a value stands between quotes"},
        Fault{"MissingQuote", "<a b=\"1/>", "1: <a> b: malformed XML: the value's second quote is missing"},
        Fault{"LessInValue", "<a b=\"1/><c d=\"2\"/>",
              "1: <a> b: malformed XML: a '<' in a value, or a missing quote"},
        Fault{"AttributeTwice", "<a b=\"1\"\n b=\"2\"/>",
              "2: <a> b: malformed XML: the attribute is there twice"},
        Fault{"AttributesTogether", "<a b=\"1\"c=\"2\"/>",
              "1: <a: malformed XML: a blank is missing before an attribute"},
        Fault{"TooManyAttributes", attributes(kMostAttributes + 1),
              "1: <a> a64: malformed XML: more than 64 attributes"},
        Fault{"CommentWithoutEnd", "<a><!-- </a>", "1: malformed XML: a comment does not end"},
        Fault{"Doctype", "<!DOCTYPE a [<!ENTITY x \"y\">]>\n<a b=\"&x;\"/>",
              "1: <!DOCTYPE: malformed XML: document types are not read, nor entities that they define"},
        Fault{"UnknownEntity", "<a b=\"&x;\"/>", "1: &x: malformed XML: is no entity that is known"},
        Fault{"EntityWithoutEnd", "<a b=\"a & b\"/>", "1: &: malformed XML: is no entity that is known"},
        Fault{"NullCharacter", "<a b=\"&#0;\"/>", "1: &#0: malformed XML: is no entity that is known"},
        Fault{"CharacterBeyondAll", "<a b=\"&#x110000;\"/>",
              "1: &#x110000: malformed XML: is no entity that is known"},
        Fault{"ControlCharacter", "<a\n b=\"\x01\"/>",
              "2: malformed XML: byte 0x01 is no character of XML in UTF-8"},
        Fault{"Latin1", "<a b=\"\xE4\"/>", "1: malformed XML: byte 0xE4 is no character of XML in UTF-8"},
        Fault{"OverlongUtf8", "<a b=\"\xC0\x80\"/>",
              "1: malformed XML: byte 0xC0 is no character of XML in UTF-8"},
        Fault{"Surrogate", "<a b=\"\xED\xA0\x80\"/>",
              "1: malformed XML: byte 0xED is no character of XML in UTF-8"},
        Fault{"Utf16", "<?xml version=\"1.0\" encoding=\"UTF-16\"?><a/>",
              "1: encoding: malformed XML: 'UTF-16' is not read, only UTF-8"}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(XmlDocument, DepthCostsNoStack) {
  std::string deep;
  for (std::size_t i = 0; i < kMostLevels; ++i) deep += "<a>";
  for (std::size_t i = 0; i < kMostLevels; ++i) deep += "</a>";
  EXPECT_EQ(parse_xml(deep, "t.xml").size(), kMostLevels);
  EXPECT_EQ(fault_of("<a>" + deep + "</a>"), "1: malformed XML: more than 2000 levels of elements");
}

TEST(XmlDocument, ElementsAreBounded) {
  std::string many = "<a>";
  for (std::size_t i = 0; i < kMostElements; ++i) many += "<b/>";
  EXPECT_EQ(fault_of(many + "</a>"), "1: malformed XML: more than 100000 elements");
}

TEST(XmlText, IsReadAsItWas) {
  const std::string text = "a < b & \"c\" > '\u00E4\u20AC\U0001F600'";
  EXPECT_EQ(parse_xml("<a b=\"" + xml_text(text) + "\"/>", "t.xml")[0].find("b")->value, text);
  EXPECT_EQ(xml_text("a\x01\xFF"), "a\uFFFD\uFFFD");
}

}  // namespace
}  // namespace gaitway::behaviour::test
