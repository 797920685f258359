// Encoders and decoders of all messages, driven by the message table.
#include "gaitway/can/messages.hpp"

#include "gaitway/can/profile.hpp"

namespace gaitway::can {
namespace {

// Fields lie within their frame and do not overlap; no field is wider than the packer's 32 bits.
constexpr bool fields_fit(const MessageLayout& message) {
  std::uint64_t taken = 0;
  for (const FieldSpec& field : message.fields) {
    if (field.width == 0 || field.width > 32 || field.first_bit + field.width > 8 * message.size) {
      return false;
    }
    const std::uint64_t bits = ((std::uint64_t{1} << field.width) - 1) << field.first_bit;
    if ((taken & bits) != 0) {
      return false;
    }
    taken |= bits;
  }
  return true;
}

constexpr bool layouts_are_sound() {
  for (std::size_t kind = 0; kind < kMessageLayouts.size(); ++kind) {
    const MessageLayout& message = kMessageLayouts[kind];
    if (message.kind != static_cast<MessageKind>(kind) || message.size > 8 || !fields_fit(message)) {
      return false;
    }
  }
  return true;
}

static_assert(layouts_are_sound(), "a field of the message layouts overlaps another or leaves its frame");

// Collects the fields of one message, in the table's order, into its frame.
class FieldWriter {
 public:
  FieldWriter(const Profile& profile, MessageKind kind, NodeId node = 0, bool toggle = false,
              int part = 0) noexcept
      : fields_(layout(kind).fields),
        frame_{.id = profile.id_of(kind, node, toggle, part), .size = layout(kind).size} {}

  FieldWriter& put(std::int64_t value) noexcept {
    const FieldSpec& field = fields_[next_++];
    const std::uint64_t mask = (std::uint64_t{1} << field.width) - 1;
    bits_ |= (static_cast<std::uint64_t>(value) & mask) << field.first_bit;
    return *this;
  }
  template <std::size_t size>
  FieldWriter& put_all(const std::array<std::int8_t, size>& values) noexcept {
    for (const std::int8_t value : values) {
      put(value);
    }
    return *this;
  }
  [[nodiscard]] Frame frame() const noexcept {
    Frame result = frame_;
    for (std::size_t byte = 0; byte < result.data.size(); ++byte) {
      result.data[byte] = static_cast<std::uint8_t>(bits_ >> (8 * byte));
    }
    return result;
  }

 private:
  std::span<const FieldSpec> fields_;
  std::size_t next_ = 0;
  std::uint64_t bits_ = 0;
  Frame frame_;
};

// Takes the fields of one message apart, in the table's order.
class FieldReader {
 public:
  FieldReader(const Profile& profile, const Frame& frame, MessageKind kind) noexcept
      : fields_(layout(kind).fields) {
    const auto identified = profile.identify(frame.id);
    fits_ = !frame.extended && !frame.remote && identified && identified->kind == kind &&
            frame.size == layout(kind).size;
    if (fits_) {
      identified_ = *identified;
    }
    for (std::size_t byte = 0; byte < frame.data.size(); ++byte) {
      bits_ |= std::uint64_t{frame.data[byte]} << (8 * byte);
    }
  }
  [[nodiscard]] bool fits() const noexcept { return fits_; }
  [[nodiscard]] const Identified& identified() const noexcept { return identified_; }
  template <class T>
  T take() noexcept {
    const FieldSpec& field = fields_[next_++];
    const std::uint64_t raw = (bits_ >> field.first_bit) & ((std::uint64_t{1} << field.width) - 1);
    if (field.is_signed) {
      const std::uint64_t sign = std::uint64_t{1} << (field.width - 1U);
      return static_cast<T>(static_cast<std::int64_t>(raw ^ sign) - static_cast<std::int64_t>(sign));
    }
    return static_cast<T>(raw);
  }

  template <std::size_t size>
  void take_all(std::array<std::int8_t, size>& values) noexcept {
    for (std::int8_t& value : values) {
      value = take<std::int8_t>();
    }
  }

