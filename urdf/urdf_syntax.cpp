// Checks a URDF against the grammar in kGrammar, below.
#include "robot_files.hpp"

#include <fmt/format.h>
#include <tinyxml.h>

#include <algorithm>
#include <sstream>
#include <string_view>
#include <vector>

#include "gaitway/input/complaint.hpp"
#include "gaitway/input/number.hpp"
#include "gaitway/urdf/urdf_xml.hpp"

namespace gaitway::urdf {
namespace {

struct Attribute {
  std::string_view name;
  int numbers;  // how many numbers it holds; 0: text
  bool required = true;
};

struct Element {
  std::string_view name;
  std::vector<Attribute> attributes;
  std::vector<std::string_view> required_children;
  std::vector<std::string_view> optional_children;
};

const std::vector<Element>& grammar() {
  static const std::vector<Element> kGrammar{
      {"robot", {{"name", 0}, {"version", 0, false}}, {"link", "joint"}, {"material"}},
      {"link", {{"name", 0}}, {"inertial"}, {"visual", "collision"}},
      {"inertial", {}, {"mass", "inertia"}, {"origin"}},
      {"mass", {{"value", 1}}, {}, {}},
      {"inertia", {{"ixx", 1}, {"ixy", 1}, {"ixz", 1}, {"iyy", 1}, {"iyz", 1}, {"izz", 1}}, {}, {}},
      {"origin", {{"xyz", 3, false}, {"rpy", 3, false}}, {}, {}},
      {"visual", {{"name", 0, false}}, {"geometry"}, {"origin", "material"}},
      {"collision", {{"name", 0, false}}, {"geometry"}, {"origin"}},
      {"geometry", {}, {}, {"box", "cylinder", "sphere", "mesh"}},
      {"box", {{"size", 3}}, {}, {}},
      {"cylinder", {{"radius", 1}, {"length", 1}}, {}, {}},
      {"sphere", {{"radius", 1}}, {}, {}},
      {"mesh", {{"filename", 0}, {"scale", 3, false}}, {}, {}},
      {"material", {{"name", 0}}, {}, {"color", "texture"}},
      {"color", {{"rgba", 4}}, {}, {}},
      {"texture", {{"filename", 0}}, {}, {}},
      {"joint", {{"name", 0}, {"type", 0}}, {"parent", "child", "axis", "limit"}, {"origin"}},
      {"parent", {{"link", 0}}, {}, {}},
      {"child", {{"link", 0}}, {}, {}},
      {"axis", {{"xyz", 3}}, {}, {}},
      {"limit", {{"lower", 1}, {"upper", 1}, {"effort", 1}, {"velocity", 1}}, {}, {}},
  };
  return kGrammar;
}

// What is wrong with an attribute that shall hold so many numbers; empty: nothing.
std::string numbers_fault(const std::string& text, int wanted) {
  std::istringstream words(text);
  int count = 0;
  try {
    for (std::string word; words >> word; ++count) {
      (void)input::plain_number<double>(word);
    }
  } catch (const input::ValueError& error) {
    if (!error.remedy.empty()) {
      return error.rule;
    }
    count = -1;
  }
  return count == wanted ? "" : wanted == 1 ? "must be a number" : fmt::format("must be {} numbers", wanted);
}

class SyntaxCheck {
 public:
  explicit SyntaxCheck(const std::filesystem::path& file) : file_(file) {}

  void check(const TiXmlElement& element, const std::string& path) {
    const auto rule = std::find_if(grammar().begin(), grammar().end(),
                                   [&element](const Element& e) { return e.name == element.ValueStr(); });
    check_attributes(element, *rule, path);
    check_children(element, *rule, path);
  }

  UrdfLines lines;

 private:
  static std::string describe(const TiXmlElement& element, const std::string& path) {
    const char* name = element.Attribute("name");
    const std::string own = name ? fmt::format("{} '{}'", element.Value(), name) : element.Value();
    return path.empty() ? own : path + " " + own;
  }

