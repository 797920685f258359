// Puts a complaint into words.
#include "gaitway/input/complaint.hpp"

#include <fmt/format.h>

namespace gaitway::input {
namespace {

std::string as_sentence(const std::string& text) {
  return text.ends_with('.') || text.ends_with('?') ? text : text + ".";
}

}  // namespace

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
  text += as_sentence(complaint.rule);
  if (!complaint.remedy.empty()) {
    text += ' ';
    text += as_sentence(complaint.remedy);
  }
  throw InputError(text);
}

}  // namespace gaitway::input
