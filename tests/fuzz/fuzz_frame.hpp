// Frames for fuzz targets: any frame that a bus port can hand over, and any message of a profile.
#pragma once

#include <cstdint>

#include "fuzz_input.hpp"
#include "gaitway/can/frame.hpp"
#include "gaitway/can/messages.hpp"
#include "gaitway/can/profile.hpp"

namespace gaitway::fuzz {

inline const can::Profile& take_profile(Input& input) {
  return input.flag() ? can::kPaperProfile : can::kFullProfile;
}

// Any valid frame: base or extended, data or remote.
inline can::Frame take_frame(Input& input) {
  can::Frame frame;
  const auto format = input.take<std::uint8_t>();
  frame.extended = (format & 1U) != 0;
  frame.remote = (format & 2U) != 0;
  frame.size = static_cast<std::uint8_t>((format >> 4U) % 9);
  frame.id = input.take<std::uint32_t>() & (frame.extended ? can::kLargestExtendedId : can::kLargestId);
  for (std::size_t i = 0; i < frame.size && !frame.remote; ++i) {
    frame.data[i] = input.take<std::uint8_t>();
  }
  return frame;
}

// A frame with an identifier, a format and a length of the profile, and any content; `node` is one that
// exists.
inline can::Frame take_known_frame(Input& input, const can::Profile& profile, can::NodeId node) {
  const auto kind = static_cast<can::MessageKind>(input.choose(can::kMessageKinds));
  const bool toggle = input.flag();
  const auto part = static_cast<int>(input.choose(static_cast<std::size_t>(profile.parts(kind))));
  can::Frame frame{.id = profile.id_of(kind, node, toggle, part), .size = can::layout(kind).size};
  for (std::size_t i = 0; i < frame.size; ++i) {
    frame.data[i] = input.take<std::uint8_t>();
  }
  return frame;
}

}  // namespace gaitway::fuzz
