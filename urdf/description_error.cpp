// Puts a complaint into words.
#include "description_error.hpp"

#include <fmt/format.h>

#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::urdf {

void refuse(const Complaint& complaint) {
  std::string text = complaint.file.string();
  if (complaint.line > 0) {
    text += fmt::format(":{}", complaint.line);
  }
  text += ": ";
  if (!complaint.field.empty()) {
    text += complaint.field;
    text += complaint.value.empty() ? ": " : fmt::format(" = {}: ", complaint.value);
  }
  text += complaint.rule;
  if (!complaint.remedy.empty()) {
    text += ". " + complaint.remedy;
  }
  const bool ends = text.ends_with('.') || text.ends_with('?');
  throw RobotError(ends ? text : text + ".");
}

}  // namespace gaitway::urdf
