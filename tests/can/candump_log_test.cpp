// Logs in candump's format: what is written is read back, and what is wrong is named.
#include "gaitway/can/candump_log.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>
#include <random>
#include <sstream>
#include <stdexcept>

namespace gaitway::can {
namespace {

using testing::HasSubstr;

class CandumpLogTest : public testing::Test {
 protected:
  ~CandumpLogTest() override { std::filesystem::remove(file); }
  std::string text() const {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / ("gaitway_candump_" + std::to_string(getpid()) + ".log");
};

std::string error_of(const std::string& line) {
  try {
    parse_candump_line(line);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no error";
}

TEST_F(CandumpLogTest, ALineLooksAsCandumpWritesIt) {
  CandumpWriter writer(file);
  writer.write(1'436'509'053'850'870'999, {0x123, 4, {0xDE, 0xAD, 0xBE, 0xEF}});
  writer.write(1'000, {0x001, 0, {}});
  writer.close();
  EXPECT_EQ(text(), "(1436509053.850870) can0 123#DEADBEEF\n(0.000001) can0 001#\n");
}

TEST_F(CandumpLogTest, RandomFramesAreReadBackToTheMicrosecond) {
  std::mt19937_64 random(2);
  std::vector<LoggedFrame> written;
  CandumpWriter writer(file);
  for (int i = 0; i < 20'000; ++i) {  // more than the buffer holds
    LoggedFrame logged{
        static_cast<std::int64_t>(random() % 2'000'000'000'000'000'000),
        {static_cast<std::uint16_t>(random() % 0x800), static_cast<std::uint8_t>(random() % 9), {}}};
    for (std::size_t byte = 0; byte < logged.frame.size; ++byte) {
      logged.frame.data[byte] = static_cast<std::uint8_t>(random());
    }
    writer.write(logged.time_ns, logged.frame);
    written.push_back(logged);
  }
  writer.close();
  const std::vector<LoggedFrame> read = read_candump_log(file);
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    ASSERT_EQ(read[i].frame, written[i].frame);
    ASSERT_EQ(read[i].time_ns, written[i].time_ns / 1000 * 1000);
  }
}

TEST_F(CandumpLogTest, ALogThatNobodyClosedIsWholeAllTheSame) {
  { CandumpWriter(file).write(1'000, {0x123, 1, {7}}); }
  EXPECT_EQ(text(), "(0.000001) can0 123#07\n");
}

TEST_F(CandumpLogTest, OtherInterfacesAndSmallHexDigitsAreRead) {
  const LoggedFrame logged = parse_candump_line("(0001.500000) vcan.1 7ff#0a0B");
  EXPECT_EQ(logged.time_ns, 1'500'000'000);
  EXPECT_EQ(logged.frame, (Frame{0x7FF, 2, {0x0A, 0x0B}}));
}

TEST_F(CandumpLogTest, EachRuleThatALineBreaksIsNamed) {
  for (const char* line : {"", "x", "(1.000000)can0 123#00", "1.000000 can0 123#00", "(1.000000) 123#00",
                           "(1000000) can0 123#00", "(1.000000) can0 12300", "(1.000000)  123#"}) {
    EXPECT_THAT(error_of(line), HasSubstr("must look like")) << line;
  }
  EXPECT_THAT(error_of("(1.00000) can0 123#00"), HasSubstr("six digits"));
  EXPECT_THAT(error_of("(1.00000x) can0 123#00"), HasSubstr("is not a number"));
  EXPECT_THAT(error_of("(-1.000000) can0 123#00"), HasSubstr("is not a number"));
  EXPECT_THAT(error_of("(9999999999999.000000) can0 123#00"), HasSubstr("at most"));
  EXPECT_THAT(error_of("(1.000000) can0 0123#00"), HasSubstr("three digits"));
  EXPECT_THAT(error_of("(1.000000) can0 40000123#00"), HasSubstr("29 bits"));
  EXPECT_THAT(error_of("(1.000000) can0 800#00"), HasSubstr("11 bits"));
  EXPECT_THAT(error_of("(1.000000) can0 123#0"), HasSubstr("two hexadecimal digits"));
  EXPECT_THAT(error_of("(1.000000) can0 123#000102030405060708"), HasSubstr("0 to 8 bytes"));
  EXPECT_THAT(error_of("(1.000000) can0 123#0G"), HasSubstr("'0G' is not a number"));
  EXPECT_THAT(error_of("(1.000000) can0 123#R9"), HasSubstr("0 to 8 bytes"));
  EXPECT_THAT(error_of("(1.000000) can0 123#Rx"), HasSubstr("'x' is not a number"));
}

TEST_F(CandumpLogTest, ExtendedAndRemoteFramesAndReportsAboutErrorsComeBack) {
  const std::vector<LoggedFrame> all = {
      {1'000, {.id = 0x123, .size = 2, .data = {1, 2}, .extended = true}},
      {2'000, {.id = kLargestExtendedId, .extended = true}},
      {3'000, {.id = 0x123, .size = 8, .remote = true}},
      {4'000, {.id = 0x123, .size = 0, .remote = true}},
      {5'000, {.id = 4, .size = 3, .extended = true, .remote = true}},
      {6'000, {.id = 0x44, .size = 8, .data = {0, 0x10, 0, 0, 0, 0, 7, 9}, .extended = true}, true}};
  {
    CandumpWriter writer(file);
    for (const LoggedFrame& logged : all) {
      if (logged.error) {
        writer.write_error(logged.time_ns, logged.frame.id, logged.frame.data);
      } else {
        writer.write(logged.time_ns, logged.frame);
      }
    }
  }
  EXPECT_EQ(
      text(),
      "(0.000001) can0 00000123#0102\n(0.000002) can0 1FFFFFFF#\n(0.000003) can0 123#R8\n"
      "(0.000004) can0 123#R\n(0.000005) can0 00000004#R3\n(0.000006) can0 20000044#0010000000000709\n");
  const std::vector<LoggedFrame> read = read_candump_log(file);
  ASSERT_EQ(read.size(), all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(read[i].frame, all[i].frame) << i;
    EXPECT_EQ(read[i].error, all[i].error) << i;
  }
}

TEST_F(CandumpLogTest, FileAndLineAreNamed) {
  std::ofstream(file) << "(1.000000) can0 123#00\n\n(1.000000) can0 900#00\n";
  try {
    read_candump_log(file);
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr(file.string() + ":3: the identifier"));
  }
  EXPECT_THROW(read_candump_log(file.string() + ".missing"), std::runtime_error);
  EXPECT_THROW(CandumpWriter("/nonexistent/folder/bus.log"), std::runtime_error);
}

TEST_F(CandumpLogTest, AFolderIsNoLog) {
  EXPECT_THROW(read_candump_log(testing::TempDir()), std::runtime_error);
}

TEST_F(CandumpLogTest, AFullDiskIsReportedWhenTheLogIsClosed) {
  CandumpWriter writer("/dev/full");
  writer.write(0, {0x123, 0, {}});
  try {
    writer.close();
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("/dev/full: could not be written whole"));
  }
  EXPECT_NO_THROW(writer.close()) << "closed";
}

// The log goes on where there is room, and says how much is missing.
TEST_F(CandumpLogTest, AFullDiskCostsLinesAndNeverTheLog) {
  CandumpWriter writer("/dev/full");
  for (int i = 0; i < 5'000; ++i) {  // more than the buffer holds
    writer.write(i * 1'000, {0x123, 0, {}});
  }
  const process::LogCount count = writer.finish();
  EXPECT_EQ(count.lines, 0U);
  EXPECT_EQ(count.lost, 5'000U);
  EXPECT_THAT(writer.error(), HasSubstr("No space left"));
}

TEST_F(CandumpLogTest, InRealTimeEachLineIsOnItsWayAtOnceAndAllArrive) {
  {
    CandumpWriter writer(file, {.in_real_time = true});
    for (int i = 0; i < 1'000; ++i) {
      writer.write(i * 1'000, {0x123, 1, {static_cast<std::uint8_t>(i)}});
    }
    const process::LogCount count = writer.finish();
    EXPECT_EQ(count.lines, 1'000U);
    EXPECT_EQ(count.lost, 0U);
  }
  EXPECT_EQ(read_candump_log(file).size(), 1'000U);
}

TEST_F(CandumpLogTest, TheLineThatAKilledWriterHasLeftInPartIsDropped) {
  std::ofstream(file) << "(0.000001) can0 123#0011\n(0.000002) can0 123#00";
  const std::vector<LoggedFrame> read = read_candump_log(file);
  ASSERT_EQ(read.size(), 1U) << "the second one would be a frame that never was";
  std::ofstream(file) << "(0.000001) can0 123#0011\n(0.0000";
  EXPECT_EQ(read_candump_log(file).size(), 1U);
}

}  // namespace
}  // namespace gaitway::can
