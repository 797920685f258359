// Times in the configuration: "200 us".
#pragma once

#include <cstdint>

namespace gaitway::input {
class YamlValue;
}

namespace gaitway::core {

// A number and its unit (ns, us, ms or s), in ns. Throws input::InputError; `range` names the limits there.
std::int64_t read_time_ns(const input::YamlValue& value, std::int64_t lowest_ns, std::int64_t highest_ns,
                          const char* range);

}  // namespace gaitway::core
