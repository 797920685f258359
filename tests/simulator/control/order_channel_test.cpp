// Orders over the control channel: answers at once, later and never, by whom they were given; patience; what
// a paused simulation waits on; and clients that do not read.
#include <gmock/gmock.h>
#include <poll.h>
#include <sys/socket.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "gaitway/process/private_folder.hpp"
#include "gaitway/simulation/control_client.hpp"
#include "gaitway/simulation/control_server.hpp"

namespace gaitway::simulation {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

constexpr std::int64_t kPatience_ns = 10 * facts::kSecond_ns;

class OrderChannelTest : public testing::Test {
 protected:
  [[nodiscard]] std::unique_ptr<ControlServer> new_server(bool takes_orders = true) {
    return std::make_unique<ControlServer>(
        path, [](const Ticket&, const Push&) { return true; },
        takes_orders ? ControlServer::OnOrder([this](const Ticket& ticket, std::string_view order) {
          return carry_out(ticket, order);
        })
                     : nullptr);
  }
  std::optional<std::string> carry_out(const Ticket& ticket, std::string_view order) {
    orders.emplace_back(order);
    if (order == "refuse") {
      throw std::invalid_argument("order is 'refuse', but must be another one");
    }
    if (order == "later") {
      tickets.push_back(ticket);
      return std::nullopt;
    }
    if (order == "replace") {  // the one before is answered out of the one that takes its place
      server->answer(tickets.back(), false, "another one has come");
    }
    return order.starts_with("long") ? std::string(std::stoul(std::string(order.substr(4))), 'x')
                                     : std::string(R"({"time_s": 2.5})");
  }
  std::optional<Answer> answer(ControlClient& asker, int milliseconds = 3) {
    for (int i = 0; i < milliseconds; ++i) {
      server->step();
      now_ns += facts::kMillisecond_ns;
      asker.step(now_ns);
      if (auto result = asker.take_answer()) {
        return result;
      }
    }
    return std::nullopt;
  }
  std::optional<Answer> ask(ControlClient& asker, const std::string& order) {
    asker.order(order, now_ns, kPatience_ns);
    return answer(asker);
  }
  [[nodiscard]] bool awake() const {
    pollfd wake{server->wake_fd(), POLLIN, 0};
    return poll(&wake, 1, 0) > 0;
  }

