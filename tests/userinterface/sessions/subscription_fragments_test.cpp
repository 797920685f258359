// Long messages in fragments, for clients that ask for them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <vector>

#include "subscription_fixture.hpp"

namespace gaitway::api {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

// Puts the fragments of one message together again.
std::string reassemble(const std::vector<json>& fragments, std::size_t piece_bytes) {
  std::string whole;
  std::set<std::string> ids;
  for (std::size_t i = 0; i < fragments.size(); ++i) {
    EXPECT_EQ(fragments[i]["op"], "fragment");
    EXPECT_EQ(fragments[i]["num"], i);
    EXPECT_EQ(fragments[i]["total"], fragments.size());
    ids.insert(fragments[i]["id"].get<std::string>());
    const std::string data = fragments[i]["data"];
    EXPECT_LE(data.size(), piece_bytes);
    whole += data;
  }
  EXPECT_THAT(ids, SizeIs(1));
  return whole;
}

TEST_F(SubscriptionTest, LongMessagesComeInFragmentsThatMakeTheWhole) {
  for (const std::size_t piece_bytes : {64U, 65U, 66U, 67U, 100U, 1000U}) {
    std::string text;
    for (int i = 0; i < 600; ++i) {
      text += i % 4 == 0   ? "a\"b\\"
              : i % 4 == 1 ? "\xC3\xA4"
              : i % 4 == 2 ? "\xE2\x82\xAC"
                           : "\xF0\x9F\xA4\x96";
    }
    publish_description(text);
    const auto other = connect("peer");
    other->subscribe("/robot_description", {{"fragment_size", piece_bytes}});
    const json message = json::parse(reassemble(other->receive(), piece_bytes));
    EXPECT_EQ(message["msg"]["data"], text) << piece_bytes;
    EXPECT_EQ(hub.statistics().waiting_bytes, 0U);
  }
}

TEST_F(SubscriptionTest, ShortMessagesAreNotFragmented) {
  client->subscribe("/zmp", {{"fragment_size", 10000}});
  publish(1);
  EXPECT_EQ(client->receive_one()["op"], "publish");
}

TEST_F(SubscriptionTest, AnswersGoBetweenFragments) {
  publish_description(std::string(1000, 'x'));
  client->subscribe("/robot_description", {{"fragment_size", 100}});
  std::vector<json> fragments{json::parse(*client->next_frame()->bytes)};
  client->send({{"op", "dance"}});
  EXPECT_EQ(json::parse(*client->next_frame()->bytes)["op"], "status");
  for (const json& fragment : client->receive()) {
    fragments.push_back(fragment);
  }
  EXPECT_EQ(json::parse(reassemble(fragments, 100))["op"], "publish");
}

TEST_F(SubscriptionTest, CborIsNotFragmented) {
  client->subscribe("/zmp", {{"fragment_size", 64}, {"compression", "cbor"}});
  EXPECT_EQ(client->receive_one()["level"], "warning");
  publish(1);
  EXPECT_EQ(client->receive_one()["op"], "publish");
}

}  // namespace
}  // namespace gaitway::api
