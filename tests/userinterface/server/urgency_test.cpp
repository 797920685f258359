// What is urgent waits for nobody's work, and each client's work waits for the others' only as long as is
// fair.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "raw_client.hpp"
#include "running_server.hpp"

namespace gaitway::api {
namespace {

std::unique_ptr<RawClient> opened(const RunningServer& server) {
  auto client = std::make_unique<RawClient>(server.port());
  client->open_websocket();
  return client;
}

std::vector<std::unique_ptr<RawClient>> several(const RunningServer& server, int count) {
  std::vector<std::unique_ptr<RawClient>> clients;
  while (count-- > 0) {
    clients.push_back(opened(server));
  }
  return clients;
}

std::string frames(std::string_view message, int times) {
  std::string all;
  for (int count = 0; count < times; ++count) {
    all += masked_frame(kText, message);
  }
  return all;
}

void send(RawClient& client, std::string_view message, int times = 1) {
  client.send(frames(message, times));
}

// What the server has taken, once there is so much of it.
std::vector<std::string> taken(RunningServer& server, std::size_t count) {
  std::vector<std::string> result;
  server.await([&](const ServerStatistics&, EchoHub& hub) {
    result = hub.taken;
    return hub.taken.size() >= count;
  });
  return result;
}

std::ptrdiff_t place_of(std::string_view message, const std::vector<std::string>& all) {
  return std::ranges::find(all, message) - all.begin();
}

TEST(Urgency, AnUrgentMessageWaitsForNoOtherClientsWork) {
  constexpr int kClients = 20, kEach = 8;
  RunningServer server(local());
  const auto holder = opened(server), urgent = opened(server);
  const auto busy = several(server, kClients);
  server.while_held(*holder, [&] {
    for (const auto& client : busy) {
      send(*client, "work", kEach);
    }
    send(*urgent, "urgent");
  });
  EXPECT_LE(place_of("urgent", taken(server, kClients * kEach + 1)), 4);
}

TEST(Urgency, NorDoesTheTenthOfOneClientWhileNobodyElseHasAny) {
  constexpr int kOthers = 8, kUrgent = 9;
  RunningServer server(local());
  const auto holder = opened(server), client = opened(server);
  const auto others = several(server, kOthers);
  server.while_held(*holder, [&] {
    for (const auto& other : others) {
      send(*other, "work", 2);  // so that what the client sends waits
    }
    client->send(frames("urgent", kUrgent) + frames("work", 6) + frames("urgent at last", 1));
  });
  const auto all = taken(server, 2 * kOthers + kUrgent + 7);
  EXPECT_GT(std::ranges::count(all, "overtaken work"), 0)
      << "what it sent before the last one is told that it came too late";
}

TEST(Urgency, AFloodOfUrgentMessagesDelaysNobodyElsesFirst) {
  constexpr int kFlood = 500;
  RunningServer server(local());
  const auto holder = opened(server), flood = opened(server), other = opened(server);
  server.while_held(*holder, [&] {
    send(*flood, "urgent as ever", kFlood);
    send(*other, "urgent");
  });
  EXPECT_LE(place_of("urgent", taken(server, kFlood + 1)), 80);
}

TEST(Urgency, AnEmergencyWaitsForNoUrgentOnesOfItsSender) {
  constexpr int kOthers = 8, kEach = 8, kFlood = 200;
  RunningServer server(local());
  const auto holder = opened(server), client = opened(server);
  const auto others = several(server, kOthers);
  server.while_held(*holder, [&] {
    for (const auto& other : others) {
      send(*other, "work", kEach);  // so that what is not taken at once waits
    }
    client->send(frames("urgent", kFlood) + frames("emergency", 1));
  });
  const auto all = taken(server, kOthers * kEach + kFlood + 1);
  const auto emergency = all.begin() + place_of("emergency", all);
  EXPECT_LT(std::count(all.begin(), emergency, "work"), kOthers * kEach / 2);
  EXPECT_EQ(std::count(emergency, all.end(), "urgent"), 0)
      << "those that waited are told that it overtook them";
#ifndef __SANITIZE_THREAD__  // which reads so slowly that each may be taken before the next has come
  EXPECT_GT(std::ranges::count(all, "overtaken urgent"), kFlood / 4);
#endif
}

TEST(Urgency, WhatItsSenderSentBeforeIsToldThatItCameTooLate) {
  constexpr int kOthers = 8, kBefore = 6;
  RunningServer server(local());
  const auto holder = opened(server), client = opened(server);
  const auto others = several(server, kOthers);
  server.while_held(*holder, [&] {
    for (const auto& other : others) {
      send(*other, "work", 2);  // so that what the client sends waits
    }
    // At once: the client's kernel would keep a second piece back until the first is acknowledged.
    client->send(frames("work", kBefore) + frames("urgent", 1) + frames("work", 1));
  });
  const auto all = taken(server, 2 * kOthers + kBefore + 2);
  EXPECT_GE(std::ranges::count(all, "overtaken work"), kBefore - 2);
  EXPECT_LT(std::ranges::count(all, "overtaken work"), kBefore + 1);
  EXPECT_LT(place_of("urgent", all), place_of("overtaken work", all));
}

TEST(Urgency, AFewWhoSendMuchDelayOthersByTheirShareOnly) {
  constexpr int kClients = 10, kEach = 30;
  RunningServer server(local());
  const auto holder = opened(server), light = opened(server);
  const auto busy = several(server, kClients);
  server.while_held(*holder, [&] {
    for (const auto& client : busy) {
      send(*client, "work", kEach);
    }
  });
  send(*light, "hello");
  EXPECT_EQ(light->receive_frame().value().payload, "hello");
  std::size_t before = 0;
  server.await([&](const ServerStatistics&, EchoHub& hub) {
    before = hub.taken.size();
    return true;
  });
  EXPECT_LT(before, kClients * kEach / 2U);
}

TEST(Urgency, WhatWasSentBeforeAClientWentIsTaken) {
  constexpr int kSent = 100;
  RunningServer server(local());
  const auto holder = opened(server);
  auto client = opened(server);
  server.while_held(*holder, [&] {
    send(*client, "work", kSent);
    client->send(masked_frame(kClose, "\x03\xE8"));
    client.reset();
  });
  EXPECT_EQ(taken(server, kSent).size(), kSent);
  server.await([](const ServerStatistics& statistics, EchoHub& hub) {
    return statistics.connected == 1 && hub.sessions == 1;
  });
}

}  // namespace
}  // namespace gaitway::api
