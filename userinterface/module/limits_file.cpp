// A key for each row of the limits' table.
#include "gaitway/api/limits_file.hpp"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <system_error>
#include <vector>

#include "gaitway/input/complaint.hpp"
#include "gaitway/input/yaml_value.hpp"

namespace gaitway::api {
namespace {

struct ReadLimit {
  const input::YamlValue& map;

  void operator()(const LimitRow& row, std::size_t& count) const {
    if (const auto value = map.find(row.name)) {
      count = static_cast<std::size_t>(value->integer(1, row.highest));
    }
  }
  void operator()(const LimitRow& row, std::int64_t& time_ns) const {
    constexpr double kSecond_ns = 1e9;
    if (const auto value = map.find(row.name)) {
      time_ns = static_cast<std::int64_t>(kSecond_ns * value->number({0.05, 600.0, row.unit}));
    }
  }
  void operator()(const LimitRow& row, double& number) const {
    if (const auto value = map.find(row.name)) {
      number = value->number({1e-3, 1e6, row.unit});
    }
  }
};

}  // namespace

Limits read_limits(const std::filesystem::path& file) {
  if (std::error_code missing;
      std::filesystem::exists(file, missing) && !std::filesystem::is_regular_file(file, missing)) {
    // A pipe would have the process wait for who writes to it.
    input::refuse({file, 0, "", "", "is no regular file", "Name the file with the limits"});
  }
  const input::YamlValue map = input::YamlValue::read(file);
  Limits limits;
  std::vector<std::string_view> names;
  visit_limits(limits, [&names](const LimitRow& row, const auto&) { names.push_back(row.name); });
  map.require_map(names);
  visit_limits(limits, ReadLimit{map});
  return limits;
}

}  // namespace gaitway::api
