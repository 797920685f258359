// A parameter as one line: its longest texts are shortened until the line fits.
#include "gaitway/facts/parameter_line.hpp"

#include <algorithm>
#include <string_view>

#include "gaitway/instance/configuration.hpp"
#include "gaitway/instance/parameter_set.hpp"

namespace gaitway::core {
namespace {

// Without its last `bytes` or a few more, at a character's border, and with a sign that it was longer.
void shorten(std::string& text, std::size_t bytes) {
  constexpr std::string_view kMore = "\u2026";
  std::size_t kept = text.size() - std::min(text.size(), bytes + kMore.size());
  while (kept > 0 && (static_cast<unsigned char>(text[kept]) & 0xc0U) == 0x80U) {
    --kept;
  }
  text.resize(kept);
  text += kept > 0 ? kMore : std::string_view();
}

}  // namespace

std::string parameter_line(const Parameter& parameter, std::size_t most_bytes) {
  std::string doc = parameter.doc, value = parameter.value;
  const auto line = [&] {
    return facts::write_parameter_line(
        {.name = parameter.name, .value = value, .unit = parameter.unit, .live = parameter.live, .doc = doc});
  };
  for (std::string* const part : {&doc, &value}) {
    if (const std::size_t bytes = line().size(); bytes > most_bytes) {
      shorten(*part, bytes - most_bytes);
    }
  }
  std::string written = line();
  return written.size() <= most_bytes ? written
                                      : throw PluginError("its name or its unit is too long to be told");
}

}  // namespace gaitway::core
