// Faults in words, in order of what they hide, and those that take several pairs to tell.
#include "gaitway/vision/fault_watch.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gaitway::vision {
namespace {

// A degree of yaw between the cameras shifts all matches by four pixels of 320; a robot whose attitude is
// known to a degree shifts those of the ground by half a pixel.
constexpr double kShifted_px = 2.0;
constexpr double kAgrees_px = 0.8;
constexpr int kLeastShiftPoints = 1500;
constexpr int kGoodVerdicts = 3;  // in a row, after which a fault is over
constexpr int kBadAlignments = 2, kBadShifts = 5;
// Pairs without a verdict, at 12.5 a second, after which a suspicion is dropped and a fault is over: one
// second and eight.
constexpr int kQuietSuspicion = 12, kQuietFault = 100;

constexpr std::array<std::string_view, 14> kWords{
    "",
    "no pictures come: is the camera connected, and the program that reads it running?",
    "pictures come too late to be of use: is the computer overloaded?",
    "the same picture comes again and again: restart the camera",
    "the left picture is dark: is its lens covered, or the light off?",
    "the right picture is dark: is its lens covered, or the light off?",
    "the left picture is over-exposed: shorten its exposure",
    "the right picture is over-exposed: shorten its exposure",
    "the left camera shows nothing: check its cable",
    "the right camera shows nothing: check its cable",
    "left and right are exchanged: swap the cables",
    "one camera is turned against the other: fix it and run `gaitway calibrate camera`",
    "left and right have too little in common: too dark, blurred, or nothing with texture in view",
    "the pictures are not of the camera file's size: correct size_px, or the camera's mode"};

}  // namespace

std::string_view words_of(Fault fault) noexcept {
  const auto number = static_cast<std::size_t>(fault);
  return number < kWords.size() ? kWords[number] : std::string_view{};
}

Fault fault_of(const PairCheck& check) noexcept {
  constexpr std::array kDead{Fault::left_dead, Fault::right_dead};
  constexpr std::array kDark{Fault::left_dark, Fault::right_dark};
  constexpr std::array kBright{Fault::left_bright, Fault::right_bright};
  for (std::size_t i = 0; i < 2; ++i) {
    if (check.fault[i] == PictureFault::dead) return kDead[i];
  }
  for (std::size_t i = 0; i < 2; ++i) {
    if (check.frozen[i]) return Fault::frozen_pictures;
  }
  for (std::size_t i = 0; i < 2; ++i) {
    if (check.fault[i] == PictureFault::dark) return kDark[i];
    if (check.fault[i] == PictureFault::bright) return kBright[i];
  }
  return Fault::none;
}

void AlignmentWatch::Suspicion::judge(bool bad, int bad_until_it_stands) noexcept {
  quiet = 0;
  if (bad) {
    level = stands ? kGoodVerdicts : level + 1;
    if (!stands && level >= bad_until_it_stands) {
      stands = true;
      level = kGoodVerdicts;
    }
  } else {
    level = std::max(level - 1, 0);
    stands = stands && level > 0;
  }
}

void AlignmentWatch::Suspicion::pass() noexcept {
  if (level > 0 && ++quiet >= (stands ? kQuietFault : kQuietSuspicion)) *this = {};
}

void AlignmentWatch::judge(const Alignment& alignment, const GroundShift& shift) noexcept {
  using Verdict = Alignment::Verdict;
  if (alignment.verdict == Verdict::unknown) {
    exchanged_.pass();
    rows_.pass();
  } else {
    exchanged_.judge(alignment.verdict == Verdict::exchanged, kBadAlignments);
    rows_.judge(alignment.verdict == Verdict::misaligned, kBadAlignments);
  }
  if (shift.points < kLeastShiftPoints || shift.spread_px > kAgrees_px)
    shift_.pass();
  else
    shift_.judge(std::abs(shift.median_px) > kShifted_px, kBadShifts);
}

Fault AlignmentWatch::fault() const noexcept {
  if (exchanged_.stands) return Fault::cameras_exchanged;
  if (rows_.stands || shift_.stands) return Fault::cameras_misaligned;
  return Fault::none;
}

}  // namespace gaitway::vision
