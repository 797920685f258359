// `gaitway bus analyze` as a user meets it: numbers, exit codes, complaints.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace gaitway::tools {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class BusAnalyze : public testing::Test {
 protected:
  BusAnalyze() {
    std::string pattern = (std::filesystem::temp_directory_path() / "bus_analyze_XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
  }
  ~BusAnalyze() override { std::filesystem::remove_all(folder_); }
  BusAnalyze(const BusAnalyze&) = delete;
  BusAnalyze& operator=(const BusAnalyze&) = delete;

  [[nodiscard]] std::string text_of(const char* name) const {
    std::ifstream in(folder_ / name);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  // Returns the exit code.
  int run(const std::string& arguments) {
    const std::string line = std::string("cd '") + folder_.string() + "' && " + GAITWAY_COMMAND +
                             " bus analyze " + arguments + " >said 2>complaint";
    const int status = std::system(line.c_str());
    said_ = text_of("said");
    complaint_ = text_of("complaint");
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  int run_with(const std::string& messages, const std::string& arguments) {
    std::ofstream(folder_ / "messages.json") << messages;
    return run("--messages messages.json " + arguments);
  }
  void expect_refused(const std::string& arguments, const std::vector<std::string>& parts) {
    EXPECT_EQ(run(arguments), 1) << arguments << "\n" << said_;
    EXPECT_EQ(said_, "");
    for (const std::string& part : parts) {
      EXPECT_THAT(complaint_, HasSubstr(part));
    }
  }
  // A second entry that is good but for what `change` puts in.
  void expect_entry_refused(const json& change, const std::vector<std::string>& parts) {
    json list = json::parse(kOne);
    json entry = list[0];
    entry["name"] = "second";
    entry["id"] = 2;
    for (const auto& [key, value] : change.items()) {
      entry[key] = value;
      if (value.is_null()) {
        entry.erase(key);
      }
    }
    list.push_back(entry);
    std::ofstream(folder_ / "messages.json") << list;
    expect_refused("--messages messages.json", parts);
    EXPECT_THAT(complaint_, HasSubstr("messages.json: [1]"));
  }

  static constexpr const char* kOne =
      R"([{"name": "one", "id": 1, "bytes": 8, "period_us": 10000, "jitter_us": 0, "deadline_us": 10000}])";
  std::filesystem::path folder_;
  std::string said_, complaint_;
};

// Davis, Burns, Bril, Lukkien 2007, Table 3, in another order than that of priority.
constexpr const char* kCounterExample = R"([
  {"name": "C", "id": 3, "bytes": 7, "period_us": 3500, "jitter_us": 0, "deadline_us": 3250},
  {"name": "A", "id": 1, "bytes": 7, "period_us": 2500.0, "jitter_us": 0.0, "deadline_us": 2500},
  {"name": "B", "id": 2, "bytes": 7, "period_us": 3500, "jitter_us": 0, "deadline_us": 3250}])";

TEST_F(BusAnalyze, PrintsThePublishedCounterExampleAsJsonInTheFilesOrder) {
  EXPECT_EQ(run_with(kCounterExample, "--bit-rate 125000 --json"), 3);
  EXPECT_EQ(json::parse(said_), json::parse(R"([
    {"name": "C", "id": 3, "length_bits": 125, "blocking_us": 0, "worst_response_us": 3500,
     "deadline_us": 3250, "schedulable": false},
    {"name": "A", "id": 1, "length_bits": 125, "blocking_us": 1000, "worst_response_us": 2000,
     "deadline_us": 2500, "schedulable": true},
    {"name": "B", "id": 2, "length_bits": 125, "blocking_us": 1000, "worst_response_us": 3000,
     "deadline_us": 3250, "schedulable": true}])"));
  EXPECT_EQ(run_with(kCounterExample, "--bit-rate 250000 --json"), 0);
}

TEST_F(BusAnalyze, SaysWhatMissesAndThatNoOrderHelps) {
  EXPECT_EQ(run_with(kCounterExample, "--bit-rate 125000"), 3);
  EXPECT_THAT(said_, HasSubstr("-0.250  misses"));
  EXPECT_THAT(said_, HasSubstr("1 of 3 may be missed"));
  EXPECT_THAT(said_, HasSubstr("load             97.1 %"));
  EXPECT_THAT(said_, HasSubstr("best order       none"));
}

