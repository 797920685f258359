// Reading, staging and checking of values, without allocation once bound.
#include "gaitway/instance/topic_port.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/plugin/detail/plugin_border.hpp"

namespace gaitway::core {
namespace {

// Neither finite nor within the limits: one comparison finds both, since none holds for a NaN. The loop has
// no branch, so that compilers vectorise it.
template <class Number>
std::optional<std::uint32_t> first_beyond(const std::byte* data, std::uint32_t count, double lowest,
                                          double highest) noexcept {
  constexpr auto kLargest = static_cast<double>(std::numeric_limits<Number>::max());
  const auto low = static_cast<Number>(std::max(lowest, -kLargest));
  const auto high = static_cast<Number>(std::min(highest, kLargest));
  const auto is_good = [&](std::uint32_t i) {
    Number number;
    std::memcpy(&number, data + i * sizeof(Number), sizeof(Number));
    return static_cast<unsigned>(number >= low) & static_cast<unsigned>(number <= high);
  };
  unsigned good = 1;
  for (std::uint32_t i = 0; i < count; ++i) {
    good &= is_good(i);
  }
  for (std::uint32_t i = 0; good == 0 && i < count; ++i) {
    if (is_good(i) == 0) {
      return i;
    }
  }
  return std::nullopt;
}

const StandardTopic* standard_topic(std::string_view name, std::uint64_t type_hash) noexcept {
  const auto found = std::ranges::find_if(kStandardTopics, [&](const StandardTopic& topic) {
    return topic.name == name && topic.type->hash == type_hash;
  });
  return found == kStandardTopics.end() ? nullptr : &*found;
}

// A standard type's limits say what makes sense in its topic. Under another name it may mean anything.
bool has_limits(const TopicUse& use) noexcept {
  const bool standard_type = std::ranges::any_of(
      kStandardTypes, [&](const TypeDescriptor* type) { return type->hash == use.type_hash; });
  return !standard_type || standard_topic(use.topic, use.type_hash) != nullptr;
}

// Of a plan only the points that it claims to have are in use; one with sequence 0 has none.
template <class Plan>
std::uint32_t points_in_use(const std::byte* value) noexcept {
  std::uint32_t sequence = 0;
  std::uint32_t tail_count = 0;
  std::memcpy(&sequence, value + offsetof(Plan, sequence), sizeof sequence);
  std::memcpy(&tail_count, value + offsetof(Plan, tail_count), sizeof tail_count);
  return sequence == 0 ? 0 : kBatchPoints + std::min<std::uint32_t>(tail_count, kMaxTailPoints);
}

void check_field(const gaitway_topic& topic, const gaitway_float_field& field) {
  const std::uint64_t end = std::uint64_t{field.offset} + std::uint64_t{field.count} * field.bytes;
  if ((field.bytes != 4 && field.bytes != 8) || end > topic.size || field.count == 0) {
    throw PluginError(
        fmt::format("topic '{}': the floating-point field '{}' ({} x {} bytes at {}) does not lie in a value "
                    "of {} bytes. Correct the plug-in's field table",
                    topic.name, field.name, field.count, field.bytes, field.offset, topic.size));
  }
  if (field.rows == 0 || field.count % field.rows != 0) {
    throw PluginError(
        fmt::format("topic '{}': the floating-point field '{}' has {} numbers in {} rows; the rows must "
                    "divide them. Correct the plug-in's field table",
                    topic.name, field.name, field.count, field.rows));
  }
}

}  // namespace

TopicPort::TopicPort(const gaitway_topic& topic, Access access)
    : use_{.access = access,
           .topic = topic.name,
           .type_name = topic.type_name,
           .type_hash = topic.type_hash,
           .size = topic.size},
      copy_(topic.size) {
  const std::span own(topic.float_fields, topic.float_field_count);
  std::ranges::for_each(own, [&](const auto& field) { check_field(topic, field); });
  // What the schema says of a standard topic holds, whatever the plug-in says of it.
  const StandardTopic* const standard = standard_topic(use_.topic, use_.type_hash);
  const bool known = standard != nullptr && standard->type->size == topic.size;
  const detail::FloatFields schema(known ? standard->type->fields : std::span<const FieldDescriptor>());
  for (const gaitway_float_field& field : known ? std::span(schema.data(), schema.count()) : own) {
    const bool limited = (field.lowest != 0.0 || field.highest != 0.0) && has_limits(use_);
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    use_.number_fields += fmt::format("{}{} {} x float{} at {}", float_fields_.empty() ? "" : ", ",
                                      field.name, field.count, 8 * field.bytes, field.offset);
    float_fields_.push_back({field.name, field.offset, field.count, field.bytes, field.rows,
                             limited ? field.lowest : -kInfinity, limited ? field.highest : kInfinity});
  }
  if (float_fields_.empty()) {
    use_.number_fields = "no floating-point fields";
  }
  periodic_ = standard == nullptr || standard->period_ns > 0;
}

void TopicPort::bind(msgclient::Client& client) {
  const msgclient::TopicDescriptor descriptor{use_.topic, use_.type_name, use_.type_hash, use_.size};
  if (use_.access == Access::write) {
    writer_.emplace(client.write_untyped(descriptor));
  } else {
    reader_.emplace(client.read_untyped(descriptor));
  }
}

void TopicPort::take_output(TopicPort& from) noexcept {
  const bool same = use_.access == Access::write && from.use_.access == Access::write &&
                    use_.topic == from.use_.topic && use_.type_hash == from.use_.type_hash &&
                    use_.size == from.use_.size;
  if (same && from.writer_) {
    writer_.emplace(std::move(*from.writer_));
    from.writer_.reset();
  }
}

gaitway_status TopicPort::read(void* value, gaitway_sample& sample) noexcept {
  if (!reader_) {
    return GAITWAY_FAILED;
  }
  if (is_of_tick_before(use_.access)) {
    if (snapshot_.sequence != sample.sequence) {
      std::memcpy(value, copy_.data(), copy_.size());
      sample = snapshot_;
    }
  } else if (reader_->newest_sequence() != sample.sequence) {
    // A reader that was overtaken again and again keeps the value that it has.
    if (const msgclient::ReadResult result = reader_->read(value)) {
      sample = {result.sequence, result.stamp_ns};
    }
  }
  read_stamp_ns_ = sample.stamp_ns;
  return sample.sequence == 0 ? GAITWAY_NO_VALUE : GAITWAY_OK;
}

std::int64_t TopicPort::take_read_age_ns(std::int64_t now_ns) noexcept {
  const bool counts = read_stamp_ns_ != 0 && periodic_;
  const std::int64_t age_ns = counts ? now_ns - read_stamp_ns_ : 0;
  read_stamp_ns_ = 0;
  return age_ns;
}

void TopicPort::take_snapshot() noexcept {
  if (!is_of_tick_before(use_.access) || !reader_ || reader_->newest_sequence() == snapshot_.sequence) {
    return;
  }
  if (const msgclient::ReadResult result = reader_->read(copy_.data())) {
    snapshot_ = {result.sequence, result.stamp_ns};
  }
}

gaitway_status TopicPort::stage(const void* value) noexcept {
  if (!writer_) {
    return GAITWAY_FAILED;
  }
  std::memcpy(copy_.data(), value, copy_.size());
  staged_ = true;
  return GAITWAY_OK;
}

void TopicPort::commit(std::int64_t stamp_ns) noexcept {
  if (staged_) {
    writer_->publish(copy_.data(), stamp_ns);
    staged_ = false;
  }
}

std::uint32_t TopicPort::elements_in_use(const FloatField& field) const noexcept {
  std::uint32_t rows = field.rows;
  if (use_.type_hash == TopicType<MotionPlan>::hash && field.rows == kMaxPoints) {
    rows = points_in_use<MotionPlan>(copy_.data());
  } else if (use_.type_hash == TopicType<JointPlan>::hash ||
             (use_.type_hash == TopicType<PosturePlan>::hash && field.rows == kMaxPoints)) {
    rows = 0;  // most of its columns are not in use; what is goes through the check of joint plans
  }
  return field.count / field.rows * rows;
}

double TopicPort::number_at(const FloatField& field, std::uint32_t element) const noexcept {
  const std::byte* const data = copy_.data() + field.offset + std::size_t{element} * field.bytes;
  double value = 0.0;
  float single = 0.0F;
  if (field.bytes == sizeof single) {
    std::memcpy(&single, data, sizeof single);
    value = static_cast<double>(single);
  } else {
    std::memcpy(&value, data, sizeof value);
  }
  return value;
}

std::optional<BadNumber> TopicPort::find_bad_number() const noexcept {
  if (!staged_) {
    return std::nullopt;
  }
  for (const FloatField& field : float_fields_) {
    const std::byte* const data = copy_.data() + field.offset;
    const std::uint32_t count = elements_in_use(field);
    const auto element = field.bytes == 4 ? first_beyond<float>(data, count, field.lowest, field.highest)
                                          : first_beyond<double>(data, count, field.lowest, field.highest);
    if (element) {
      return BadNumber{&field, *element, number_at(field, *element)};
    }
  }
  return std::nullopt;
}

void TopicPort::spoil_staged(double offset) noexcept {
  if (!staged_) {
    return;
  }
  for (const FloatField& field : float_fields_) {
    const double value = number_at(field, 0) + offset;
    const auto single = static_cast<float>(value);
    std::byte* const data = copy_.data() + field.offset;
    if (field.bytes == sizeof single) {
      std::memcpy(data, &single, sizeof single);
    } else {
      std::memcpy(data, &value, sizeof value);
    }
  }
}

bool TopicPort::publish_now(const void* value, std::int64_t stamp_ns) noexcept {
  if (!writer_) {
    return false;
  }
  writer_->publish(value, stamp_ns);
  return true;
}

}  // namespace gaitway::core
