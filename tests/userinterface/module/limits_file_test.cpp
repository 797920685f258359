// Limits from a file: what may stand there, and that the memory which they allow can be told.
#include "gaitway/api/limits_file.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include "gaitway/input/complaint.hpp"
#include "gaitway/process/private_folder.hpp"

namespace gaitway::api {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class LimitsFile : public testing::Test {
 protected:
  Limits read(const std::string& text) {
    std::ofstream(file_) << text;
    return read_limits(file_);
  }
  std::string refusal() {
    try {
      static_cast<void>(read_limits(file_));
    } catch (const input::InputError& error) {
      return error.what();
    }
    return "(read)";
  }
  std::string refusal_of(const std::string& text) {
    std::ofstream(file_) << text;
    return refusal();
  }

  const process::PrivateFolder folder_{"gaitway_limits"};
  const std::filesystem::path file_ = folder_.path() / "limits.yaml";
};

TEST_F(LimitsFile, SetsWhatStandsThere) {
  const Limits limits = read("connections: 100\nlease: 0.5\n");
  EXPECT_EQ(limits.connections, 100U);
  EXPECT_EQ(limits.lease_ns, 500'000'000);
  EXPECT_EQ(limits.message_bytes, Limits{}.message_bytes);
}

TEST_F(LimitsFile, AbsurdNumbersAreRefusedWhereTheyStand) {
  EXPECT_THAT(refusal_of("lease: 1\nconnections: 65537\n"),
              AllOf(HasSubstr(file_.string() + ":2"), HasSubstr("connections"), HasSubstr("'65537'"),
                    HasSubstr("must be 1..65536")));
  EXPECT_THAT(refusal_of("message_bytes: 1073741825\n"), HasSubstr("must be 1..1073741824"));
  EXPECT_THAT(refusal_of("depth: 1001\n"), HasSubstr("must be 1..1000"));
  EXPECT_THAT(refusal_of("connections: 18446744073709551615\n"), HasSubstr("connections"));
}

// All that a file may set at its most; the sum by doubles, which do not overflow.
TEST_F(LimitsFile, MemoryOfTheHighestIsTold) {
  std::string text;
  const Limits shipped;
  visit_limits(shipped, [&text](const LimitRow& row, const auto& value) {
    if constexpr (std::is_same_v<decltype(value), const std::size_t&>) {
      text += std::string(row.name) + ": " + std::to_string(row.highest) + "\n";
    }
  });
  const std::uint64_t most_bytes = most_memory_bytes(read(text));
  const double connection_bytes = kMostOfAKind * (512.0 * 1024.0 + 3.0 * kMostLimitBytes);
  EXPECT_GT(static_cast<double>(most_bytes), connection_bytes);
  EXPECT_LT(static_cast<double>(most_bytes), 1.01 * connection_bytes);
}

TEST_F(LimitsFile, APipeIsRefused) {
  ASSERT_EQ(mkfifo(file_.c_str(), 0600), 0);
  EXPECT_THAT(refusal(), AllOf(HasSubstr(file_.string()), HasSubstr("no regular file")));
}

TEST_F(LimitsFile, IsMissed) {
  EXPECT_THAT(refusal(), HasSubstr("missing"));
}

}  // namespace
}  // namespace gaitway::api
