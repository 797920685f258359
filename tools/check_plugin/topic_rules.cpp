// Range, by the schema, and continuity, field by field.
#include "tools/check_plugin/topic_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "gaitway/msgclient/topics.hpp"

namespace gaitway::plugin_check {
namespace {

// How far a field may move from tick to tick; of a plan from point to point and from plan to plan. Its range
// is the schema's.
struct LargestChange {
  std::string_view type;
  std::string_view field;
  double value;
};

// Wide enough for any robot of this size class, and tight enough that none is harmed by what passes.
constexpr std::array kLargestChanges{
    LargestChange{"Estimate", "com", 0.10},
    LargestChange{"Estimate", "com_velocity", 1.0},
    LargestChange{"Estimate", "dcm", 0.30},
    LargestChange{"Estimate", "attitude", 0.30},
    LargestChange{"Estimate", "angular_velocity", 10.0},
    LargestChange{"MotionPlan", "com", 0.03},
    LargestChange{"MotionPlan", "com_velocity", 0.5},
    LargestChange{"MotionPlan", "hip_height", 0.03},
    LargestChange{"MotionPlan", "base_yaw", 0.10},
    LargestChange{"MotionPlan", "foot_position", 0.10},
    LargestChange{"MotionPlan", "foot_yaw", 0.20},
    LargestChange{"Correction", "com_offset", 0.02},
    LargestChange{"Correction", "base_attitude_offset", 0.05},
    LargestChange{"Correction", "bow", 0.50},
    LargestChange{"Correction", "turn_rate_offset", 0.50},
    LargestChange{"Correction", "step_offset", 0.10},
    LargestChange{"TrimCommand", "angle", 0.10},
    LargestChange{"TrimCommand", "attitude_reference", 0.05},
};

// Infinite: any.
double largest_change(std::string_view type, std::string_view field) noexcept {
  const auto* const found = std::ranges::find_if(kLargestChanges, [&](const LargestChange& change) {
    return change.type == type && change.field == field;
  });
  return found == kLargestChanges.end() ? std::numeric_limits<double>::infinity() : found->value;
}

std::uint32_t count_field(const TypeDescriptor& type, const std::byte* value,
                          std::string_view name) noexcept {
  for (const FieldDescriptor& field : type.fields) {
    if (field.name == name && field.type == ScalarType::uint32_value) {
      std::uint32_t count = 0;
      std::memcpy(&count, value + field.offset, sizeof count);
      return count;
    }
  }
  return std::numeric_limits<std::uint32_t>::max();
}

// How many of the first extent, and of the second, a value says that it uses.
struct InUse {
  std::uint32_t rows = 1;
  std::uint32_t columns = 1;  // scalars in a row
};

InUse in_use(const TypeDescriptor& type, const FieldDescriptor& field, const std::byte* value) noexcept {
  if (field.rank == 0) {
    return {};
  }
  InUse use{field.extents[0], field.elements() / field.extents[0]};
  const auto cap = [&](std::uint32_t& extent, std::string_view count) {
    extent = std::min(extent, count_field(type, value, count));
  };
  if (field.extents[0] == kMaxPoints) {
    const std::uint32_t tail =
        std::min<std::uint32_t>(count_field(type, value, "tail_count"), kMaxTailPoints);
    use.rows = count_field(type, value, "sequence") == 0 ? 0 : kBatchPoints + tail;
  } else if (field.name.starts_with("footstep")) {
    cap(use.rows, "footstep_count");
  } else if (field.extents[0] == kMaxJoints) {
    cap(use.rows, "joint_count");
  } else if (type.name == "TrimCommand" && field.name == "angle") {
    cap(use.rows, "channel_count");
  }
  if (field.rank > 1 && field.extents[1] == kMaxJoints) {
    cap(use.columns, "joint_count");
  }
  return use;
}

double number_at(const FieldDescriptor& field, const std::byte* value, std::uint32_t index) noexcept {
  const std::byte* const at = value + field.offset + std::size_t{index} * scalar_size(field.type);
  if (field.type == ScalarType::float32_value) {
    float number = 0.0F;
    std::memcpy(&number, at, sizeof number);
    return static_cast<double>(number);
  }
  double number = 0.0;
  std::memcpy(&number, at, sizeof number);
  return number;
}

bool is_float(const FieldDescriptor& field) noexcept {
  return field.type == ScalarType::float32_value || field.type == ScalarType::float64_value;
}

// Calls `look(field, index, row)` for every floating-point number in use; stops at the first text.
template <class Look>
std::optional<std::string> each_number(const Port& port, const Look& look) {
  const TypeDescriptor& type = *port.standard_type;
  for (const FieldDescriptor& field : type.fields) {
    if (!is_float(field)) {
      continue;
    }
    const InUse use = in_use(type, field, port.value.data());
    const std::uint32_t width = field.rank == 0 ? 1 : field.elements() / field.extents[0];
    for (std::uint32_t row = 0; row < use.rows; ++row) {
      for (std::uint32_t column = 0; column < use.columns; ++column) {
        if (auto text = look(field, row * width + column, row)) {
          return text;
        }
      }
    }
  }
  return std::nullopt;
}

std::string element_name(const Port& port, const FieldDescriptor& field, std::uint32_t index) {
  return field.rank == 0 ? fmt::format("{}.{}", port.topic, field.name)
                         : fmt::format("{}.{}[{}]", port.topic, field.name, index);
}

class Digest {
 public:
  void add(const std::byte* data, std::size_t bytes) noexcept {
    for (std::size_t i = 0; i < bytes; ++i) {
      value_ = (value_ ^ static_cast<std::uint64_t>(data[i])) * 0x100000001b3u;
    }
  }
  [[nodiscard]] std::uint64_t value() const noexcept { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

}  // namespace

std::uint64_t digest_of(const Port& port) noexcept {
  Digest digest;
  const std::byte* const value = port.value.data();
  if (port.standard_type == nullptr) {
    for (const gaitway_float_field& field : port.float_fields) {
      digest.add(value + field.offset, std::size_t{field.count} * field.bytes);
    }
    return digest.value();
  }
  for (const FieldDescriptor& field : port.standard_type->fields) {
    const InUse use = in_use(*port.standard_type, field, value);
    const std::size_t scalar = scalar_size(field.type);
    const std::size_t width = field.rank == 0 ? 1 : field.elements() / field.extents[0];
    for (std::uint32_t row = 0; row < use.rows && field.name != "reserved"; ++row) {
      digest.add(value + field.offset + row * width * scalar, use.columns * scalar);
    }
  }
  return digest.value();
}

std::optional<std::string> OutputRules::non_finite(const Port& port) const {
  if (port.standard_type != nullptr) {
    return each_number(
        port,
        [&](const FieldDescriptor& field, std::uint32_t index, std::uint32_t) -> std::optional<std::string> {
          const double number = number_at(field, port.value.data(), index);
          if (std::isfinite(number)) {
            return std::nullopt;
          }
          return fmt::format("{} is {}", element_name(port, field, index), number);
        });
  }
  for (const gaitway_float_field& field : port.float_fields) {
    const FieldDescriptor plain{
        .name = field.name,
        .type = field.bytes == 4 ? ScalarType::float32_value : ScalarType::float64_value,
        .rank = 1,
        .extents = {field.count},
        .unit = {},
        .frame = {},
        .doc = {},
        .offset = field.offset};
    for (std::uint32_t i = 0; i < field.count; ++i) {
      if (const double number = number_at(plain, port.value.data(), i); !std::isfinite(number)) {
        return fmt::format("{} is {}", element_name(port, plain, i), number);
      }
    }
  }
  return std::nullopt;
}

std::optional<std::string> OutputRules::out_of_range(const Port& port) const {
  if (port.standard_type == nullptr) {
    return std::nullopt;
  }
  if (port.standard_type->hash == TopicType<JointPlan>::hash) {
    return joint_plan_fault(port, {});
  }
  return each_number(
      port,
      [&](const FieldDescriptor& field, std::uint32_t index, std::uint32_t) -> std::optional<std::string> {
        const double number = number_at(field, port.value.data(), index);
        if (!(number < field.lowest || number > field.highest)) {
          return std::nullopt;
        }
        return fmt::format("{} is {:g} {}, allowed is {:g} to {:g}", element_name(port, field, index), number,
                           field.unit, field.lowest, field.highest);
      });
}

std::optional<std::string> OutputRules::joint_plan_fault(const Port& port,
                                                         std::span<const double> start_rad) const {
  JointPlan plan;
  std::memcpy(&plan, port.value.data(), sizeof plan);
  if (plan.sequence == 0) {
    return std::nullopt;
  }
  const core::JointPlanVerdict verdict = joint_plan_check_.check(plan, start_rad);
  std::array<char, 200> text{};
  return verdict.accepted() ? std::nullopt
                            : std::optional<std::string>(joint_plan_check_.describe(verdict, text));
}

std::optional<std::string> OutputRules::jump(const Port& port) {
  if (port.standard_type == nullptr) {
    return std::nullopt;
  }
  auto before = std::ranges::find_if(before_, [&](const Before& b) { return b.port == &port; });
  const bool first = before == before_.end();
  if (first) {
    before = before_.insert(before_.end(), {&port, port.value});
  }
  const std::vector<std::byte> old = std::exchange(before->value, port.value);
  const TypeDescriptor& type = *port.standard_type;
  const auto number = [&](std::string_view name) { return count_field(type, port.value.data(), name); };
  const auto old_number = [&](std::string_view name) { return count_field(type, old.data(), name); };
  const bool is_plan = type.hash == TopicType<MotionPlan>::hash || type.hash == TopicType<JointPlan>::hash;
  // A plan follows its predecessor's batch; an estimate is seen from another foot after a change of support.
  const bool follows =
      !first && (is_plan ? old_number("sequence") + 1 == number("sequence") && old_number("sequence") != 0
                         : number("support") == old_number("support"));
  if (type.hash == TopicType<JointPlan>::hash) {
    JointPlan last;
    std::memcpy(&last, old.data(), sizeof last);
    std::vector<double> start(std::min<std::size_t>(last.joint_count, kMaxJoints));
    std::copy_n(last.position[kBatchPoints - 1], start.size(), start.begin());
    return follows ? joint_plan_fault(port, start) : std::nullopt;
  }
  return each_number(port,
                     [&](const FieldDescriptor& field, std::uint32_t index,
                         std::uint32_t row) -> std::optional<std::string> {
                       const double largest = largest_change(type.name, field.name);
                       const bool in_plan = is_plan && field.rank > 0 && field.extents[0] == kMaxPoints;
                       const std::uint32_t width = field.rank == 0 ? 1 : field.elements() / field.extents[0];
                       const bool has_point_before = in_plan && row > 0;
                       if (std::isinf(largest) || (!has_point_before && !follows)) {
                         return std::nullopt;
                       }
                       const double now = number_at(field, port.value.data(), index);
                       const double then =
                           has_point_before ? number_at(field, port.value.data(), index - width)
                           : in_plan        ? number_at(field, old.data(), (kBatchPoints - 1) * width + index)
                                            : number_at(field, old.data(), index);
                       return std::abs(now - then) <= largest
                                  ? std::nullopt
                                  : std::optional(fmt::format(
                                        "{} jumps from {:g} to {:g} {}, allowed is a change of {:g}",
                                        element_name(port, field, index), then, now, field.unit, largest));
                     });
}

}  // namespace gaitway::plugin_check
