// Disturbances of the bus as written on the command line (tools/bus/bus_options.hpp). Whatever the text: it
// is refused with std::invalid_argument and nothing else, or gives a source whose hits can be counted in any
// window.
#include "tools/bus/bus_options.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>

#include "fuzz_input.hpp"

namespace gaitway::fuzz {

void error_option(std::span<const std::uint8_t> bytes) {
  const std::string text(Input(bytes).rest_as_text());
  std::optional<can::ErrorSource> source;
  try {
    source = tools::parse_errors(text);
  } catch (const std::invalid_argument&) {
    return;
  }
  require(source->burst >= 1 && source->interval_ns >= 0 && source->duration_ns >= 0, "errors are there");
  std::int64_t before = 0;
  for (std::int64_t window_ns = 1; window_ns < std::int64_t{1} << 56; window_ns *= 10) {
    const std::int64_t hits = source->hits(window_ns);
    require(hits >= before && hits >= source->burst, "a longer window has no fewer errors");
    before = hits;
  }
}

}  // namespace gaitway::fuzz
