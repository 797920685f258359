// Tags are those of the published dictionary; surfaces repeat without a seam.
#include "gaitway/world/picture.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <set>
#include <string>
#include <vector>

namespace gaitway::world {
namespace {

std::string bits_of(int id) {
  std::string text;
  const auto cells = tag_cells(id);
  for (std::size_t row = 1; row + 1 < cells.size(); ++row) {
    for (std::size_t column = 1; column + 1 < cells.size(); ++column) text += cells[row][column] ? '1' : '0';
    text += ' ';
  }
  return text;
}

// As the published pictures of the family show them: tag36_11_00000.png, 00001 and 00586.
TEST(Tag, HasTheBitsOfItsIdentifier) {
  EXPECT_EQ(bits_of(0), "110101 011101 011000 101000 010110 000100 ");
  EXPECT_EQ(bits_of(1), "110110 010111 111100 011000 101101 001001 ");
  EXPECT_EQ(bits_of(586), "111010 000011 101111 100100 101101 110011 ");
}

// Whichever way one of two tags is turned.
TEST(Tag, DiffersFromEachOtherInElevenBits) {
  const auto turned = [](std::string bits) {
    std::string result(bits.size(), ' ');
    for (std::size_t row = 0; row < 6; ++row) {
      for (std::size_t column = 0; column < 6; ++column)
        result[row * 7 + column] = bits[(5 - column) * 7 + row];
    }
    return result;
  };
  std::vector<std::string> bits;
  for (int id = 0; id < kTags; ++id) bits.push_back(bits_of(id));
  for (std::size_t a = 0; a < bits.size(); ++a) {
    std::string as_turned = bits[a];
    for (int quarter = 0; quarter < 4; ++quarter) {
      for (std::size_t b = quarter == 0 ? a + 1 : a; b < bits.size(); ++b) {
        int differ = 0;
        for (std::size_t i = 0; i < as_turned.size(); ++i) differ += as_turned[i] != bits[b][i] ? 1 : 0;
        ASSERT_GE(differ, 11) << a << " and " << b << ", turned by " << quarter << " quarters";
      }
      as_turned = turned(as_turned);
    }
  }
}

TEST(Tag, AllDifferAndHaveABlackBorder) {
  std::set<std::string> seen;
  for (int id = 0; id < kTags; ++id) {
    seen.insert(bits_of(id));
    const auto cells = tag_cells(id);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      EXPECT_FALSE(cells[0][i] || cells[7][i] || cells[i][0] || cells[i][7]) << id;
    }
  }
  EXPECT_EQ(seen.size(), static_cast<std::size_t>(kTags));
}

TEST(Tag, ItsPictureHasAWhiteMarginAndThenTheCells) {
  const Picture picture = picture_of_tag(77);
  ASSERT_EQ(picture.width_px, picture.height_px);
  ASSERT_EQ(picture.rgb.size(), static_cast<std::size_t>(3 * picture.width_px * picture.height_px));
  const int cell_px = picture.width_px / kTagPictureCells;
  const auto cells = tag_cells(77);
  for (int row = 0; row < kTagPictureCells; ++row) {
    for (int column = 0; column < kTagPictureCells; ++column) {
      const bool margin = row == 0 || column == 0 || row > kTagCells || column > kTagCells;
      const bool white =
          margin || cells[static_cast<std::size_t>(row - 1)][static_cast<std::size_t>(column - 1)];
      const int at = (row * cell_px + cell_px / 2) * picture.width_px + column * cell_px + cell_px / 2;
      EXPECT_EQ(picture.rgb[static_cast<std::size_t>(3 * at)] > 128, white) << row << ", " << column;
    }
  }
}

TEST(SurfacePicture, CheckersHaveFourSquares) {
  const Picture picture = picture_of(
      {.kind = Surface::Kind::checker, .colours = {Colour{1, 0, 0}, Colour{0, 0, 1}}, .image = {}});
  const auto red_at = [&](int row, int column) {
    return picture.rgb[static_cast<std::size_t>(3 * (row * picture.width_px + column))];
  };
  const int quarter = picture.width_px / 4;
  EXPECT_EQ(red_at(quarter, quarter), 255);
  EXPECT_EQ(red_at(quarter, 3 * quarter), 0);
  EXPECT_EQ(red_at(3 * quarter, quarter), 0);
  EXPECT_EQ(red_at(3 * quarter, 3 * quarter), 255);
}

TEST(SurfacePicture, NoiseIsOfItsSeedWithinItsColoursAndWithoutASeam) {
  const auto noise = [](std::uint64_t seed) {
    return picture_of({.kind = Surface::Kind::noise,
                       .colours = {Colour{0.2, 0.2, 0.2}, Colour{0.8, 0.8, 0.8}},
                       .seed = seed,
                       .image = {}});
  };
  const Picture picture = noise(3);
  EXPECT_EQ(picture.rgb, noise(3).rgb);
  EXPECT_NE(picture.rgb, noise(4).rgb);
  const auto at = [&](int row, int column) {
    return static_cast<int>(picture.rgb[static_cast<std::size_t>(3 * (row * picture.width_px + column))]);
  };
  int least = 255, most = 0, inside = 0, seam = 0;
  for (int row = 0; row < picture.height_px; ++row) {
    for (int column = 0; column + 1 < picture.width_px; ++column) {
      least = std::min(least, at(row, column));
      most = std::max(most, at(row, column));
      inside = std::max(inside, std::abs(at(row, column + 1) - at(row, column)));
    }
    seam = std::max(seam, std::abs(at(row, 0) - at(row, picture.width_px - 1)));
  }
  EXPECT_GE(least, 51);
  EXPECT_LE(most, 204);
  EXPECT_GT(most - least, 80);
  EXPECT_LE(seam, inside) << "where the repeat begins anew";
}

}  // namespace
}  // namespace gaitway::world
