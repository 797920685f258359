// Reading, staging and checking of values, without allocation once bound.
#include "gaitway/core/topic_port.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>

#include "gaitway/msgclient/topics.hpp"

namespace gaitway::core {
namespace {

// Exponent bits all set: infinite or not a number. The loop has no branch but its last one, so that compilers
// vectorise it.
template <class Word>
std::optional<std::uint32_t> first_non_finite(const std::byte* data, std::uint32_t count,
                                              Word exponent) noexcept {
  Word found = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    Word word;
    std::memcpy(&word, data + i * sizeof(Word), sizeof(Word));
    found |= static_cast<Word>((word & exponent) == exponent);
  }
  for (std::uint32_t i = 0; found != 0 && i < count; ++i) {
    Word word;
    std::memcpy(&word, data + i * sizeof(Word), sizeof(Word));
    if ((word & exponent) == exponent) {
      return i;
    }
  }
  return std::nullopt;
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

}  // namespace

TopicPort::TopicPort(const gaitway_topic& topic, Access access)
    : use_{.access = access,
           .topic = topic.name,
           .type_name = topic.type_name,
           .type_hash = topic.type_hash,
           .size = topic.size},
      copy_(topic.size) {
  for (std::uint32_t i = 0; i < topic.float_field_count; ++i) {
    const gaitway_float_field& field = topic.float_fields[i];
    const std::uint64_t end = std::uint64_t{field.offset} + std::uint64_t{field.count} * field.bytes;
    if ((field.bytes != 4 && field.bytes != 8) || end > topic.size || field.rows == 0) {
      throw PluginError(fmt::format(
          "topic '{}': the floating-point field '{}' ({} x {} bytes at {}) does not lie in a value "
          "of {} bytes. Correct the plug-in's field table",
          topic.name, field.name, field.count, field.bytes, field.offset, topic.size));
    }
    float_fields_.push_back({field.name, field.offset, field.count, field.bytes, field.rows});
  }
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
  if (use_.access == Access::read_previous) {
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
  return sample.sequence == 0 ? GAITWAY_NO_VALUE : GAITWAY_OK;
}

void TopicPort::take_snapshot() noexcept {
  if (use_.access != Access::read_previous || !reader_ || reader_->newest_sequence() == snapshot_.sequence) {
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
  } else if (use_.type_hash == TopicType<JointPlan>::hash) {
    rows = 0;  // most of its columns are not in use; what is goes through the check of joint plans
  }
  return field.count / field.rows * rows;
}

std::optional<NonFinite> TopicPort::find_non_finite() const noexcept {
  if (!staged_) {
    return std::nullopt;
  }
  for (const FloatField& field : float_fields_) {
    const std::byte* const data = copy_.data() + field.offset;
    const std::uint32_t count = elements_in_use(field);
    const auto element = field.bytes == 4
                             ? first_non_finite<std::uint32_t>(data, count, 0x7f80'0000U)
                             : first_non_finite<std::uint64_t>(data, count, 0x7ff0'0000'0000'0000U);
    if (element) {
      return NonFinite{&field, *element};
    }
  }
  return std::nullopt;
}

}  // namespace gaitway::core
