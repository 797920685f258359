// What the server still does for others, in its thread's own time, between an emergency stop's arrival and
// the robot's port, while others send all that they may over real sockets.
#include <gtest/gtest.h>
#include <pthread.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <ctime>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "gaitway/api/hub.hpp"
#include "gaitway/api/server.hpp"
#include "raw_client.hpp"
#include "recorded_robot.hpp"
#include "running_server.hpp"

namespace gaitway::api {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kTrials = 50;
constexpr double kMost_ms = 10.0;

double time_ms(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

// Notes at which time of the server's thread it was stopped, and answers at once.
class StoppedRobot final : public RecordedRobot {
 public:
  std::optional<std::uint32_t> stop() override { return answered(RecordedRobot::stop()); }
  std::optional<std::uint32_t> emergency_stop(bool soft) override {
    stopped_ms = time_ms(CLOCK_THREAD_CPUTIME_ID);
    stopped = true;
    stopped.notify_one();
    return answered(RecordedRobot::emergency_stop(soft));
  }
  std::atomic<bool> stopped = false;
  double stopped_ms = 0.0;  // once it is stopped

 private:
  std::optional<std::uint32_t> answered(std::optional<std::uint32_t> number) {
    told.clear();
    results.push_back({*number, true, "", {}});
    return number;
  }
};

std::string call(std::string_view service) {
  return masked_frame(kText, R"({"op": "call_service", "service": ")" + std::string(service) + "\"}");
}

// Robot, hub and server, and clients that each send messages of 60 kB, 100 a second or as fast as they are
// taken.
class LoadedServer {
 public:
  explicit LoadedServer(int clients)
      : server_(hub_, ServerSetup(local()),
                {.on_tick = {}, .on_poll = [this](std::int64_t now_ns) { hub_.answer(now_ns); }}),
        serving_([this] { server_.run(); }) {
    constexpr int kSenders = 4;
    for (int sender = 0; sender < kSenders; ++sender) {
      senders_.emplace_back([this, count = clients / kSenders] { send(count); });
    }
  }
  ~LoadedServer() {
    server_.stop();
    serving_.join();
    for (std::thread& sender : senders_) {
      sender.join();
    }
  }
  LoadedServer(const LoadedServer&) = delete;
  LoadedServer& operator=(const LoadedServer&) = delete;

  [[nodiscard]] std::unique_ptr<RawClient> client() const {
    auto client = std::make_unique<RawClient>(server_.port());
    client->open_websocket();
    return client;
  }
  // The longest of many stops; `before` is called before each.
  [[nodiscard]] double longest_ms(const std::function<void()>& before) {
    const auto stopper = client();
    clockid_t server_time{};
    EXPECT_EQ(pthread_getcpuclockid(serving_.native_handle(), &server_time), 0);
    std::vector<double> all_ms;
    for (int trial = 0; trial < kTrials; ++trial) {
      before();
      robot_.stopped = false;
      stopper->send(call("/emergency_stop"));
      // Not before: while this thread waits for a processor, the server works for the others.
      const double begin_ms = time_ms(server_time);
      robot_.stopped.wait(false);
      all_ms.push_back(robot_.stopped_ms - begin_ms);
      static_cast<void>(stopper->receive_frame());
    }
    std::ranges::sort(all_ms);
    std::cout << "median " << all_ms[kTrials / 2] << " ms, longest " << all_ms.back() << " ms\n";
    return all_ms.back();
  }

 private:
  void send(int count) const {
    constexpr std::size_t kBytes = 60'000;
    std::string message = R"({"op": "publish", "topic": "/cmd_vel", "msg": {"data": [)";
    while (message.size() < kBytes) {
      message += "0.123456,";
    }
    const std::string frame = masked_frame(kText, message + "1]}}");
    std::vector<std::unique_ptr<RawClient>> clients;
    for (int i = 0; i < count; ++i) {
      clients.push_back(client());
      clients.back()->send(masked_frame(kText, R"({"op": "set_level", "level": "none"})"));
    }
    for (auto due = Clock::now(); !clients.empty(); due = std::max(due, Clock::now())) {
      std::erase_if(clients, [&](const auto& each) { return !each->send(frame); });
      std::this_thread::sleep_until(due += std::chrono::milliseconds(10));
    }
  }

  StoppedRobot robot_;
  Hub hub_{robot_, {}};
  Server server_;
  std::thread serving_;
  std::vector<std::thread> senders_;
};

TEST(StopUnderLoad, TwentyClientsThatSendAllThatTheyMayDelayNoEmergencyStop) {
  EXPECT_LT(LoadedServer(20).longest_ms([] {}), kMost_ms);
}

TEST(StopUnderLoad, AHundredNeither) {
  EXPECT_LT(LoadedServer(100).longest_ms([] {}), kMost_ms);
}

TEST(StopUnderLoad, FiveHundredStopsOfAnotherClientNeither) {
  constexpr int kStops = 500;
  std::string stops;
  for (int count = 0; count < kStops; ++count) {
    stops += call("/stop");
  }
  LoadedServer server(0);
  // A new one each time, since five hundred are all that a client may send in a second.
  std::unique_ptr<RawClient> flooding;
  EXPECT_LT(server.longest_ms([&] {
    flooding = server.client();
    flooding->send(stops);
  }),
            kMost_ms);
}

}  // namespace
}  // namespace gaitway::api