  process::PrivateFolder folder{"gaitway_order_test"};
  std::filesystem::path path = folder.path() / "simulation.sock";
  std::vector<std::string> orders;
  std::vector<Ticket> tickets;
  std::unique_ptr<ControlServer> server = new_server();
  std::int64_t now_ns = facts::kSecond_ns;
};

TEST_F(OrderChannelTest, AnOrderIsAnsweredWithItsJsonOrRefusedWithTheReason) {
  ControlClient client(path);
  const std::uint32_t number = client.order(R"({"order": "state"})", now_ns, kPatience_ns);
  const auto done = answer(client);
  ASSERT_TRUE(done);
  EXPECT_TRUE(done->accepted);
  EXPECT_EQ(done->number, number);
  EXPECT_EQ(done->text, R"({"time_s": 2.5})");
  const auto refused = ask(client, "refuse");
  ASSERT_TRUE(refused);
  EXPECT_FALSE(refused->accepted);
  EXPECT_THAT(refused->text, HasSubstr("must be another one"));
  EXPECT_THAT(orders, ElementsAre(R"({"order": "state"})", "refuse"));
  EXPECT_THROW(client.order("", now_ns, kPatience_ns), std::invalid_argument);
  EXPECT_THROW(client.order(std::string(kMostBodyBytes + 1, ' '), now_ns, kPatience_ns),
               std::invalid_argument);
}

TEST_F(OrderChannelTest, WhoTakesPushesAloneSaysWhoTakesOrders) {
  server.reset();
  server = new_server(false);
  ControlClient client(path);
  const auto refused = ask(client, "{}");
  ASSERT_TRUE(refused);
  EXPECT_FALSE(refused->accepted);
  EXPECT_THAT(refused->text, HasSubstr("takes pushes alone: `gaitway simulator` takes orders"));
}

TEST_F(OrderChannelTest, AnAnswerMayComeLaterAndInAnyOrder) {
  ControlClient client(path), other(path);
  const std::uint32_t seek = client.order("later", now_ns, kPatience_ns);
  EXPECT_FALSE(answer(client));
  other.order("later", now_ns, kPatience_ns);
  EXPECT_FALSE(answer(other));
  EXPECT_TRUE(ask(client, "{}")) << "what comes later keeps nobody";
  ASSERT_THAT(tickets, SizeIs(2));
  EXPECT_NE(tickets[0].client, tickets[1].client);
  server->answer(tickets[0], true, R"({"time_s": 1})");
  server->answer(tickets[0], true, "twice");
  const auto done = answer(client);
  ASSERT_TRUE(done);
  EXPECT_EQ(done->number, seek);
  EXPECT_EQ(done->text, R"({"time_s": 1})");
  EXPECT_FALSE(answer(client)) << "one answer for each";
  server->answer(tickets[1], false, "it cannot be done");
  const auto refused = answer(other);
  ASSERT_TRUE(refused);
  EXPECT_FALSE(refused->accepted);
  EXPECT_EQ(refused->text, "it cannot be done");
}

TEST_F(OrderChannelTest, AnOrderMayAnswerAnother) {
  ControlClient client(path);
  const std::uint32_t first = client.order("later", now_ns, kPatience_ns);
  EXPECT_FALSE(answer(client));
  client.order("replace", now_ns, kPatience_ns);
  const auto replaced = answer(client);
  ASSERT_TRUE(replaced);
  EXPECT_EQ(replaced->number, first);
  EXPECT_FALSE(replaced->accepted);
  const auto done = answer(client);
  ASSERT_TRUE(done);
  EXPECT_TRUE(done->accepted);
}

TEST_F(OrderChannelTest, TheAnswerToAClientThatHasGoneIsNobodys) {
  auto client = std::make_unique<ControlClient>(path);
  client->order("later", now_ns, kPatience_ns);
  EXPECT_FALSE(answer(*client));
  client.reset();
  server->step();
  EXPECT_EQ(server->client_count(), 0U);
  ControlClient next(path);
  next.order("later", now_ns, kPatience_ns);  // under the same number
  EXPECT_FALSE(answer(next));
  ASSERT_THAT(tickets, SizeIs(2));
  EXPECT_EQ(tickets[0].number, tickets[1].number);
  server->answer(tickets[0], true, "of the first");
  EXPECT_FALSE(answer(next));
  server->answer({.client = 99, .number = 1}, true, "of nobody");
  server->answer(tickets[1], true, "of the second");
  const auto done = answer(next);
  ASSERT_TRUE(done);
  EXPECT_EQ(done->text, "of the second");
}

TEST_F(OrderChannelTest, EachOrderHasThePatienceOfWhoGaveIt) {
  ControlClient client(path);
  const std::uint32_t hasty = client.order("later", now_ns, facts::kSecond_ns / 2);
  const std::uint32_t patient = client.order("later", now_ns, kPatience_ns);
  client.step(now_ns + facts::kSecond_ns / 2 - 1);
  EXPECT_FALSE(client.take_answer());
  client.step(now_ns + kPatience_ns - 1);
  auto late = client.take_answer();
  ASSERT_TRUE(late);
  EXPECT_EQ(late->number, hasty);
  EXPECT_FALSE(late->accepted);
  EXPECT_THAT(late->text, HasSubstr("not answered within 0.5 s"));
  EXPECT_FALSE(client.take_answer());
  client.step(now_ns + kPatience_ns);
  late = client.take_answer();
  ASSERT_TRUE(late);
  EXPECT_EQ(late->number, patient);
  EXPECT_THAT(late->text, HasSubstr("not answered within 10 s"));
}

TEST_F(OrderChannelTest, OneClientHasSoManyOpenOrders) {
  ControlClient client(path);
  for (std::size_t i = 0; i < ControlServer::kMostOpen; ++i) {
    client.order("later", now_ns, kPatience_ns);
    EXPECT_FALSE(answer(client, 1));
  }
  const auto refused = ask(client, "later");
  ASSERT_TRUE(refused);
  EXPECT_THAT(refused->text, HasSubstr("64 requests of this client wait"));
  ControlClient other(path);
  EXPECT_TRUE(ask(other, "{}")->accepted) << "that is nobody else's matter";
  server->answer(tickets[0], true, "{}");
  EXPECT_TRUE(answer(client)->accepted);
  client.order("later", now_ns, kPatience_ns);
  EXPECT_FALSE(answer(client));
}

TEST_F(OrderChannelTest, TheLongestAnswerComesAndALongerOneIsRefused) {
  ControlClient client(path);
  const auto whole = ask(client, "long" + std::to_string(kMostTextBytes));
  ASSERT_TRUE(whole);
  EXPECT_TRUE(whole->accepted);
  EXPECT_THAT(whole->text, SizeIs(kMostTextBytes));
  const auto refused = ask(client, "long" + std::to_string(kMostTextBytes + 1));
  ASSERT_TRUE(refused);
  EXPECT_FALSE(refused->accepted);
  EXPECT_THAT(refused->text, HasSubstr("100001 bytes, but must have at most 100000"));
}

TEST_F(OrderChannelTest, LongAnswersWaitForRoomAndWakeWhoWaitsForIt) {
  constexpr int kAnswers = 20;  // far more than a socket holds
  ControlClient client(path);
  for (int i = 0; i < kAnswers; ++i) {
    client.order("long" + std::to_string(kMostTextBytes), now_ns, kPatience_ns);
  }
  EXPECT_TRUE(awake());
  for (int i = 0; i < kAnswers; ++i) {
    server->step();
  }
  ASSERT_THAT(orders, SizeIs(kAnswers));
  EXPECT_FALSE(awake()) << "there is nothing to do until it reads";
  int answers = 0;
  for (int i = 0; i < 2 * kAnswers && answers < kAnswers; ++i) {
    client.step(now_ns);
    while (const auto one = client.take_answer()) {
      EXPECT_TRUE(one->accepted);
      ++answers;
    }
    EXPECT_TRUE(awake() || answers == kAnswers) << answers;
    server->step();
  }
  EXPECT_EQ(answers, kAnswers);
  EXPECT_FALSE(awake());
}

TEST_F(OrderChannelTest, WakesForClientsOrdersAndEnds) {
  EXPECT_FALSE(awake());
  auto client = std::make_unique<ControlClient>(path);
  client->step(now_ns);
  EXPECT_TRUE(awake());
  server->step();
  EXPECT_FALSE(awake());
  client->order("{}", now_ns, kPatience_ns);
  EXPECT_TRUE(awake());
  server->step();
  EXPECT_FALSE(awake());
  client.reset();
  EXPECT_TRUE(awake());
  server->step();
  EXPECT_FALSE(awake());
}

TEST_F(OrderChannelTest, WhoDoesNotReadItsLongAnswersIsDroppedAndNobodyElseIs) {
  ControlClient deaf(path), other(path);
  const std::string longest = "long" + std::to_string(kMostTextBytes);
  for (std::size_t i = 0; i <= ControlServer::kMostUnsentBytes / kMostTextBytes + 5; ++i) {
    deaf.order(longest, now_ns, kPatience_ns);  // does read on each order, but not after the last
  }
  other.order("{}", now_ns, kPatience_ns);
  for (int i = 0; i < 30; ++i) {
    server->step();
  }
  EXPECT_EQ(server->client_count(), 1U);
  EXPECT_TRUE(answer(other)->accepted);
  const auto told = answer(deaf, 60);
  ASSERT_TRUE(told);
}

}  // namespace
}  // namespace gaitway::simulation
