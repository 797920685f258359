// Puts a complaint into words that a terminal may show.
#include "gaitway/input/complaint.hpp"

#include <fmt/format.h>

#include "gaitway/input/text.hpp"

namespace gaitway::input {
namespace {

// Nobody reads a value to its end that is longer.
std::string shortened(const std::string& value) {
  constexpr std::size_t kMost = 200;
  return value.size() <= kMost ? value
                               : fmt::format("{}... ({} bytes)", value.substr(0, kMost), value.size());
}

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
    text += shortened(complaint.field);
    text += complaint.value.empty() ? ": " : fmt::format(" = {}: ", shortened(complaint.value));
  }
  text += as_sentence(complaint.rule);
  if (!complaint.remedy.empty()) {
    text += ' ';
    text += as_sentence(complaint.remedy);
  }
  throw InputError(terminal_text(text));
}

}  // namespace gaitway::input
