// Checked access to YAML.
#include "gaitway/input/yaml_value.hpp"

#include <fmt/format.h>
#include <yaml-cpp/anchor.h>
#include <yaml-cpp/eventhandler.h>

#include <algorithm>
#include <sstream>

#include "gaitway/input/text.hpp"

namespace gaitway::input {
namespace {

std::string kind_of(const YAML::Node& node) {
  switch (node.Type()) {
    case YAML::NodeType::Scalar:
      return "'" + node.Scalar() + "'";
    case YAML::NodeType::Sequence:
      return fmt::format("a list of {}", node.size());
    case YAML::NodeType::Map:
      return "";  // says nothing of use
    default:
      return "nothing";
  }
}

// Where documents begin; nothing else of them.
class DocumentStarts final : public YAML::EventHandler {
 public:
  [[nodiscard]] const std::vector<YAML::Mark>& marks() const noexcept { return marks_; }
  void OnDocumentStart(const YAML::Mark& mark) override { marks_.push_back(mark); }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& /*mark*/, YAML::anchor_t /*anchor*/) override {}
  void OnAlias(const YAML::Mark& /*mark*/, YAML::anchor_t /*anchor*/) override {}
  void OnScalar(const YAML::Mark& /*mark*/, const std::string& /*tag*/, YAML::anchor_t /*anchor*/,
                const std::string& /*value*/) override {}
  void OnSequenceStart(const YAML::Mark& /*mark*/, const std::string& /*tag*/, YAML::anchor_t /*anchor*/,
                       YAML::EmitterStyle::value /*style*/) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark& /*mark*/, const std::string& /*tag*/, YAML::anchor_t /*anchor*/,
                  YAML::EmitterStyle::value /*style*/) override {}
  void OnMapEnd() override {}

 private:
  std::vector<YAML::Mark> marks_;
};

// The beginning of a second document, if there is one. YAML::LoadAll() never ends where text stands that no
// document can begin with, such as ",": there its parser goes no further and still says that it found a
// document.
std::optional<YAML::Mark> second_document(const std::string& text) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  DocumentStarts starts;
  constexpr std::size_t kLooked = 2;
  while (starts.marks().size() < kLooked && parser.HandleNextDocument(starts)) {
  }
  return starts.marks().size() < kLooked ? std::nullopt : std::optional(starts.marks()[1]);
}

}  // namespace

YamlValue YamlValue::read(const std::filesystem::path& file) {
  return parse(read_text_file(file, "Check the path and the file's permissions"), file);
}

YamlValue YamlValue::parse(const std::string& text, const std::filesystem::path& file) {
  std::optional<YAML::Mark> second;
  YAML::Node document;
  try {
    second = second_document(text);
    document = YAML::Load(text);
  } catch (const YAML::Exception& error) {
    input::refuse({file, error.mark.line + 1, fmt::format("column {}", error.mark.column + 1), "",
                   "malformed YAML: " + error.msg, "Check indentation, brackets and quotes there and above"});
  }
  if (second) {
    const bool is_marked =
        text.compare(std::min(text.size(), static_cast<std::size_t>(second->pos)), 3, "---") == 0;
    input::refuse({file, second->line + 1, "the file", "",
                   is_marked ? "a second document begins here, which nobody would read"
                             : "the document is over before this, which nobody would read",
                   is_marked ? "Write one document a file: remove the '---'"
                             : "Remove it, or check commas, brackets and indentation there and above"});
  }
  return YamlValue(document, file, "");
}

std::vector<std::pair<std::string, YamlValue>> YamlValue::entries() const {
  if (!node_.IsMap()) {
    refuse("must be a map of keys and values", "Write 'key: value', one a line");
  }
  std::vector<std::pair<std::string, YamlValue>> result;
  for (const auto& entry : node_) {
    const YamlValue key = key_of(entry.first);
    const std::string name = key.text();
    const auto same = [&name](const auto& other) { return other.first == name; };
    if (std::ranges::any_of(result, same)) {
      key.refuse("the key stands here twice", "Remove one of the two");
    }
    result.emplace_back(name, YamlValue(entry.second, file_, child_path(name)));
  }
  return result;
}

