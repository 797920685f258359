// A parameter as one line of JSON: its longest texts are shortened until the line fits.
#include "gaitway/instance/parameter_set.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "gaitway/instance/configuration.hpp"

namespace gaitway::core {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLongestEscape = 6;  // bytes that one byte of a text may take

Json limit_of(const Parameter& parameter, double limit) {
  const bool numeric = parameter.kind == ParameterKind::number || parameter.kind == ParameterKind::integer;
  return numeric && std::isfinite(limit) ? Json(limit) : Json(nullptr);
}

std::string dump(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);  // a plug-in may write what is no UTF-8
}

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
  std::string line;
  const auto write = [&] {
    line = dump(Json{{"name", parameter.name},
                     {"value", value},
                     {"unit", parameter.unit},
                     {"doc", doc},
                     {"live", parameter.live},
                     {"lowest", limit_of(parameter, parameter.lowest)},
                     {"highest", limit_of(parameter, parameter.highest)}});
    return line.size() <= most_bytes;
  };
  for (std::string* const part : {&doc, &value}) {
    while (!write() && !part->empty()) {
      shorten(*part, (line.size() - most_bytes) / kLongestEscape + 1);
    }
  }
  return write() ? line : throw PluginError("its name or its unit is too long to be told");
}

}  // namespace gaitway::core
