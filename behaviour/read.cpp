// From a file to a checked description, step by step; each step tells all that it finds wrong.
#include "gaitway/behaviour/read.hpp"

#include <utility>

#include "complaints.hpp"
#include "definitions.hpp"
#include "expansion.hpp"
#include "gaitway/input/text.hpp"
#include "xml_document.hpp"

namespace gaitway::behaviour {

Description parse_tree(std::string_view text, const std::filesystem::path& file, const Registry& registry) {
  Complaints complaints(file);
  std::vector<XmlElement> document;
  try {
    document = parse_xml(text, file);
  } catch (const XmlError& error) {
    const input::Complaint& wrong = error.what_is_wrong;
    complaints.add({wrong.line}, wrong.field, wrong.value, wrong.rule, wrong.remedy);
  }
  complaints.throw_if_any();
  const Definitions definitions = define_trees(document, registry, complaints);
  complaints.throw_if_any();
  Description description = expand(definitions, complaints);
  complaints.throw_if_any();
  return description;
}

Description read_tree(const std::filesystem::path& file, const Registry& registry) {
  return parse_tree(input::read_text_file(file, "Give the file of a behaviour tree"), file, registry);
}

}  // namespace gaitway::behaviour
