// What is wrong with a YAML file as a whole; its values are tested with the files that hold them.
#include "gaitway/input/yaml_value.hpp"

#include <gmock/gmock.h>

#include <string>

namespace gaitway::input {
namespace {

using testing::HasSubstr;

std::string yaml_refusal(const std::string& text) {
  try {
    (void)YamlValue::parse(text, "file.yaml").at("a").number({0.0, 10.0, "s"});
  } catch (const InputError& error) {
    return error.what();
  }
  return "(accepted)";
}

TEST(YamlValue, OneDocumentIsRead) {
  EXPECT_EQ(yaml_refusal("a: 1"), "(accepted)");
  EXPECT_EQ(yaml_refusal("---\na: 1\n...\n"), "(accepted)");
}

TEST(YamlValue, ASecondDocumentIsRefusedWithItsLine) {
  EXPECT_THAT(yaml_refusal("a: 1\n---\na: 2\n"),
              HasSubstr("file.yaml:2: the file: a second document begins here"));
  EXPECT_THAT(yaml_refusal("a: 1\n---\n"), HasSubstr("a second document begins here"));
}

// There yaml-cpp's parser goes no further and says that it found a document, again and again.
TEST(YamlValue, TextThatBelongsToNoDocumentIsRefusedWithItsLine) {
  for (const std::string stray : {",", "]", "}", ", a: 1", "[1], a: 1",
                                  ",\x9a"
                                  "conds: 20\nconditsecondi"}) {
    EXPECT_THAT(yaml_refusal(stray), HasSubstr("file.yaml:1: ")) << stray;
  }
  EXPECT_THAT(yaml_refusal("# here\n, a: 1"),
              HasSubstr("file.yaml:2: the file: the document is over before this"));
  EXPECT_THAT(yaml_refusal("a: 1\n...\nb: 2\n"),
              HasSubstr("file.yaml:3: the file: the document is over before this"));
}

TEST(YamlValue, AnEmptyFileHasNoKeys) {
  EXPECT_THAT(yaml_refusal(""), HasSubstr("must be a map"));
  EXPECT_THAT(yaml_refusal("# nothing\n"), HasSubstr("must be a map"));
}

TEST(YamlValue, ADecimalCommaIsTold) {
  EXPECT_THAT(yaml_refusal("a: 0,4"),
              HasSubstr("a = '0,4': must be a number with a decimal point, not with a comma. "
                        "Write '0.4'."));
}

TEST(YamlValue, DeepNestingIsRefused) {
  EXPECT_THAT(yaml_refusal("a: " + std::string(100'000, '[')), HasSubstr("file.yaml:1: "));
  EXPECT_THAT(yaml_refusal("a: " + std::string(100'000, '{')), HasSubstr("file.yaml:1: "));
  std::string steps;
  for (int i = 0; i < 1000; ++i) {
    steps += std::string(static_cast<std::size_t>(i), ' ') + "a:\n";
  }
  EXPECT_THAT(yaml_refusal(steps), HasSubstr("file.yaml:"));
}

}  // namespace
}  // namespace gaitway::input
