// Keeps text within its line, and within YAML's quotes.
#include "gaitway/input/written_text.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "gaitway/input/text.hpp"

namespace gaitway::input {

std::string one_line(std::string_view text) {
  std::string result;
  for (const char letter : terminal_text(text)) {
    if (letter == '\n' || letter == '\t') {
      result += letter == '\n' ? "\\x0A" : "\\x09";
    } else {
      result += letter;
    }
  }
  return result;
}

std::string yaml_text(std::string_view text, std::string_view also_plain) {
  constexpr std::array<std::string_view, 9> kWords{"null", "true", "false", "yes", "no",
                                                   "on",   "off",  "y",     "n"};
  const auto is_plain = [&](unsigned char c) {
    return std::isalnum(c) != 0 || also_plain.find(static_cast<char>(c)) != also_plain.npos;
  };
  std::string lower_case;
  for (const char c : text) lower_case += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (!text.empty() && std::isalpha(static_cast<unsigned char>(text[0])) != 0 &&
      std::ranges::all_of(text, is_plain) && std::ranges::find(kWords, lower_case) == kWords.end()) {
    return std::string(text);
  }
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

}  // namespace gaitway::input
