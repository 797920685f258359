// What every part of the robot must agree on, whoever plans, sends or simulates: the beat of the cycle, what
// the wire holds, gravity. Freestanding: a joint's firmware includes it, too.
#pragma once

#include <cstdint>
#include <numbers>

namespace gaitway::facts {

inline constexpr std::int64_t kMillisecond_ns = 1'000'000;
inline constexpr std::int64_t kSecond_ns = 1'000 * kMillisecond_ns;

// Time slots of 10 ms, eight in a cycle: cycle n starts at n * 80 ms. A batch has one point for each slot.
inline constexpr std::int64_t kSlot_ns = 10 * kMillisecond_ns;
inline constexpr int kSlotsPerCycle = 8;
inline constexpr std::int64_t kCycle_ns = kSlotsPerCycle * kSlot_ns;
inline constexpr double kSlot_s = 0.01;
inline constexpr double kCycle_s = 0.08;

// The bus has 1 Mb/s. Points, trims and currents are signed bytes that hold so many counts either way.
inline constexpr std::int64_t kBitTime_ns = 1'000;
inline constexpr int kLargestByte_counts = 127;
inline constexpr int kTrimChannels = 8;   // signed bytes in the trim frame
inline constexpr int kMostTailParts = 7;  // frames of eight points that follow a joint's batch

inline constexpr double kGravity_m_per_s2 = 9.81;
inline constexpr double kRadPerDegree = std::numbers::pi / 180.0;
inline constexpr double kDegreePerRad = 180.0 / std::numbers::pi;

}  // namespace gaitway::facts