void YamlValue::require_map(std::span<const std::string_view> keys) const {
  if (!node_.IsMap()) {
    refuse("must be a map of keys and values", fmt::format("Give it the keys {}", fmt::join(keys, ", ")));
  }
  for (const auto& entry : node_) {
    const YamlValue key = key_of(entry.first);
    if (std::ranges::find(keys, key.text()) == keys.end()) {
      const std::vector<std::string> known(keys.begin(), keys.end());
      key.refuse("there is no such key", suggest(key.text(), known));
    }
  }
  (void)entries();  // each once
}

YamlValue YamlValue::key_of(const YAML::Node& key) const {
  return {key, file_, path_.empty() ? "key" : path_ + " key"};
}

std::string YamlValue::child_path(std::string_view key) const {
  return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
}

YamlValue YamlValue::at(std::string_view key) const {
  if (auto value = find(key)) {
    return *std::move(value);
  }
  refuse(fmt::format("the key '{}' is missing", key), fmt::format("Add '{}: ...'", key));
}

std::optional<YamlValue> YamlValue::find(std::string_view key) const {
  if (!node_.IsMap()) {
    refuse("must be a map of keys and values", fmt::format("Give it the key '{}'", key));
  }
  const YAML::Node child = node_[std::string(key)];
  if (!child.IsDefined()) {
    return std::nullopt;
  }
  return YamlValue(child, file_, child_path(key));
}

std::vector<YamlValue> YamlValue::items() const {
  if (!node_.IsSequence()) {
    refuse("must be a list", "Write [a, b, ...] or one '- ...' a line");
  }
  std::vector<YamlValue> result;
  for (std::size_t i = 0; i < node_.size(); ++i) {
    result.push_back(YamlValue(node_[i], file_, fmt::format("{}[{}]", path_, i)));
  }
  return result;
}

std::vector<YamlValue> YamlValue::items(std::size_t count) const {
  std::vector<YamlValue> result = items();
  if (result.size() != count) {
    refuse(fmt::format("must be a list of {}", count), "Add or remove entries");
  }
  return result;
}

template <class Number>
Number YamlValue::read_number(const char* remedy) const {
  try {
    return plain_number<Number>(node_.IsScalar() ? node_.Scalar() : "");
  } catch (const ValueError& error) {
    refuse(error.rule, error.remedy.empty() ? remedy : error.remedy);
  }
}

double YamlValue::number(const Range& range) const {
  const auto value = read_number<double>("Write a plain number; its unit is part of the key");
  if (value < range.lowest || value > range.highest) {
    refuse(fmt::format("must be {:g}..{:g}{}{}", range.lowest, range.highest, range.unit.empty() ? "" : " ",
                       range.unit),
           "Check the unit: it is part of the key");
  }
  return value;
}

int YamlValue::integer(int lowest, int highest) const {
  const auto value = read_number<std::int64_t>("Write a plain whole number");
  if (value < lowest || value > highest) {
    refuse(fmt::format("must be {}..{}", lowest, highest), "Choose a number in this range");
  }
  return static_cast<int>(value);
}

std::int64_t YamlValue::number_with_unit(std::span<const Unit> units, std::int64_t lowest,
                                         std::int64_t highest) const {
  try {
    return input::number_with_unit(text(), units, lowest, highest);
  } catch (const ValueError& error) {
    refuse(error.rule, error.remedy);
  }
}

std::string YamlValue::text() const {
  if (!node_.IsScalar()) {
    refuse("must be a plain text", "Write a word or a number, no list and no map");
  }
  return node_.Scalar();
}

void YamlValue::refuse(const std::string& rule, const std::string& remedy) const {
  input::refuse({file_, line(), path_.empty() ? "the file" : path_, kind_of(node_), rule, remedy});
}

int YamlValue::line() const {
  const YAML::Mark mark = node_.Mark();
  return mark.is_null() ? 0 : mark.line + 1;
}

}  // namespace gaitway::input
