// Draws surfaces and tags.
#include "gaitway/world/picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "gaitway/facts/random_stream.hpp"
#include "tag_family.hpp"

namespace gaitway::world {
namespace {

constexpr int kSide_px = 128;
constexpr int kGrains = 32;  // of noise, along a side of the repeat

std::uint8_t byte_of(double share) {
  return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
}

void put(Picture& picture, const Colour& colour) {
  for (const double share : colour) picture.rgb.push_back(byte_of(share));
}

Colour between(const std::array<Colour, 2>& colours, double share) {
  Colour mixed{};
  for (std::size_t i = 0; i < mixed.size(); ++i) {
    mixed[i] = colours[0][i] + share * (colours[1][i] - colours[0][i]);
  }
  return mixed;
}

// Random values on a lattice that repeats, smooth in between.
class Noise {
 public:
  explicit Noise(std::uint64_t seed) {
    facts::RandomStream random(seed, 0x6E6F'6973'65ULL);
    for (double& value : lattice_) value = random.uniform();
  }
  [[nodiscard]] double at(double x, double y) const {
    const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
    const double right = smooth(x - column), down = smooth(y - row);
    const double above = value(column, row) + right * (value(column + 1, row) - value(column, row));
    const double below =
        value(column, row + 1) + right * (value(column + 1, row + 1) - value(column, row + 1));
    return above + down * (below - above);
  }

 private:
  static double smooth(double t) { return t * t * (3.0 - 2.0 * t); }
  [[nodiscard]] double value(int column, int row) const {
    return lattice_[static_cast<std::size_t>(row % kGrains * kGrains + column % kGrains)];
  }
  std::array<double, static_cast<std::size_t>(kGrains) * kGrains> lattice_{};
};

}  // namespace

Picture picture_of(const Surface& surface) {
  if (surface.kind == Surface::Kind::plain) {
    Picture one{.width_px = 1, .height_px = 1, .rgb = {}};
    put(one, surface.colours[0]);
    return one;
  }
  Picture picture{.width_px = kSide_px, .height_px = kSide_px, .rgb = {}};
  const Noise noise(surface.seed);
  for (int row = 0; row < kSide_px; ++row) {
    for (int column = 0; column < kSide_px; ++column) {
      if (surface.kind == Surface::Kind::checker) {
        const bool second = (2 * row / kSide_px + 2 * column / kSide_px) % 2 == 1;
        put(picture, surface.colours[second ? 1 : 0]);
      } else {
        constexpr double kGrainsPerPixel = static_cast<double>(kGrains) / kSide_px;
        put(picture, between(surface.colours, noise.at(column * kGrainsPerPixel, row * kGrainsPerPixel)));
      }
    }
  }
  return picture;
}

std::array<std::array<bool, kTagCells>, kTagCells> tag_cells(int id) noexcept {
  constexpr std::size_t kBits = kTagCells - 2;
  const std::uint64_t word = kTagWords[static_cast<std::size_t>(id)];
  std::array<std::array<bool, kTagCells>, kTagCells> cells{};
  for (std::size_t bit = 0; bit < kBits * kBits; ++bit) {
    cells[1 + bit / kBits][1 + bit % kBits] = ((word >> (kBits * kBits - 1 - bit)) & 1U) != 0;
  }
  return cells;
}

Picture picture_of_tag(int id) {
  constexpr int kCell_px = 16;
  constexpr Colour kBlack{0.05, 0.05, 0.05}, kWhite{0.97, 0.97, 0.97};
  const auto cells = tag_cells(id);
  Picture picture{
      .width_px = kTagPictureCells * kCell_px, .height_px = kTagPictureCells * kCell_px, .rgb = {}};
  for (int row = 0; row < picture.height_px; ++row) {
    for (int column = 0; column < picture.width_px; ++column) {
      const int r = row / kCell_px - 1, c = column / kCell_px - 1;
      const bool margin = r < 0 || c < 0 || r >= kTagCells || c >= kTagCells;
      const bool white = margin || cells[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)];
      put(picture, white ? kWhite : kBlack);
    }
  }
  return picture;
}

}  // namespace gaitway::world