  [[noreturn]] void refuse(int line, const std::string& field, const std::string& value,
                           const std::string& what, const std::string& remedy) const {
    input::refuse({file_, line, field, value, what, remedy});
  }

  void check_attributes(const TiXmlElement& element, const Element& rule, const std::string& path) const {
    const std::string where = describe(element, path);
    for (const TiXmlAttribute* a = element.FirstAttribute(); a; a = a->Next()) {
      const auto known = std::find_if(rule.attributes.begin(), rule.attributes.end(),
                                      [a](const Attribute& r) { return r.name == a->Name(); });
      const std::string value = fmt::format("'{}'", a->Value());
      if (known == rule.attributes.end()) {
        std::vector<std::string> names;
        for (const Attribute& attribute : rule.attributes) names.emplace_back(attribute.name);
        refuse(a->Row(), where + " " + a->Name(), value, "there is no such attribute",
               input::suggest(a->Name(), names));
      }
      const std::string fault = known->numbers > 0 ? numbers_fault(a->ValueStr(), known->numbers) : "";
      if (!fault.empty()) {
        refuse(a->Row(), where + " " + a->Name(), value, fault,
               "Write plain numbers in SI units, with blanks between them");
      }
    }
    for (const Attribute& attribute : rule.attributes) {
      if (attribute.required && !element.Attribute(std::string(attribute.name))) {
        refuse(element.Row(), where, "", fmt::format("the attribute '{}' is missing", attribute.name),
               "Add it");
      }
    }
  }

  void check_children(const TiXmlElement& element, const Element& rule, const std::string& path) {
    const std::string where = describe(element, path);
    std::vector<std::string> names(rule.required_children.begin(), rule.required_children.end());
    names.insert(names.end(), rule.optional_children.begin(), rule.optional_children.end());
    for (const TiXmlElement* child = element.FirstChildElement(); child;
         child = child->NextSiblingElement()) {
      if (std::find(names.begin(), names.end(), child->ValueStr()) == names.end()) {
        refuse(child->Row(), where, fmt::format("<{}>", child->Value()), "there is no such element here",
               input::suggest(child->ValueStr(), names));
      }
      check(*child, element.ValueStr() == "robot" ? "" : where);
      if (element.ValueStr() == "robot") {
        note_line(*child);
      }
    }
    for (const std::string_view required : rule.required_children) {
      if (!element.FirstChildElement(std::string(required))) {
        refuse(element.Row(), where, "", fmt::format("the element <{}> is missing", required), "Add it");
      }
    }
  }

  void note_line(const TiXmlElement& element) {
    if (element.ValueStr() == "material") {
      return;
    }
    auto& table = element.ValueStr() == "link" ? lines.link : lines.joint;
    const auto [place, is_new] = table.emplace(element.Attribute("name"), element.Row());
    if (!is_new) {
      refuse(element.Row(), describe(element, ""), "",
             fmt::format("the name is taken already in line {}", place->second),
             "Give each one a name of its own");
    }
    note_shapes(element, "collision", lines.collision);
    note_shapes(element, "visual", lines.visual);
  }

  static void note_shapes(const TiXmlElement& link, const char* use,
                          std::map<std::string, std::vector<int>>& table) {
    for (const TiXmlElement* shape = link.FirstChildElement(use); shape;
         shape = shape->NextSiblingElement(use)) {
      const TiXmlElement* const geometry = shape->FirstChildElement("geometry");
      const TiXmlElement* const kind = geometry->FirstChildElement();
      table[link.Attribute("name")].push_back((kind ? kind : geometry)->Row());
    }
  }

  const std::filesystem::path& file_;
};

}  // namespace

UrdfLines check_urdf_syntax(const std::filesystem::path& file, const std::string& text) {
  TiXmlDocument document;
  const TiXmlElement& robot = parse_urdf_xml(file, text, document);
  SyntaxCheck syntax(file);
  syntax.check(robot, "");
  return std::move(syntax.lines);
}

}  // namespace gaitway::urdf
