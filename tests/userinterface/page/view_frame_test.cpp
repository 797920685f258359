// The view's frame: what the checked-in layout, documentation and example say, byte by byte.
#include "gaitway/page/view_frame.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <sstream>
#include <string>

namespace gaitway::page {
namespace {

std::string file_text(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(std::string(GAITWAY_SOURCE_DIR) + "/" + file).rdbuf();
  return text.str();
}

std::size_t offset_of(std::string_view name) {
  std::size_t offset = 0;
  for (const ViewRow& row : kViewRows) {
    if (row.name == name) {
      return offset;
    }
    offset += bytes_of(row.type) * row.count;
  }
  throw std::out_of_range(std::string(name));
}

unsigned byte_at(const std::string& frame, std::size_t offset) {
  return static_cast<unsigned char>(frame.at(offset));
}

TEST(ViewFrame, CheckedInLayoutDocumentationAndExampleAreWhatTheTableSays) {
  const std::string remedy =
      " is not up to date. Run ./dev gaitway api document --out docs --web userinterface/web";
  EXPECT_TRUE(file_text("docs/view.md") == view_reference()) << "docs/view.md" << remedy;
  EXPECT_TRUE(file_text("userinterface/web/src/view_layout.ts") == view_layout_ts())
      << "view_layout.ts" << remedy;
  EXPECT_TRUE(file_text("userinterface/web/test/view_golden.json") == view_golden())
      << "view_golden.json" << remedy;
}

TEST(ViewFrame, HasAtMost200BytesWithAsManyJointsAsItKnows) {
  ViewState state;
  state.joint_count = 22;
  EXPECT_EQ(encode_view(state).size(), view_bytes(22));
  state.joint_count = kViewJoints;
  EXPECT_LE(encode_view(state).size(), 200U);
  state.joint_count = 64;
  EXPECT_EQ(encode_view(state).size(), view_bytes(kViewJoints));
}

TEST(ViewFrame, IsLittleEndianAndInItsUnits) {
  ViewState state;
  state.robot_time_s = 66.051;  // 0x00010203 ms
  state.base_place_m = {-0.0002, 0.0};
  const std::string frame = encode_view(state);
  const std::size_t time = offset_of("robot_time");
  EXPECT_EQ(byte_at(frame, time), 0x03U);
  EXPECT_EQ(byte_at(frame, time + 1), 0x02U);
  EXPECT_EQ(byte_at(frame, time + 2), 0x01U);
  EXPECT_EQ(byte_at(frame, time + 3), 0x00U);
  const std::size_t place = offset_of("base_place");
  EXPECT_EQ(byte_at(frame, place), 0xFEU);
  EXPECT_EQ(byte_at(frame, place + 3), 0xFFU);
}

TEST(ViewFrame, WhatIsBeyondARangeIsItsEndAndNeverUnknown) {
  ViewState state;
  state.base_height_m = -1e9;
  state.round_trip_s = 1e9;
  const std::string frame = encode_view(state);
  EXPECT_EQ(byte_at(frame, offset_of("base_height")), 0x01U);  // -32767
  EXPECT_EQ(byte_at(frame, offset_of("base_height") + 1), 0x80U);
  EXPECT_EQ(byte_at(frame, offset_of("round_trip")), 0xFEU);
  EXPECT_EQ(byte_at(frame, offset_of("zmp")), 0x00U);  // unknown: -32768
  EXPECT_EQ(byte_at(frame, offset_of("zmp") + 1), 0x80U);
  EXPECT_EQ(byte_at(frame, offset_of("mode")), 0xFFU);
}

TEST(ViewFrame, CutsALongNameOff) {
  ViewState state;
  state.commander = "a name that is too long for it";
  const std::string frame = encode_view(state);
  EXPECT_EQ(frame.substr(offset_of("commander"), kViewNameBytes), "a name that is t");
}

}  // namespace
}  // namespace gaitway::page
