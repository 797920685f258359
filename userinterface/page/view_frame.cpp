// Rows into bytes, one after the other.
#include "gaitway/page/view_frame.hpp"

#include <algorithm>
#include <cmath>

namespace gaitway::page {
namespace {

struct RawRange {
  double lowest, highest, unknown;
};

// What is not known has a number of its own, which nothing else becomes.
RawRange range_of(ViewType type) {
  switch (type) {
    case ViewType::uint8:
      return {0.0, 254.0, 255.0};
    case ViewType::uint16:
      return {0.0, 65534.0, 65535.0};
    case ViewType::uint32:
      return {0.0, 4294967294.0, 4294967295.0};
    case ViewType::int16:
      return {-32767.0, 32767.0, -32768.0};
    case ViewType::int32:
      return {-2147483647.0, 2147483647.0, -2147483648.0};
  }
  return {};
}

std::int64_t raw_of(const ViewRow& row, double value) {
  if (row.scale == 0.0) {
    return static_cast<std::int64_t>(value);
  }
  const RawRange range = range_of(row.type);
  if (std::isnan(value)) {
    return static_cast<std::int64_t>(range.unknown);
  }
  return std::llround(std::clamp(value / row.scale, range.lowest, range.highest));
}

}  // namespace

std::string encode_view(const ViewState& state) {
  std::string bytes;
  bytes.reserve(kMostViewBytes);
  for (const ViewRow& row : kViewRows) {
    const std::size_t count = row.count > 0 ? row.count : std::min(state.joint_count, kViewJoints);
    for (std::size_t i = 0; i < count; ++i) {
      const auto raw = static_cast<std::uint64_t>(raw_of(row, row.value(state, i)));
      for (std::size_t byte = 0; byte < bytes_of(row.type); ++byte) {
        bytes += static_cast<char>(raw >> (8 * byte) & 0xFFU);
      }
    }
  }
  return bytes;
}

}  // namespace gaitway::page
