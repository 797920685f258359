// What a topic's type looks like from outside: its fields, units and frames, and the hash over them by which
// two builds recognise each other.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

namespace gaitway {

enum class ScalarType : std::uint8_t {
  int8_value,
  uint8_value,
  int16_value,
  uint16_value,
  int32_value,
  uint32_value,
  int64_value,
  uint64_value,
  float32_value,
  float64_value,
};

inline constexpr std::size_t kScalarTypes = 10;

// Schema name and bytes of each scalar type.
constexpr std::string_view scalar_name(ScalarType type) noexcept {
  constexpr std::array<std::string_view, kScalarTypes> kNames = {
      "int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64", "float32", "float64"};
  return kNames[static_cast<std::size_t>(type)];
}
constexpr std::uint32_t scalar_size(ScalarType type) noexcept {
  constexpr std::array<std::uint32_t, kScalarTypes> kSizes = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

// One field of a topic's type: scalars, row-major when there is more than one extent.
struct FieldDescriptor {
  std::string_view name;
  ScalarType type;
  std::uint32_t rank;                    // extents in use; 0: a single scalar
  std::array<std::uint32_t, 4> extents;  // first `rank` entries are valid
  std::string_view unit;                 // SI; empty: a plain number
  std::string_view frame;                // empty: no frame
  std::string_view doc;
  std::uint32_t offset;  // bytes from the start of the value
  // What a number of a published value may be; floating-point fields only.
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();

  [[nodiscard]] constexpr std::uint32_t elements() const noexcept {
    std::uint32_t count = 1;
    for (std::uint32_t i = 0; i < rank; ++i) {
      count *= extents[i];
    }
    return count;
  }
};

struct TypeDescriptor {
  std::string_view name;
  std::uint64_t hash;
  std::uint32_t size;  // bytes
  std::span<const FieldDescriptor> fields;
  std::string_view doc;
};

// One of the schema's topics.
struct StandardTopic {
  std::string_view name;
  const TypeDescriptor* type;
  std::string_view writer;
  std::int64_t period_ns;  // 0: written on change
};

// Specialised for every type that may be a topic's: name, hash, fields, descriptor. The generator writes
// these.
template <class T>
struct TopicType;

namespace detail {

class Fnv1a64 {
 public:
  constexpr void add(std::string_view text) noexcept {
    for (const char c : text) {
      value_ = (value_ ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    }
  }
  constexpr void add_number(std::uint32_t number) noexcept {
    if (number >= 10) {
      add_number(number / 10);
    }
    const char digit = static_cast<char>('0' + number % 10);
    add({&digit, 1});
  }
  [[nodiscard]] constexpr std::uint64_t value() const noexcept { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

}  // namespace detail

// FNV-1a 64 over "Name{field:type[extents]|unit|frame;...}". Doc texts and limits
// don't count.
constexpr std::uint64_t type_hash(std::string_view name, std::span<const FieldDescriptor> fields) noexcept {
  detail::Fnv1a64 hash;
  hash.add(name);
  hash.add("{");
  for (const FieldDescriptor& field : fields) {
    hash.add(field.name);
    hash.add(":");
    hash.add(scalar_name(field.type));
    hash.add("[");
    for (std::uint32_t i = 0; i < field.rank; ++i) {
      if (i > 0) {
        hash.add(",");
      }
      hash.add_number(field.extents[i]);
    }
    hash.add("]|");
    hash.add(field.unit);
    hash.add("|");
    hash.add(field.frame);
    hash.add(";");
  }
  hash.add("}");
  return hash.value();
}

}  // namespace gaitway
