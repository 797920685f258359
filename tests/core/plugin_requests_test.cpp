// Requests over the memory block: taken, carried out, answered, also with a second thread for what takes
// time.
#include "gaitway/manager/plugin_requests.hpp"

#include <gmock/gmock.h>

#include <cstring>
#include <optional>
#include <thread>

#include "plugin_fixture.hpp"

namespace gaitway::core {
namespace {

using testing::HasSubstr;

class PluginRequestsTest : public PluginFixture {
 protected:
  static PluginRequest request(PluginVerb verb, const std::string& plugin, const std::string& library = {}) {
    PluginRequest result{};
    result.number = 7;
    result.verb = static_cast<std::uint32_t>(verb);
    std::memcpy(result.plugin, plugin.data(), plugin.size());
    std::memcpy(result.library, library.data(), library.size());
    return result;
  }
  // Ticks until the answer is there; `work` stands for the other thread.
  template <class Work>
  PluginAnswer ask(const PluginRequest& wanted, const Work& work) {
    EXPECT_TRUE(writer.push(wanted, 0));
    PluginAnswer answer{};
    for (int i = 0; i < 100'000 && !answers.read(answer); ++i) {
      manager->step(tick(++number));
      requests->step(0);
      work();
    }
    EXPECT_EQ(answer.number, 7U);
    return answer;
  }
  PluginAnswer ask(const PluginRequest& wanted) {
    return ask(wanted, [this] { requests->work(); });
  }
  static std::string text_of(const PluginAnswer& answer) {
    return reinterpret_cast<const char*>(answer.text);
  }
  double value() {
    Correction correction{};
    EXPECT_TRUE(other.read<Correction>("out").read(correction));
    return correction.com_offset[0];
  }

  PluginAnswer ask_over_network(const PluginRequest& wanted) {
    EXPECT_TRUE(network.push(wanted, 0));
    PluginAnswer answer{};
    for (int i = 0; i < 100 && !answers.read(answer); ++i) {
      manager->step(tick(++number));
      requests->step(0);
      requests->work();
    }
    EXPECT_EQ(answer.number, 7U);
    return answer;
  }

