// The rule for values: every floating-point number finite and within its field's limits.
#include "topic_view.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <stdexcept>

namespace gaitway::python {
namespace {

template <class Number>
double number_at(std::span<const std::byte> value, std::size_t offset) {
  Number number{};
  std::memcpy(&number, value.data() + offset, sizeof number);
  return static_cast<double>(number);
}

}  // namespace

void check_value(const StandardTopic& topic, std::span<const std::byte> value) {
  for (const FieldDescriptor& field : topic.type->fields) {
    const bool wide = field.type == ScalarType::float64_value;
    if (!wide && field.type != ScalarType::float32_value) continue;
    for (std::uint32_t i = 0; i < field.elements(); ++i) {
      const std::size_t offset = field.offset + std::size_t{i} * scalar_size(field.type);
      const double number = wide ? number_at<double>(value, offset) : number_at<float>(value, offset);
      if (std::isfinite(number) && number >= field.lowest && number <= field.highest) continue;
      throw std::invalid_argument(fmt::format(
          "topic '{}': {}[{}] = {:g}: must be {}", topic.name, field.name, i, number,
          std::isfinite(field.lowest) ? fmt::format("within [{:g}, {:g}]{}{}", field.lowest, field.highest,
                                                    field.unit.empty() ? "" : " ", field.unit)
                                      : std::string("a finite number")));
    }
  }
}

}  // namespace gaitway::python
