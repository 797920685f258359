// What the writer writes is read; what is damaged is refused by name, or read as far as it goes.
#include "gaitway/api/mcap_reader.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "gaitway/api/mcap_writer.hpp"
#include "gaitway/input/complaint.hpp"

namespace gaitway::api {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class McapReaderTest : public ::testing::Test {
 protected:
  McapReaderTest()
      : file_(std::filesystem::temp_directory_path() / ("gaitway_reader_" + std::to_string(::getpid()))) {
    McapWriter writer(
        ::open(file_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600),
        {{"/a", "std_msgs/msg/String", "string data"}, {"/b", "std_msgs/msg/String", "string data"}},
        {.chunk_bytes = 100});
    for (int i = 0; i < 20; ++i)
      writer.write(static_cast<std::size_t>(i % 2), "text" + std::to_string(i), i, i);
    EXPECT_TRUE(writer.finish());
  }
  ~McapReaderTest() override { std::filesystem::remove(file_); }

  [[nodiscard]] std::string bytes() const {
    std::ifstream in(file_, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void put(const std::string& bytes) const {
    std::ofstream(file_, std::ios::binary | std::ios::trunc) << bytes;
  }
  // How many messages there are; what is wrong is in complaint_.
  std::size_t read() {
    texts_.clear();
    complaint_.clear();
    try {
      complete_ = read_mcap(file_, [this](const McapMessage& message) {
        EXPECT_EQ(message.type, "std_msgs/msg/String");
        EXPECT_EQ(message.encoding, "cdr");
        EXPECT_EQ(message.topic, texts_.size() % 2 == 0 ? "/a" : "/b");
        EXPECT_EQ(message.log_ns, texts_.size());
        texts_.emplace_back(message.data);
      });
    } catch (const input::InputError& error) {
      complaint_ = error.what();
    }
    return texts_.size();
  }

  std::filesystem::path file_;
  std::vector<std::string> texts_;
  std::string complaint_;
  bool complete_ = false;
};

TEST_F(McapReaderTest, GivesWhatWasWrittenInItsOrder) {
  ASSERT_EQ(read(), 20U) << complaint_;
  EXPECT_TRUE(complete_);
  for (std::size_t i = 0; i < 20; ++i) EXPECT_EQ(texts_[i], "text" + std::to_string(i));
}

TEST_F(McapReaderTest, OfAFileThatWasCutOffGivesTheWholeChunks) {
  const std::string whole = bytes();
  std::size_t before = 0;
  for (std::size_t size = 8; size < whole.size(); size += 7) {
    put(whole.substr(0, size));
    const std::size_t count = read();
    EXPECT_EQ(complaint_, "") << size;
    EXPECT_GE(count, before) << size;
    before = count;
  }
  EXPECT_EQ(before, 20U);
}

TEST_F(McapReaderTest, RefusesWhatIsDamagedByNameAndRule) {
  std::string damaged = bytes();
  damaged[damaged.find("text3") + 4] = '8';
  put(damaged);
  (void)read();
  EXPECT_THAT(complaint_, AllOf(HasSubstr(file_.string() + ": "), HasSubstr("its CRC differs")));
  put("no recording");
  EXPECT_EQ(read(), 0U);
  EXPECT_THAT(complaint_, HasSubstr("s no MCAP file"));
  std::filesystem::remove(file_);
  EXPECT_EQ(read(), 0U);
  EXPECT_THAT(complaint_, HasSubstr("annot be read"));
}

}  // namespace
}  // namespace gaitway::api
