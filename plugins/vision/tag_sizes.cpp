// Pairs of number and size, with commas between.
#include "gaitway/vision/tag_sizes.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "gaitway/input/complaint.hpp"
#include "gaitway/input/number.hpp"

namespace gaitway::vision {
namespace {

constexpr std::int64_t kTags = 587;  // of the family 36h11
constexpr std::array<input::Unit, 3> kUnits_um{{{"mm", 1e3}, {"cm", 1e4}, {"m", 1e6}}};

[[noreturn]] void refuse(std::string_view entry, const std::string& rule) {
  input::refuse({.file = {},
                 .line = 0,
                 .field = "tag_sizes",
                 .value = std::string(entry),
                 .rule = rule,
                 .remedy = "Write for example `3: 0.2 m, 17: 80 mm`"});
}

TagSize size_in(std::string_view entry) {
  const std::size_t colon = entry.find(':');
  if (colon == std::string_view::npos) refuse(entry, "must be a number, a colon and a size");
  try {
    const auto id = input::plain_number<std::int64_t>(input::trimmed(entry.substr(0, colon)));
    if (id < 0 || id >= kTags) refuse(entry, "the family 36h11 has the tags 0 to 586");
    const std::int64_t size_um =
        input::number_with_unit(input::trimmed(entry.substr(colon + 1)), kUnits_um, 10'000, 5'000'000);
    return {.id = static_cast<int>(id), .size_m = 1e-6 * static_cast<double>(size_um)};
  } catch (const input::ValueError& error) {
    refuse(entry, error.rule);
  }
}

}  // namespace

std::vector<TagSize> tag_sizes_in(std::string_view text) {
  std::vector<TagSize> sizes;
  while (!input::trimmed(text).empty()) {
    const std::size_t comma = std::min(text.find(','), text.size());
    const TagSize next = size_in(input::trimmed(text.substr(0, comma)));
    if (std::ranges::count(sizes, next.id, &TagSize::id) > 0) refuse(text, "names a tag twice");
    sizes.push_back(next);
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  return sizes;
}

}  // namespace gaitway::vision
