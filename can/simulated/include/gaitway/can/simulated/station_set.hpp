// A set of the bus's stations, one bit a station.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace gaitway::can {

class StationSet {
 public:
  static constexpr int kCapacity = 128;  // stations are numbered from 0 to 127

  constexpr StationSet() = default;
  [[nodiscard]] static constexpr StationSet of(int station) noexcept {
    StationSet set;
    set.insert(station);
    return set;
  }
  constexpr void insert(int station) noexcept { word(station) |= bit(station); }
  constexpr void erase(int station) noexcept { word(station) &= ~bit(station); }
  [[nodiscard]] constexpr bool contains(int station) const noexcept {
    return (words_[static_cast<std::size_t>(station) / 64] & bit(station)) != 0;
  }
  [[nodiscard]] constexpr bool empty() const noexcept { return (words_[0] | words_[1]) == 0; }
  [[nodiscard]] constexpr int size() const noexcept {
    return std::popcount(words_[0]) + std::popcount(words_[1]);
  }
  // The lowest number in the set; -1 of an empty one.
  [[nodiscard]] constexpr int lowest() const noexcept {
    return words_[0] != 0   ? std::countr_zero(words_[0])
           : words_[1] != 0 ? 64 + std::countr_zero(words_[1])
                            : -1;
  }
  // In ascending order. The set may change meanwhile: the stations as of the call are visited.
  template <class Visit>
  constexpr void for_each(Visit&& visit) const {
    for (int half = 0; half < 2; ++half) {
      for (std::uint64_t rest = words_[static_cast<std::size_t>(half)]; rest != 0; rest &= rest - 1) {
        visit(half * 64 + std::countr_zero(rest));
      }
    }
  }
  // Those for which `holds`.
  template <class Condition>
  [[nodiscard]] constexpr StationSet where(const Condition& holds) const {
    StationSet some;
    for_each([&](int station) {
      if (holds(station)) {
        some.insert(station);
      }
    });
    return some;
  }

  friend constexpr bool operator==(const StationSet&, const StationSet&) = default;
  friend constexpr StationSet operator&(const StationSet& a, const StationSet& b) noexcept {
    return {a.words_[0] & b.words_[0], a.words_[1] & b.words_[1]};
  }
  friend constexpr StationSet operator|(const StationSet& a, const StationSet& b) noexcept {
    return {a.words_[0] | b.words_[0], a.words_[1] | b.words_[1]};
  }
  // Those of `a` that are not in `b`.
  friend constexpr StationSet operator-(const StationSet& a, const StationSet& b) noexcept {
    return {a.words_[0] & ~b.words_[0], a.words_[1] & ~b.words_[1]};
  }

 private:
  constexpr StationSet(std::uint64_t low, std::uint64_t high) noexcept : words_{low, high} {}
  constexpr std::uint64_t& word(int station) noexcept {
    return words_[static_cast<std::size_t>(station) / 64];
  }
  static constexpr std::uint64_t bit(int station) noexcept {
    return std::uint64_t{1} << (static_cast<unsigned>(station) % 64U);
  }
  std::array<std::uint64_t, 2> words_{};
};

}  // namespace gaitway::can
