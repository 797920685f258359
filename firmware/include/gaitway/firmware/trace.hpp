// A recording of everything that reaches some joint controllers, as bytes: what the host writes and both the
// host and a microcontroller play. Little-endian, whatever the machine. Freestanding.
//
// A trace is a sequence of records, each a kind (one byte) and its fields:
//   joint     index, configuration       a joint controller starts (again) under this index
//   frame     identifier, size, format (bit 0 extended, bit 1 remote), 8 bytes: the frame of the next records
//   received  index, time                the joint receives that frame at this instant of its own clock
//   step      index, time, sensors       one servo period
//   take      index                      the joint is asked for a frame to send
//   reset     index                      an emergency stop ends
//   end                                  nothing follows
// Times are of the joint's own clock, in nanoseconds.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "gaitway/can/frame.hpp"
#include "gaitway/can/profile.hpp"
#include "gaitway/localcontroller/joint_controller.hpp"

namespace gaitway::firmware {

enum class TraceRecord : std::uint8_t {
  joint = 'J',
  frame = 'F',
  received = 'R',
  step = 'S',
  take = 'T',
  reset = 'X',
  end = 'E'
};

inline constexpr std::size_t kLargestTraceJoints = 32;

// The unsigned integer that carries a field's bits.
template <class Field>
using FieldBits = std::conditional_t<
    sizeof(Field) == 8, std::uint64_t,
    std::conditional_t<sizeof(Field) == 4, std::uint32_t,
                       std::conditional_t<sizeof(Field) == 2, std::uint16_t, std::uint8_t>>>;

// Puts fields, in the order of calls, to `sink.write(const std::uint8_t*, std::size_t)`.
template <class Sink>
class FieldPut {
 public:
  explicit FieldPut(Sink& sink) noexcept : sink_(sink) {}

  template <class Field>
  void operator()(const Field& field) {
    const auto bits = std::bit_cast<FieldBits<Field>>(field);
    std::array<std::uint8_t, sizeof(Field)> bytes{};
    for (std::size_t byte = 0; byte < bytes.size(); ++byte) {
      bytes[byte] = static_cast<std::uint8_t>(bits >> (8 * byte));
    }
    sink_.write(bytes.data(), bytes.size());
  }

 private:
  Sink& sink_;
};

// Gets fields from `source.read(std::uint8_t*, std::size_t) -> bool`. Past the end they are zero, and
// complete() is false.
template <class Source>
class FieldGet {
 public:
  explicit FieldGet(Source& source) noexcept : source_(source) {}

  template <class Field>
  void operator()(Field& field) {
    std::array<std::uint8_t, sizeof(Field)> bytes{};
    complete_ = complete_ && source_.read(bytes.data(), bytes.size());
    FieldBits<Field> bits = 0;
    for (std::size_t byte = 0; byte < bytes.size(); ++byte) {
      bits = static_cast<FieldBits<Field>>(bits | FieldBits<Field>{bytes[byte]} << (8 * byte));
    }
    field = std::bit_cast<Field>(bits);
  }
  template <class Field>
  Field get() {
    Field field{};
    (*this)(field);
    return field;
  }
  [[nodiscard]] bool complete() const noexcept { return complete_; }

 private:
  Source& source_;
  bool complete_ = true;
};

// The fields of each record, described once for both directions. A profile's name is not among them.
template <class Fields>
void trace_fields(Fields& fields, can::Profile& profile) {
  for (can::ProfileRow& row : profile.rows) {
    fields(row.rule);
    fields(row.base_id);
    fields(row.period_ns);
    fields(row.on_event);
    fields(row.deadline_ns);
  }
  fields(profile.largest_node);
  fields(profile.tail_parts);
}

template <class Fields>
void trace_fields(Fields& fields, localcontroller::JointConfig& config) {
  trace_fields(fields, config.profile);
  fields(config.node);
  fields(config.count_rad);
  fields(config.encoder_count_rad);
  fields(config.encoder_zero_rad);
  fields(config.stiffness_Nm_per_rad);
  fields(config.damping_Nms_per_rad);
  fields(config.torque_limit_Nm);
  fields(config.speed_limit_rad_per_s);
  fields(config.lower_rad);
  fields(config.upper_rad);
  fields(config.initial_reference_count);
  std::int32_t senses_current = config.senses_current ? 1 : 0;
  fields(senses_current);
  config.senses_current = senses_current != 0;
  std::int32_t trim_channel = config.trim_channel;
  fields(trim_channel);
  config.trim_channel = static_cast<int>(trim_channel);
  fields(config.trim_count_rad);
  fields(config.trim_slew_rad_per_s);
  fields(config.trim_limit_rad);
  for (float& scale : config.channel_scale) {
    fields(scale);
  }
}

template <class Fields>
void trace_fields(Fields& fields, localcontroller::JointSensors& sensors) {
  fields(sensors.encoder_count);
  for (float& channel : sensors.channel) {
    fields(channel);
  }
  fields(sensors.motor_current_Nm);
}

template <class Fields>
void trace_fields(Fields& fields, can::Frame& frame) {
  fields(frame.id);
  fields(frame.size);
  auto format = static_cast<std::uint8_t>((frame.extended ? 1U : 0U) | (frame.remote ? 2U : 0U));
  fields(format);
  frame.extended = (format & 1U) != 0;
  frame.remote = (format & 2U) != 0;
  for (std::uint8_t& byte : frame.data) {
    fields(byte);
  }
}

}  // namespace gaitway::firmware
