// Words and lines side by side.
#include "tools/twin/compatibility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "gaitway/input/text.hpp"

namespace gaitway::tools {
namespace {

constexpr std::size_t kShownBytes = 100;

// "0.1" of "0.1.0".
std::string_view minor_of(std::string_view release) {
  const std::size_t first = release.find('.');
  return first == std::string_view::npos ? release : release.substr(0, release.find('.', first + 1));
}

std::string_view trimmed(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return {};
  return line.substr(begin, line.find_last_not_of(" \t\r") - begin + 1);
}

std::string shown(std::string_view line) {
  return line.empty() ? "nothing"
                      : "'" + input::terminal_text(std::string(trimmed(line).substr(0, kShownBytes))) + "'";
}

// The next line, which is taken from `text`.
std::string_view next_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

}  // namespace

std::string release_difference(std::string_view server, std::string_view own_release) {
  constexpr std::string_view kName = "gaitway";
  if (!server.starts_with(kName)) {
    return fmt::format("what answers there is '{}' and no robot API of this project",
                       input::terminal_text(std::string(server.substr(0, kShownBytes))));
  }
  const std::string_view release = server.substr(std::min(kName.size() + 1, server.size()));
  if (release.empty()) {
    return fmt::format("the robot there runs a release before {}, which this is: install the same on both",
                       own_release);
  }
  if (minor_of(release) == minor_of(own_release)) return {};
  return fmt::format("the robot there runs release {}, and this is {}: install the same on both",
                     input::terminal_text(std::string(release.substr(0, kShownBytes))), own_release);
}

std::string description_difference(std::string_view there, std::string_view here) {
  for (int line = 1; !there.empty() || !here.empty(); ++line) {
    const std::string_view of_there = next_line(there), of_here = next_line(here);
    if (trimmed(of_there) == trimmed(of_here)) continue;
    return fmt::format(
        "the robot there has another description: line {} of its robot.urdf is {}, and here it is {}: give "
        "its own folder (--robot FOLDER beside its address)",
        line, shown(of_there), shown(of_here));
  }
  return {};
}

}  // namespace gaitway::tools