TEST_F(BusAnalyze, TakesFractionsOfAMicrosecondExtendedIdentifiersAndFifoQueues) {
  EXPECT_EQ(run_with(R"([
    {"name": "a", "id": 536870911, "extended": true, "bytes": 8, "period_us": 1000.5, "jitter_us": 0.25,
     "deadline_us": 455.25, "fifo": "engine"},
    {"name": "b", "id": 5, "bytes": 8, "period_us": 1e4, "jitter_us": 0, "deadline_us": 10000, "fifo": "engine"},
    {"name": "c", "id": 6, "bytes": 8, "period_us": 10000, "jitter_us": 0, "deadline_us": 10000}])",
                     "--json"),
            0);
  const json list = json::parse(said_);
  EXPECT_EQ(list[0]["length_bits"], 160);
  EXPECT_DOUBLE_EQ(list[0]["worst_response_us"], 430.25);
  EXPECT_DOUBLE_EQ(list[0]["deadline_us"], 455.25);
  EXPECT_DOUBLE_EQ(list[1]["worst_response_us"], 430.0) << "behind the less urgent one";
}

TEST_F(BusAnalyze, AnUnboundedResponseIsNullAndFails) {
  const std::string full = R"([
    {"name": "one", "id": 1, "bytes": 8, "period_us": 250, "jitter_us": 0, "deadline_us": 1e6},
    {"name": "two", "id": 2, "bytes": 8, "period_us": 250, "jitter_us": 0, "deadline_us": 1e6}])";
  EXPECT_EQ(run_with(full, "--json"), 3);
  const json list = json::parse(said_);
  EXPECT_EQ(list[0]["worst_response_us"], 270.0);
  EXPECT_TRUE(list[1]["worst_response_us"].is_null());
  EXPECT_FALSE(list[1]["schedulable"]);
  EXPECT_EQ(run_with(full, ""), 3);
  EXPECT_THAT(said_, HasSubstr("no bound"));
}

TEST_F(BusAnalyze, ErrorsAndJamsAddUp) {
  const auto worst_us = [this](const std::string& options) {
    EXPECT_EQ(run_with(kOne, "--json " + options), 0) << complaint_;
    return json::parse(said_)[0]["worst_response_us"].get<double>();
  };
  EXPECT_EQ(worst_us(""), 135.0);
  EXPECT_EQ(worst_us("--errors burst:2"), 467.0);
  EXPECT_EQ(worst_us("--errors burst:2,interval:300us"), 799.0);
  EXPECT_EQ(worst_us("--errors interval:0.3ms"), 467.0);
  EXPECT_EQ(worst_us("--errors jam:2ms"), 2301.0);
  EXPECT_EQ(worst_us("--jam-ms 2"), 2301.0);
  EXPECT_EQ(worst_us("--errors jam:0.002s,interval:1s --errors burst:1"), 2467.0);
}

TEST_F(BusAnalyze, TheShippedRobotIsProvenInBothProfiles) {
  EXPECT_EQ(run(""), 0) << said_ << complaint_;
  EXPECT_THAT(said_, HasSubstr("profile full, 22 joints, 1000.0 kbit/s, a jam of 2 ms"));
  EXPECT_THAT(said_, HasSubstr("trajectory 22"));
  EXPECT_THAT(said_, HasSubstr("joints that fit"));
  EXPECT_THAT(said_, testing::Not(HasSubstr("best order")));
  EXPECT_EQ(run("--profile paper --json"), 0);
  EXPECT_EQ(json::parse(said_).size(), 25U);
  EXPECT_EQ(run("--profile paper --priorities"), 0);
  EXPECT_THAT(said_, HasSubstr("best order       with these priorities"));
}

TEST_F(BusAnalyze, ARobotIsAskedForWhatARunAsksForUnlessToldOtherwise) {
  const auto feedback_us = [this](const std::string& options) {
    EXPECT_EQ(run("--profile paper --json " + options), 0) << complaint_;
    return json::parse(said_)[12]["worst_response_us"].get<double>();
  };
  EXPECT_EQ(feedback_us("--jitter-ms 0 --jam-ms 0"), 1890.0)
      << "the first, behind 12 trajectories and a frame";
  EXPECT_EQ(feedback_us(""), feedback_us("--jitter-ms 1 --errors jam:2ms"));
  EXPECT_EQ(feedback_us("--jam-ms 0"), feedback_us("--jitter-ms 0 --jam-ms 0") + 1000.0);
  EXPECT_EQ(run("--jam-ms 20"), 3);
}

