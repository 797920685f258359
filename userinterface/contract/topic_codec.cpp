// One pass over the fields, with a writer or a reader.
#include "gaitway/contract/topic_codec.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "gaitway/msgclient/topics.hpp"

namespace gaitway::contract {
namespace {

constexpr unsigned kGroupBits = 7;
constexpr std::uint8_t kGoesOn = 0x80;
constexpr std::size_t kMostNumberBytes = 10;  // 64 bits in groups of seven

class Writer {
 public:
  explicit Writer(std::span<std::uint8_t> room) noexcept : room_(room) {}
  void byte(std::uint8_t value) noexcept {
    ok_ = ok_ && size_ < room_.size();
    if (ok_) {
      room_[size_++] = value;
    }
  }
  void number(std::uint64_t value) noexcept {
    for (; value >= kGoesOn; value >>= kGroupBits) {
      byte(static_cast<std::uint8_t>(value) | kGoesOn);
    }
    byte(static_cast<std::uint8_t>(value));
  }
  void raw(std::uint64_t bits, unsigned count) noexcept {
    for (unsigned shift = 0; shift < count; shift += 8) {
      byte(static_cast<std::uint8_t>(bits >> shift));
    }
  }
  void real(float value) noexcept { raw(std::bit_cast<std::uint32_t>(value), 32); }
  void real(double value) noexcept { raw(std::bit_cast<std::uint64_t>(value), 64); }
  [[nodiscard]] std::size_t size() const noexcept { return ok_ ? size_ : 0; }

 private:
  std::span<std::uint8_t> room_;
  std::size_t size_ = 0;
  bool ok_ = true;
};

class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) noexcept : bytes_(bytes) {}
  std::uint8_t byte() noexcept {
    ok_ = ok_ && read_ < bytes_.size();
    return ok_ ? bytes_[read_++] : std::uint8_t{0};
  }
  std::uint64_t number() noexcept {
    std::uint64_t value = 0;
    for (unsigned group = 0; group < kMostNumberBytes; ++group) {
      const std::uint8_t next = byte();
      const unsigned shift = group * kGroupBits;
      const std::uint64_t bits = next & (kGoesOn - 1U);
      if (shift > 0 && next == 0) {
        break;  // longer than need be
      }
      if ((bits << shift) >> shift != bits) {
        break;  // beyond 64 bits
      }
      value |= bits << shift;
      if ((next & kGoesOn) == 0) {
        return value;
      }
    }
    refuse();
    return 0;
  }
  std::uint64_t raw(unsigned count) noexcept {
    std::uint64_t bits = 0;
    for (unsigned shift = 0; shift < count; shift += 8) {
      bits |= std::uint64_t{byte()} << shift;
    }
    return bits;
  }
  float real() noexcept { return std::bit_cast<float>(static_cast<std::uint32_t>(raw(32))); }
  double exact_real() noexcept { return std::bit_cast<double>(raw(64)); }
  void refuse() noexcept { ok_ = false; }
  [[nodiscard]] bool ok() const noexcept { return ok_; }
  [[nodiscard]] std::size_t read() const noexcept { return ok_ ? read_ : 0; }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t read_ = 0;
  bool ok_ = true;
};

bool is_real(ScalarType type) noexcept {
  return type == ScalarType::float32_value || type == ScalarType::float64_value;
}
bool is_signed(ScalarType type) noexcept {
  return type == ScalarType::int8_value || type == ScalarType::int16_value ||
         type == ScalarType::int32_value || type == ScalarType::int64_value;
}
bool is_text(const FieldDescriptor& field) noexcept {
  return field.type == ScalarType::uint8_value && field.rank > 0;
}

// Of a field: rows of so many elements. Texts are the rows of the last extent.
struct Rows {
  std::size_t count = 1, elements = 1;
};
Rows rows_of(const FieldDescriptor& field, std::size_t joints) noexcept {
  std::size_t elements = field.elements();
  if (field.rank > 0 && field.extents[0] == kMaxJoints) {
    elements = elements / kMaxJoints * std::min<std::size_t>(joints, kMaxJoints);
  }
  const std::size_t row = is_text(field) ? field.extents[field.rank - 1] : 1;
  const bool cut = is_text(field) && field.rank == 1 && field.extents[0] == kMaxJoints;
  return cut ? Rows{1, elements} : Rows{elements / row, row};
}

std::uint64_t fold(std::int64_t value) noexcept {
  return (static_cast<std::uint64_t>(value) << 1U) ^ static_cast<std::uint64_t>(value >> 63U);
}
std::int64_t unfold(std::uint64_t value) noexcept {
  return static_cast<std::int64_t>(value >> 1U) ^ -static_cast<std::int64_t>(value & 1U);
}

template <class T>
T load(const std::byte* place) noexcept {
  T value{};
  std::memcpy(&value, place, sizeof value);
  return value;
}

// Of whole numbers, `Wide` their widest: of their bytes so many as the type has, the sign spread over the
// rest.
template <class Wide, class One, class Two, class Four>
Wide load_whole(ScalarType type, const std::byte* place) noexcept {
  switch (scalar_size(type)) {
    case 1:
      return load<One>(place);
    case 2:
      return load<Two>(place);
    case 4:
      return load<Four>(place);
    default:
      return load<Wide>(place);
  }
}
std::int64_t load_signed(ScalarType type, const std::byte* place) noexcept {
  return load_whole<std::int64_t, std::int8_t, std::int16_t, std::int32_t>(type, place);
}
std::uint64_t load_unsigned(ScalarType type, const std::byte* place) noexcept {
  return load_whole<std::uint64_t, std::uint8_t, std::uint16_t, std::uint32_t>(type, place);
}

