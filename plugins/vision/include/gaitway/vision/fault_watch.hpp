// What is wrong with the cameras, by name, and for how long it counts after it was found.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/vision/alignment_check.hpp"
#include "gaitway/vision/ground_observer.hpp"
#include "gaitway/vision/picture_check.hpp"

namespace gaitway::vision {

// Numbers as in VisionState.
enum class Fault : std::uint32_t {
  none = vision_state::fault::none,
  no_pictures = vision_state::fault::no_pictures,
  late_pictures = vision_state::fault::late_pictures,
  frozen_pictures = vision_state::fault::frozen_pictures,
  left_dark = vision_state::fault::left_dark,
  right_dark = vision_state::fault::right_dark,
  left_bright = vision_state::fault::left_bright,
  right_bright = vision_state::fault::right_bright,
  left_dead = vision_state::fault::left_dead,
  right_dead = vision_state::fault::right_dead,
  cameras_exchanged = vision_state::fault::cameras_exchanged,
  cameras_misaligned = vision_state::fault::cameras_misaligned,
  few_matches = vision_state::fault::few_matches,
  wrong_size = vision_state::fault::wrong_size
};

// For people: what it is, and what to do.
[[nodiscard]] std::string_view words_of(Fault fault) noexcept;

// Of a pair's own pictures: the first fault that keeps it from giving distances.
[[nodiscard]] Fault fault_of(const PairCheck& check) noexcept;

// How the cameras look at each other is not found in each pair: verdicts are kept until enough of them say
// otherwise, or until there have been none for long. What was suspected wrongly would blind for ever where
// nothing in view can be judged by.
class AlignmentWatch {
 public:
  // One pair that was looked at, with what it says of either.
  void judge(const Alignment& alignment, const GroundShift& shift) noexcept;
  [[nodiscard]] Fault fault() const noexcept;  // that stands
  // Something was odd lately, a fault or not yet: distances are not to be trusted, and the next pair is to be
  // looked at.
  [[nodiscard]] bool is_suspected() const noexcept {
    return exchanged_.level > 0 || rows_.level > 0 || shift_.level > 0;
  }

 private:
  struct Suspicion {
    int level = 0;
    int quiet = 0;  // pairs since the last verdict
    bool stands = false;
    void judge(bool bad, int bad_until_it_stands) noexcept;
    void pass() noexcept;  // a pair without a verdict
  };
  Suspicion exchanged_, rows_, shift_;
};

}  // namespace gaitway::vision
