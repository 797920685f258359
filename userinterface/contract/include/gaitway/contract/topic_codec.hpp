// A topic's value as it goes over the narrow link: by its type's description, without what is not used.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "gaitway/msgclient/type_descriptor.hpp"

namespace gaitway::contract {

// The value's fields in their order, without gaps:
//
//   float64            float32 (4 bytes); in an exact codec all 8
//   float32            4 bytes
//   whole numbers      in groups of seven bits, the lowest first, the top bit set in all but the last byte;
//                      signed ones folded: 0, -1, 1, -2, ... are 0, 1, 2, 3, ...
//   uint8 arrays       how many until the last that is not 0, then these: texts are as long as they are
//   arrays over joints the robot's joints alone: arrays whose first extent is kMaxJoints
//
// What is decoded is what was encoded but for the rounding of numbers, and for joints that the robot does not
// have: these are 0.
struct TopicCodec {
  std::size_t joint_count = 0;  // the same at both ends
  bool exact = false;           // for orders

  // Into `room`; returns the bytes, 0 when they do not fit. `value`: one of the type.
  std::size_t encode(const TypeDescriptor& type, const void* value,
                     std::span<std::uint8_t> room) const noexcept;
  // Into `value`, all of which is written. Returns the bytes read; 0: they are not a value of the type, and
  // `value` is not to be used.
  std::size_t decode(const TypeDescriptor& type, std::span<const std::uint8_t> bytes,
                     void* value) const noexcept;
  // At most so many bytes.
  [[nodiscard]] std::size_t most_bytes(const TypeDescriptor& type) const noexcept;
};

// A whole number that is not signed, as above. Bytes written, 0 when they do not fit; bytes read, 0 when they
// are none.
std::size_t put_number(std::uint64_t number, std::span<std::uint8_t> room) noexcept;
std::size_t get_number(std::span<const std::uint8_t> bytes, std::uint64_t& number) noexcept;

// Whether every floating-point number of a value is finite.
[[nodiscard]] bool all_finite(const TypeDescriptor& type, const void* value) noexcept;

}  // namespace gaitway::contract