TEST_F(BusAnalyze, RefusesMessagesThatCannotBe) {
  expect_entry_refused({{"bytes", 9}}, {"'second' bytes = 9: must be a whole number 0..8", "split"});
  expect_entry_refused({{"bytes", 1.5}}, {"bytes = 1.5: must be a whole number"});
  expect_entry_refused({{"bytes", "8"}}, {"bytes = \"8\": must be a whole number"});
  expect_entry_refused({{"jitter_us", -1}}, {"jitter_us = -1: must be a number of microseconds, at least 0"});
  expect_entry_refused({{"period_us", 0}}, {"period_us = 0: must be a number of microseconds, above 0"});
  expect_entry_refused({{"period_us", -5.5}}, {"period_us = -5.5"});
  expect_entry_refused({{"period_us", 1e13}}, {"period_us = 1", "at most 1e+12"});
  expect_entry_refused({{"deadline_us", 0}}, {"deadline_us = 0"});
  expect_entry_refused({{"id", 2048}}, {"id = 2048: must be a whole number 0..2047", "\"extended\": true"});
  expect_entry_refused({{"id", -1}}, {"id = -1"});
  expect_entry_refused({{"id", 1}}, {"id = 1: [0] 'one' has it already"});
  expect_entry_refused({{"extended", 1}}, {"extended = 1: must be true or false"});
  expect_entry_refused({{"name", ""}}, {"name = \"\": must be a text"});
  expect_entry_refused({{"name", nullptr}}, {"name is missing"});
  expect_entry_refused({{"deadline_us", nullptr}}, {"deadline_us is missing"});
  expect_entry_refused({{"period_ms", 10}}, {"key 'period_ms': there is no such key", "'period_us'"});
}

TEST_F(BusAnalyze, RefusesFilesThatAreNoList) {
  expect_refused("--messages nowhere.json", {"nowhere.json: cannot be read"});
  expect_refused("--messages .", {"cannot be read"});
  for (const auto& [text, part] : {std::pair{"", "malformed JSON"},
                                   {"[{\"name\": }]", "line 1, column 11"},
                                   {"{}", "must be a list"},
                                   {"[]", "at least one message"},
                                   {"[1]", "[0]: must be an object"}}) {
    EXPECT_EQ(run_with(text, ""), 1) << text;
    EXPECT_THAT(complaint_, HasSubstr("messages.json"));
    EXPECT_THAT(complaint_, HasSubstr(part));
  }
}

TEST_F(BusAnalyze, RefusesOptionsThatCannotBe) {
  expect_refused("--profile ful", {"'ful'", "full"});
  expect_refused("--jitter-ms -1", {"--jitter-ms -1: must lie between 0"});
  expect_refused("--jam-ms nan", {"--jam-ms nan"});
  expect_refused("--bit-rate 0", {"--bit-rate 0: must lie between 1000 and 1000000"});
  expect_refused("--robot /nowhere", {"/nowhere/robot.urdf"});
  expect_refused("--errors burts:3", {"--errors burts:3: 'burts': there is no such part", "'burst'"});
  expect_refused("--errors burst:0", {"burst = '0': must be a whole number 1..100000"});
  expect_refused("--errors burst:x", {"burst = 'x'"});
  expect_refused("--errors interval:10", {"interval = '10'", "with its unit: ns, us, ms or s"});
  expect_refused("--errors jam:0,4ms",
                 {"jam = '0,4ms'", "with a decimal point, not with a comma", "'0.4ms'"});
  expect_refused("--errors jam:-1ms", {"jam = '-1ms'"});
  expect_refused("--errors jam:1ms,jam:2ms", {"'jam' is there twice"});
  expect_refused("--errors ''", {"--errors : says nothing"});
  expect_refused("--messages x.json --profile full", {"--messages", "--profile"});
  expect_refused("--jiter-ms 1",
                 {"'--jiter-ms': there is no such command or option", "Did you mean '--jitter-ms'?"});
}

}  // namespace
}  // namespace gaitway::tools