void write_number(Writer& out, ScalarType type, const std::byte* place, bool exact) noexcept {
  if (type == ScalarType::float64_value && exact) {
    out.real(load<double>(place));
  } else if (type == ScalarType::float64_value) {
    out.real(static_cast<float>(load<double>(place)));
  } else if (type == ScalarType::float32_value) {
    out.real(load<float>(place));
  } else {
    out.number(is_signed(type) ? fold(load_signed(type, place)) : load_unsigned(type, place));
  }
}

void read_number(Reader& in, ScalarType type, std::byte* place, bool exact) noexcept {
  if (type == ScalarType::float64_value) {
    const double value = exact ? in.exact_real() : in.real();
    std::memcpy(place, &value, sizeof value);
    return;
  }
  if (type == ScalarType::float32_value) {
    const float value = in.real();
    std::memcpy(place, &value, sizeof value);
    return;
  }
  const std::uint64_t folded = in.number();
  const std::uint64_t bits = is_signed(type) ? static_cast<std::uint64_t>(unfold(folded)) : folded;
  std::memcpy(place, &bits, scalar_size(type));  // of little-endian machines, as topics are
  const std::uint64_t kept = is_signed(type) ? fold(load_signed(type, place)) : load_unsigned(type, place);
  if (kept != folded) {
    in.refuse();  // more than the field holds
  }
}

void write_text(Writer& out, const std::byte* place, std::size_t bytes) noexcept {
  while (bytes > 0 && place[bytes - 1] == std::byte{0}) {
    --bytes;
  }
  out.number(bytes);
  for (std::size_t i = 0; i < bytes; ++i) {
    out.byte(static_cast<std::uint8_t>(place[i]));
  }
}

void read_text(Reader& in, std::byte* place, std::size_t room) noexcept {
  const std::uint64_t bytes = in.number();
  if (bytes > room) {
    in.refuse();
    return;
  }
  for (std::size_t i = 0; i < bytes; ++i) {
    place[i] = std::byte{in.byte()};
  }
  if (bytes > 0 && place[bytes - 1] == std::byte{0}) {
    in.refuse();  // longer than need be
  }
}

}  // namespace

std::size_t TopicCodec::encode(const TypeDescriptor& type, const void* value,
                               std::span<std::uint8_t> room) const noexcept {
  Writer out(room);
  for (const FieldDescriptor& field : type.fields) {
    const Rows rows = rows_of(field, joint_count);
    const std::byte* place = static_cast<const std::byte*>(value) + field.offset;
    for (std::size_t row = 0; row < rows.count; ++row, place += rows.elements * scalar_size(field.type)) {
      if (is_text(field)) {
        write_text(out, place, rows.elements);
      } else {
        write_number(out, field.type, place, exact);
      }
    }
  }
  return out.size();
}

std::size_t TopicCodec::decode(const TypeDescriptor& type, std::span<const std::uint8_t> bytes,
                               void* value) const noexcept {
  std::memset(value, 0, type.size);
  Reader in(bytes);
  for (const FieldDescriptor& field : type.fields) {
    const Rows rows = rows_of(field, joint_count);
    std::byte* place = static_cast<std::byte*>(value) + field.offset;
    for (std::size_t row = 0; row < rows.count && in.ok();
         ++row, place += rows.elements * scalar_size(field.type)) {
      if (is_text(field)) {
        read_text(in, place, rows.elements);
      } else {
        read_number(in, field.type, place, exact);
      }
    }
  }
  return in.read();
}

std::size_t put_number(std::uint64_t number, std::span<std::uint8_t> room) noexcept {
  Writer out(room);
  out.number(number);
  return out.size();
}

std::size_t get_number(std::span<const std::uint8_t> bytes, std::uint64_t& number) noexcept {
  Reader in(bytes);
  number = in.number();
  return in.read();
}

bool all_finite(const TypeDescriptor& type, const void* value) noexcept {
  for (const FieldDescriptor& field : type.fields) {
    const std::byte* place = static_cast<const std::byte*>(value) + field.offset;
    for (std::uint32_t i = 0; is_real(field.type) && i < field.elements();
         ++i, place += scalar_size(field.type)) {
      const bool finite = field.type == ScalarType::float64_value ? std::isfinite(load<double>(place))
                                                                  : std::isfinite(load<float>(place));
      if (!finite) {
        return false;
      }
    }
  }
  return true;
}

std::size_t TopicCodec::most_bytes(const TypeDescriptor& type) const noexcept {
  constexpr std::size_t kMostLengthBytes = 3;  // of a text of at most 2^21 bytes
  std::size_t most = 0;
  for (const FieldDescriptor& field : type.fields) {
    const Rows rows = rows_of(field, joint_count);
    const std::size_t bits = 8 * std::size_t{scalar_size(field.type)};
    const std::size_t of_row = is_text(field)        ? kMostLengthBytes + rows.elements
                               : is_real(field.type) ? (exact ? scalar_size(field.type) : sizeof(float))
                                                     : (bits + kGroupBits - 1) / kGroupBits;
    most += rows.count * of_row;
  }
  return most;
}

}  // namespace gaitway::contract
