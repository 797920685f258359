// From a file to a checked description, step by step; each step tells all that it finds wrong.
#include "gaitway/behaviour/read.hpp"

#include <utility>

#include "complaints.hpp"
#include "definitions.hpp"
#include "expansion.hpp"
#include "gaitway/behaviour/outcomes.hpp"
#include "gaitway/input/text.hpp"
#include "xml_document.hpp"

namespace gaitway::behaviour {
namespace {

Definitions definitions_of(std::string_view text, const std::filesystem::path& file, const Registry& registry,
                           Complaints& complaints) {
  std::vector<XmlElement> document;
  try {
    document = parse_xml(text, file);
  } catch (const XmlError& error) {
    const input::Complaint& wrong = error.what_is_wrong;
    complaints.add({wrong.line}, wrong.field, wrong.value, wrong.rule, wrong.remedy);
  }
  complaints.throw_if_any();
  Definitions definitions = define_trees(document, registry, complaints);
  complaints.throw_if_any();
  return definitions;
}

Description expanded(const Definitions& definitions, Complaints& complaints) {
  Description description = expand(definitions, complaints);
  complaints.throw_if_any();
  description.may_succeed = may_succeed(description);
  return description;
}

}  // namespace

Description parse_tree(std::string_view text, const std::filesystem::path& file, const Registry& registry) {
  Complaints complaints(file);
  return expanded(definitions_of(text, file, registry, complaints), complaints);
}

std::optional<Description> parse_tree_of_id(std::string_view text, const std::filesystem::path& file,
                                            const Registry& registry, std::string_view id) {
  Complaints complaints(file);
  Definitions definitions = definitions_of(text, file, registry, complaints);
  const auto found = definitions.by_id.find(id);
  if (found == definitions.by_id.end()) return std::nullopt;
  definitions.main = found->second;
  return expanded(definitions, complaints);
}

Description read_tree(const std::filesystem::path& file, const Registry& registry) {
  return parse_tree(input::read_text_file(file, "Give the file of a behaviour tree"), file, registry);
}

}  // namespace gaitway::behaviour