  std::unique_ptr<PluginManager> manager = [this] {
    stopped = {"api"};
    return load("  - {name: c, library: counter.so}\n" + relay("r", "from: out, to: copy") +
                "  - {name: api, library: counter.so, isolation: process, sockets: local}\n");
  }();
  std::optional<PluginRequests> requests{std::in_place, client, *manager};
  msgclient::StreamReader<PluginAnswer> answers = other.read_stream<PluginAnswer>("plugin_answer");
  msgclient::QueueWriter<PluginRequest> writer = other.write_queue<PluginRequest>("plugin_request");
  msgclient::QueueWriter<PluginRequest> network = other.write_queue<PluginRequest>("api_plugin_request");
  std::uint32_t number = 0;
};

TEST_F(PluginRequestsTest, ReloadsWithoutLosingACount) {
  const PluginAnswer answer = ask(request(PluginVerb::reload, "c"));
  EXPECT_TRUE(answer.done) << text_of(answer);
  EXPECT_THAT(text_of(answer), HasSubstr("8 bytes of state handed on"));
  EXPECT_EQ(value(), number);
}

TEST_F(PluginRequestsTest, LoadsAndUnloads) {
  const std::size_t before = manager->size();
  EXPECT_TRUE(ask(request(PluginVerb::unload, "r")).done);
  EXPECT_EQ(manager->size(), before - 1);
  const PluginAnswer answer = ask(request(PluginVerb::load, "plain", "plain_c.so"));
  EXPECT_TRUE(answer.done) << text_of(answer);
  EXPECT_EQ(manager->size(), before);
}

// Orders outlive a main controller in the memory block; who asked has long been told that nobody answers.
TEST_F(PluginRequestsTest, WhatWasAskedBeforeItWasThereIsNotCarriedOut) {
  requests.reset();
  for (auto* const queue : {&writer, &network}) {
    EXPECT_TRUE(queue->push(request(PluginVerb::unload, "r"), 0));
  }
  requests.emplace(client, *manager);
  PluginAnswer answer{};
  for (int i = 0; i < 2; ++i) {
    EXPECT_TRUE(answers.read(answer));
    EXPECT_EQ(answer.number, 7U);
    EXPECT_FALSE(answer.done);
    EXPECT_THAT(text_of(answer), HasSubstr("before this main controller was there"));
  }
  const std::size_t before = manager->size();
  for (int i = 0; i < 100; ++i) {
    manager->step(tick(++number));
    requests->step(0);
    requests->work();
  }
  EXPECT_EQ(manager->size(), before);
  EXPECT_FALSE(answers.read(answer));
  EXPECT_TRUE(ask(request(PluginVerb::unload, "r")).done);
}

TEST_F(PluginRequestsTest, SetsALiveParameter) {
  PluginRequest set = request(PluginVerb::set, "c");
  std::strcpy(reinterpret_cast<char*>(set.parameter), "offset");
  std::strcpy(reinterpret_cast<char*>(set.value), "0.5 m");
  EXPECT_TRUE(ask(set).done);
  manager->step(tick(++number));
  EXPECT_EQ(value(), number + 0.5);
}

// As the ABI promises: until the plug-in is destroyed.
TEST_F(PluginRequestsTest, EveryTextThatAPluginInCWasGivenStays) {
  PluginRequest set = request(PluginVerb::set, "keeper");
  std::strcpy(reinterpret_cast<char*>(set.parameter), "words");
  stopped.clear();
  for (const char* const where : {"none", "process"}) {
    requests.reset();
    manager.reset();
    manager = load("  - {name: keeper, library: keeps_texts.so, isolation: " + std::string(where) + "}\n");
    requests.emplace(client, *manager);
    for (const char* const text : {"short", "a text that is longer than fifteen bytes", "short", "other"}) {
      std::strcpy(reinterpret_cast<char*>(set.value), text);
      EXPECT_TRUE(ask(set).done);
    }
    manager->step(tick(++number));
    EXPECT_EQ(manager->events()[manager->events().total() - 1].text(),
              "at first|short|a text that is longer than fifteen bytes|short|other");
  }
}

TEST_F(PluginRequestsTest, RefusesWithAReasonAndChangesNothing) {
  const auto refused = [this](const PluginRequest& wanted) {
    const PluginAnswer answer = ask(wanted);
    EXPECT_FALSE(answer.done);
    return text_of(answer);
  };
  EXPECT_THAT(refused(request(PluginVerb::reload, "d")), HasSubstr("there is no plug-in 'd'"));
  EXPECT_THAT(refused(request(PluginVerb::reload, "c", "other_abi.so")), HasSubstr("ABI"));
  EXPECT_THAT(refused(request(PluginVerb::reload, "c", "throws_in_constructor.so")),
              HasSubstr("no calibration file"));
  EXPECT_THAT(refused(request(PluginVerb::unload, "c")), HasSubstr("nobody writes it"));
  EXPECT_THAT(refused(request(static_cast<PluginVerb>(9), "c")), HasSubstr("no verb 9"));
  EXPECT_EQ(value(), number) << "it went on counting";
}

TEST_F(PluginRequestsTest, DescribesParametersUntilThereIsNoneLeft) {
  PluginRequest describe = request(PluginVerb::describe_parameter, "c");
  const PluginAnswer answer = ask(describe);
  EXPECT_TRUE(answer.done);
  EXPECT_EQ(text_of(answer), "offset\t0\tm\tlive\tadded to the count");
  describe.index = 1;
  EXPECT_THAT(text_of(ask(describe)), HasSubstr("state_version\t1\t"));
  describe.index = 7;
  const PluginAnswer end = ask(describe);
  EXPECT_FALSE(end.done);
  EXPECT_THAT(text_of(end), HasSubstr("'c' has 7 parameters: there is no number 7"));
  const PluginAnswer nobody = ask(request(PluginVerb::describe_parameter, "d"));
  EXPECT_FALSE(nobody.done);
  EXPECT_THAT(text_of(nobody), HasSubstr("there is no plug-in 'd'"));
}

TEST_F(PluginRequestsTest, ServesBothQueuesByTurns) {
  PluginRequest describe = request(PluginVerb::describe_parameter, "c");
  for (std::uint32_t i = 0; i < 6; ++i) {
    describe.number = i < 3 ? 10 + i : 20 + i;
    ASSERT_TRUE((i < 3 ? writer : network).push(describe, 0));
  }
  std::vector<std::uint32_t> order;
  PluginAnswer answer{};
  for (int i = 0; i < 6; ++i) {
    for (int turn = 0; turn < 3; ++turn) {
      requests->step(0);
      requests->work();
    }
    ASSERT_TRUE(answers.read(answer));
    order.push_back(answer.number);
  }
  EXPECT_THAT(order, testing::ElementsAre(10, 23, 11, 24, 12, 25));
}

TEST_F(PluginRequestsTest, OverTheNetworkLibrariesAreNamedWithoutAFolder) {
  const auto refused = [this](const PluginRequest& wanted) {
    const PluginAnswer answer = ask_over_network(wanted);
    EXPECT_FALSE(answer.done);
    return text_of(answer);
  };
  EXPECT_THAT(refused(request(PluginVerb::reload, "c", "/tmp/counter.so")),
              HasSubstr("'/tmp/counter.so': over the network a library is named without its folder"));
  EXPECT_THAT(refused(request(PluginVerb::load, "x/../../evil")),
              HasSubstr("'x/../../evil': over the network"));
  const PluginAnswer answer = ask_over_network(request(PluginVerb::reload, "c", "counter.so"));
  EXPECT_TRUE(answer.done) << text_of(answer);
}

TEST_F(PluginRequestsTest, OverTheNetworkNobodyTakesAwayWhatKeepsTheLink) {
  for (const PluginVerb verb : {PluginVerb::unload, PluginVerb::stop}) {
    const PluginAnswer refused = ask_over_network(request(verb, "api"));
    EXPECT_FALSE(refused.done);
    EXPECT_THAT(text_of(refused),
                HasSubstr("'api' keeps the link over which this came: nothing could bring it "
                          "back from there. On the robot: gaitway ctl plugin " +
                          std::string(verb == PluginVerb::unload ? "unload" : "stop") + " api"));
  }
  const std::size_t before = manager->size();
  EXPECT_TRUE(ask_over_network(request(PluginVerb::unload, "r")).done) << "others may go";
  EXPECT_TRUE(ask(request(PluginVerb::unload, "api")).done) << "and on the robot this one, too";
  EXPECT_EQ(manager->size(), before - 2);
}

TEST_F(PluginRequestsTest, AnotherThreadDoesTheSlowPart) {
  std::thread worker([this] {
    while (requests->wait_for_work()) {
      requests->work();
    }
  });
  for (int i = 0; i < 10; ++i) {
    const PluginAnswer answer = ask(request(PluginVerb::reload, "c"), [] { std::this_thread::yield(); });
    EXPECT_TRUE(answer.done) << text_of(answer);
    EXPECT_EQ(value(), number);
  }
  requests->end_work();
  worker.join();
}

}  // namespace
}  // namespace gaitway::core
