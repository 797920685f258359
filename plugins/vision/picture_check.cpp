// A histogram, and a sum over all pixels that two pictures with noise never share.
#include "gaitway/vision/picture_check.hpp"

#include <algorithm>
#include <cstring>

namespace gaitway::vision {
namespace {

constexpr int kFlat = 2;      // grey levels that a dead sensor's pictures have at most between them
constexpr int kDark = 30;     // below which nineteen pixels of twenty lie
constexpr int kBright = 250;  // above which more than half of them lie
constexpr double kTail = 0.05, kSaturated = 0.5;
constexpr int kFrozenAfter = 2;  // repeats

std::uint64_t digest(std::span<const std::uint8_t> picture) noexcept {
  // FNV-1a over words of eight pixels.
  std::uint64_t sum = 14695981039346656037ULL;
  for (std::size_t i = 0; i + 8 <= picture.size(); i += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, picture.data() + i, sizeof word);
    sum = (sum ^ word) * 1099511628211ULL;
  }
  return sum;
}

}  // namespace

PictureFault fault_of(std::span<const std::uint8_t> picture) noexcept {
  std::array<std::uint32_t, 256> count{};
  for (const std::uint8_t grey : picture) ++count[grey];
  int least = 255, most = 0, nineteen_of_twenty = -1;
  std::size_t below = 0, bright = 0;
  for (int grey = 0; grey < 256; ++grey) {
    const std::uint32_t here = count[static_cast<std::size_t>(grey)];
    if (here == 0) continue;
    least = std::min(least, grey);
    most = grey;
    below += here;
    if (grey >= kBright) bright += here;
    if (nineteen_of_twenty < 0 &&
        static_cast<double>(below) >= (1.0 - kTail) * static_cast<double>(picture.size())) {
      nineteen_of_twenty = grey;
    }
  }
  if (most - least <= kFlat && most < kBright) return PictureFault::dead;
  if (nineteen_of_twenty < kDark) return PictureFault::dark;
  if (static_cast<double>(bright) > kSaturated * static_cast<double>(picture.size()))
    return PictureFault::bright;
  return PictureFault::none;
}

PairCheck PictureCheck::check(const PicturePair& pair) noexcept {
  PairCheck found;
  const std::array pictures{pair.left, pair.right};
  for (std::size_t i = 0; i < 2; ++i) {
    found.fault[i] = fault_of(pictures[i]);
    const std::uint64_t now = digest(pictures[i]);
    cameras_[i].repeats = now == cameras_[i].last ? cameras_[i].repeats + 1 : 0;
    cameras_[i].last = now;
    found.frozen[i] = cameras_[i].repeats >= kFrozenAfter;
  }
  return found;
}

}  // namespace gaitway::vision
