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

TEST(XmlDocument, TheMarkOfAnEncodingIsPassedOver) {
  const auto elements = parse_xml("\xEF\xBB\xBF<?xml version=\"1.0\"?>\r\n<a\r\nb='1\r\n2'/>\r\n", "t.xml");
  ASSERT_EQ(elements.size(), 1U);
  EXPECT_EQ(elements[0].line, 2);
  EXPECT_EQ(elements[0].attributes.at(0).line, 3);
  EXPECT_EQ(elements[0].attributes[0].value, "1 2");
}

TEST(XmlDocument, TheLineIsShownWhereTheReaderFailed) {
  try {
    (void)parse_xml("<a>\n  <b c=1/>\n</a>", "t.xml");
    FAIL() << "accepted";
  } catch (const XmlError& error) {
    EXPECT_EQ(error.what_is_wrong.line, 2);
    EXPECT_EQ(error.what_is_wrong.value, "<b c=1/>");
  }
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
        Fault{"NotClosed", "<a>\n<b>\n</b>",
              "1: <a>: malformed XML: what begins here is not closed, or is no element"},
        Fault{"ClosedWrongly", "<a>\n<b></a></b>", "2: <b>: malformed XML: is not closed by </b>"},
        Fault{"ClosedTwice", "<a/></a>", "1: malformed XML: an end tag behind this closes what is not open"},
        Fault{"EndTagThatIsAnElement", "<a><b></b/></b></a>",
              "1: </b/>: malformed XML: an end tag holds a name alone"},
        Fault{"EndTagWithAttributes", "<a>\n</a b='1'>",
              "2: </a b='1'>: malformed XML: an end tag holds a name alone"},
        Fault{"TooManyClosedBehindAll", "<a>\n<b/></a>\n</a><a/>",
              "2: malformed XML: an end tag behind this closes what is not open"},
        Fault{"TheEndsOwnMark", "<a/>\n<end-of-file/></a>",
              "2: <end-of-file>: malformed XML: a second root element"},
        Fault{"TextBehindAll", "<a/>\nhello", "2: malformed XML: text outside the root element"},
        Fault{"ZeroByte", std::string("<a/>\n\0<b/>", 10),
              "2: malformed XML: byte 0x00 is no character of XML in UTF-8"},
        Fault{"ElementWithinTag", "<a <b/>",
              "1: <a <b/>: malformed XML: the tag has no end, or something in it is no attribute"},
        Fault{"DoctypeBehind", "<a><!ELEMENT x></a>",
              "1: <!ELEMENT: malformed XML: document types are not read, nor entities that they define"},
        Fault{"InstructionBehind", "<a><?x y?></a>",
              "1: <?: malformed XML: stands only at the file's beginning, and ends with ?>"},
        Fault{"EntityOfTwoNumbers", "<a b=\"&#x12x41;\"/>",
              "1: <a> b &#x12x41: malformed XML: is no entity that is known"},
        Fault{"TwoRoots", "<a/>\n<b/>", "2: <b>: malformed XML: a second root element"},
        Fault{"TagWithoutEnd", "<a>\n<b x=\"1\"",
              "2: <b x=\"1\": malformed XML: the tag has no end, or something in it is no attribute"},
        Fault{"EndTagWithoutEnd", "<a></a",
              "1: <a></a: malformed XML: the tag has no end, or something in it is no attribute"},
        Fault{"LooseLess", "<a>1 < 2</a>",
              "1: <a>1 < 2</a>: malformed XML: what begins here is not closed, or is no element"},
        Fault{"AttributeWithoutValue", "<a b/>",
              "1: <a>: malformed XML: an attribute has no value, no quotes around it, or is there twice"},
        Fault{"AttributeWithoutQuotes", "<a b=1/>",
              "1: <a>: malformed XML: an attribute has no value, no quotes around it, or is there twice"},
        Fault{"MissingQuote", "<a b=\"1/>",
              "1: <a>: malformed XML: an attribute has no value, no quotes around it, or is there twice"},
        Fault{"LessInValue", "<a b=\"1/><c d=\"2\"/>",
              "1: <a b=\"1/><c d=\"2\"/>: malformed XML: the tag has no end, or something in it is no "
              "attribute"},
        Fault{"LessInValueOfAWholeTag", "<a b=\"1 < 2\"/>",
              "1: <a> b: malformed XML: a '<' in a value, or a missing quote"},
        Fault{"AttributeTwice", "<a b=\"1\"\n b=\"2\"/>",
              "2: <a>: malformed XML: an attribute has no value, no quotes around it, or is there twice"},
        Fault{"TooManyAttributes", attributes(kMostAttributes + 1),
              "1: malformed XML: more than 64 attributes"},
        Fault{"CommentWithoutEnd", "<a><!-- </a>", "1: <a><!-- </a>: malformed XML: a comment does not end"},
        Fault{"Doctype", "<!DOCTYPE a [<!ENTITY x \"y\">]>\n<a b=\"&x;\"/>",
              "1: <!DOCTYPE: malformed XML: document types are not read, nor entities that they define"},
        Fault{"UnknownEntity", "<a b=\"&x;\"/>", "1: <a> b &x: malformed XML: is no entity that is known"},
        Fault{"EntityWithoutEnd", "<a b=\"a & b\"/>",
              "1: <a> b &: malformed XML: is no entity that is known"},
        Fault{"NullCharacter", "<a b=\"&#0;\"/>", "1: <a> b &#0: malformed XML: is no entity that is known"},
        Fault{"CharacterBeyondAll", "<a b=\"&#x110000;\"/>",
              "1: <a> b &#x110000: malformed XML: is no entity that is known"},
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

std::string levels(std::size_t count) {
  std::string deep;
  for (std::size_t i = 0; i < count; ++i) deep += "<a>";
  for (std::size_t i = 0; i < count; ++i) deep += "</a>";
  return deep;
}

TEST(XmlDocument, LevelsAreBounded) {
  EXPECT_EQ(parse_xml(levels(kMostLevels), "t.xml").size(), kMostLevels);
  const std::string fault = fmt::format("1: {}...: malformed XML: more than {} levels of elements",
                                        levels(20).substr(0, 60), kMostLevels);
  EXPECT_EQ(fault_of(levels(kMostLevels + 1)), fault);
  EXPECT_EQ(fault_of(levels(90'000)), fault);
}

TEST(XmlDocument, TagsAreBounded) {
  std::string many = "<a>";
  for (std::size_t i = 0; i + 2 < kMostTags; ++i) many += "<b/>";
  EXPECT_EQ(fault_of(many + "</a>"), "");
  EXPECT_EQ(fault_of(many + "<b/></a>"), "1: malformed XML: more than 200000 tags");
}

TEST(XmlText, IsReadAsItWas) {
  const std::string text = "a < b & \"c\" > '\u00E4\u20AC\U0001F600'";
  EXPECT_EQ(parse_xml("<a b=\"" + xml_text(text) + "\"/>", "t.xml")[0].find("b")->value, text);
  EXPECT_EQ(xml_text("a\x01\xFF"), "a\uFFFD\uFFFD");
}

}  // namespace
}  // namespace gaitway::behaviour::test