 private:
  std::span<const FieldSpec> fields_;
  std::size_t next_ = 0;
  std::uint64_t bits_ = 0;
  Identified identified_;
  bool fits_ = false;
};

}  // namespace

Frame encode(const Profile& profile, const EmergencyStop& message) noexcept {
  return FieldWriter(profile, MessageKind::emergency_stop).put(static_cast<int>(message.mode)).frame();
}

Frame encode(const Profile& profile, const UserCommand& message) noexcept {
  return FieldWriter(profile, MessageKind::user_command)
      .put(message.node)
      .put(message.target_count)
      .put(message.duration_slots)
      .frame();
}

Frame encode(const Profile& profile, const Sync& message) noexcept {
  return FieldWriter(profile, MessageKind::sync)
      .put(message.cycle)
      .put(message.slot)
      .put(message.batch_committed ? 1 : 0)
      .put(message.toggle ? 1 : 0)
      .put(message.softness)
      .put(message.tail_points)
      .put(message.tail_toggle ? 1 : 0)
      .frame();
}

Frame encode(const Profile& profile, const Trim& message) noexcept {
  FieldWriter writer(profile, MessageKind::trim);
  return writer.put_all(message.count).frame();
}

Frame encode(const Profile& profile, const Feedback& message) noexcept {
  return FieldWriter(profile, MessageKind::feedback, message.node)
      .put(message.position)
      .put(message.current)
      .put(message.reference_low)
      .put(message.executing_toggle ? 1 : 0)
      .put(message.pending_toggle ? 1 : 0)
      .put(static_cast<int>(message.state))
      .put(message.channel[0])
      .put(message.channel[1])
      .frame();
}

Frame encode(const Profile& profile, const FaultReport& message) noexcept {
  return FieldWriter(profile, MessageKind::fault_report, message.node).put(message.faults).frame();
}

Frame encode(const Profile& profile, const Trajectory& message) noexcept {
  FieldWriter writer(profile, MessageKind::trajectory, message.node, message.toggle);
  return writer.put_all(message.delta).frame();
}

Frame encode(const Profile& profile, const Resynchronisation& message) noexcept {
  FieldWriter writer(profile, MessageKind::resynchronisation, message.node);
  writer.put(message.count).put(message.slot).put(message.toggle ? 1 : 0);
  return writer.put_all(message.delta).frame();
}

Frame encode(const Profile& profile, const Heartbeat& message) noexcept {
  return FieldWriter(profile, MessageKind::heartbeat).put(message.mode).put(message.cycle).frame();
}

Frame encode(const Profile& profile, const Tail& message) noexcept {
  FieldWriter writer(profile, MessageKind::tail, message.node, message.toggle, message.part);
  return writer.put_all(message.delta).frame();
}

std::optional<EmergencyStop> decode_emergency_stop(const Profile& profile, const Frame& frame) noexcept {
  FieldReader reader(profile, frame, MessageKind::emergency_stop);
  const auto mode = reader.take<std::uint8_t>();
  if (!reader.fits() || mode > static_cast<std::uint8_t>(StopMode::release)) {
    return std::nullopt;
  }
  return EmergencyStop{static_cast<StopMode>(mode)};
}

std::optional<UserCommand> decode_user_command(const Profile& profile, const Frame& frame) noexcept {
  FieldReader reader(profile, frame, MessageKind::user_command);
  UserCommand message;
  message.node = reader.take<NodeId>();
  message.target_count = reader.take<std::int16_t>();
  message.duration_slots = reader.take<std::uint8_t>();
  // Node 0 is all of them: the emergency stop of a profile that has no message of its own for it.
  const bool stop = message.node == 0 && !profile.has(MessageKind::emergency_stop) &&
                    message.target_count >= static_cast<int>(StopMode::hold) &&
                    message.target_count <= static_cast<int>(StopMode::release);
  if (!reader.fits() || (message.node == 0 && !stop) || message.node > profile.largest_node) {
    return std::nullopt;
  }
  return message;
}

std::optional<Sync> decode_sync(const Profile& profile, const Frame& frame) noexcept {
  FieldReader reader(profile, frame, MessageKind::sync);
  if (!reader.fits()) {
    return std::nullopt;
  }
  Sync message;
  message.cycle = reader.take<std::uint16_t>();
  message.slot = reader.take<std::uint8_t>();
  message.batch_committed = reader.take<bool>();
  message.toggle = reader.take<bool>();
  message.softness = reader.take<std::uint8_t>();
  message.tail_points = reader.take<std::uint8_t>();
  message.tail_toggle = reader.take<bool>();
  if (message.tail_points > kTailPoints) {
    return std::nullopt;
  }
  return message;
}

std::optional<Trim> decode_trim(const Profile& profile, const Frame& frame) noexcept {
  FieldReader reader(profile, frame, MessageKind::trim);
  if (!reader.fits()) {
    return std::nullopt;
  }
  Trim message;
  reader.take_all(message.count);
  return message;
}

std::optional<Feedback> decode_feedback(const Profile& profile, const Frame& frame) noexcept {
  FieldReader reader(profile, frame, MessageKind::feedback);
  if (!reader.fits()) {
    return std::nullopt;
  }
  Feedback message;
  message.node = reader.identified().node;
  message.position = reader.take<std::int16_t>();
  message.current = reader.take<std::int8_t>();
  message.reference_low = reader.take<std::uint8_t>();
  message.executing_toggle = reader.take<bool>();
  message.pending_toggle = reader.take<bool>();
  message.state = static_cast<JointState>(reader.take<std::uint8_t>());
  message.channel[0] = reader.take<std::int16_t>();
  message.channel[1] = reader.take<std::int16_t>();
  return message;
}

std::optional<FaultReport> decode_fault_report(const Profile& profile, const Frame& frame) noexcept {
  FieldReader reader(profile, frame, MessageKind::fault_report);
  if (!reader.fits()) {
    return std::nullopt;
  }
  return FaultReport{reader.identified().node, reader.take<std::uint8_t>()};
}

std::optional<Trajectory> decode_trajectory(const Profile& profile, const Frame& frame) noexcept {
  FieldReader reader(profile, frame, MessageKind::trajectory);
  if (!reader.fits()) {
    return std::nullopt;
  }
  Trajectory message;
  message.node = reader.identified().node;
  message.toggle = reader.identified().toggle;
  reader.take_all(message.delta);
  return message;
}

std::optional<Resynchronisation> decode_resynchronisation(const Profile& profile,
                                                          const Frame& frame) noexcept {
  FieldReader reader(profile, frame, MessageKind::resynchronisation);
  if (!reader.fits()) {
    return std::nullopt;
  }
  Resynchronisation message;
  message.node = reader.identified().node;
  message.count = reader.take<std::int16_t>();
  message.slot = reader.take<std::uint8_t>();
  message.toggle = reader.take<bool>();
  reader.take_all(message.delta);
  return message;
}

std::optional<Heartbeat> decode_heartbeat(const Profile& profile, const Frame& frame) noexcept {
  FieldReader reader(profile, frame, MessageKind::heartbeat);
  if (!reader.fits()) {
    return std::nullopt;
  }
  Heartbeat message;
  message.mode = reader.take<std::uint8_t>();
  message.cycle = reader.take<std::uint32_t>();
  return message;
}

std::optional<Tail> decode_tail(const Profile& profile, const Frame& frame) noexcept {
  FieldReader reader(profile, frame, MessageKind::tail);
  if (!reader.fits()) {
    return std::nullopt;
  }
  Tail message;
  message.node = reader.identified().node;
  message.toggle = reader.identified().toggle;
  message.part = reader.identified().part;
  reader.take_all(message.delta);
  return message;
}

}  // namespace gaitway::can
