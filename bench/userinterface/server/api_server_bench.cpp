// What many subscribers cost the server's thread: 200 of them at 100 Hz, 2.5 kB a message (target: at most
// half a core, with the kernel's part); and with ten such messages in each period.
#include <arpa/inet.h>
#include <benchmark/benchmark.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "gaitway/api/server.hpp"
#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::api {
namespace {

constexpr std::size_t kSubscribers = 200;
constexpr std::size_t kMessageBytes = 2500;
constexpr double kMeasured_s = 5.0;

// Every subscriber gets every message.
class Broadcast final : public SessionHub {
 public:
  std::unique_ptr<Session> open(Connection& connection, std::string, bool, std::int64_t) override {
    return std::make_unique<Subscriber>(*this, connection);
  }
  void step(std::int64_t) override {}

  void publish(const std::shared_ptr<const std::string>& message) {
    for (Subscriber* const subscriber : subscribers_) {
      subscriber->put(message);
    }
  }
  [[nodiscard]] std::size_t subscribers() const { return subscribers_.size(); }

 private:
  class Subscriber final : public Session {
   public:
    Subscriber(Broadcast& hub, Connection& connection) : hub_(hub), connection_(connection) {
      hub_.subscribers_.push_back(this);
    }
    ~Subscriber() override { std::erase(hub_.subscribers_, this); }
    void take(std::string_view, bool, std::int64_t) override {}
    void take_overtaken(std::string_view, bool, std::int64_t) override {}
    [[nodiscard]] Urgency urgency(std::string_view, bool) const noexcept override { return Urgency::none; }
    std::optional<Frame> next_frame(std::int64_t) override {
      if (next_ == waiting_.size()) {
        waiting_.clear();
        next_ = 0;
        return std::nullopt;
      }
      return Frame{std::move(waiting_[next_++]), false};
    }
    [[nodiscard]] bool authorised() const noexcept override { return true; }
    void put(std::shared_ptr<const std::string> message) {
      waiting_.push_back(std::move(message));
      connection_.wake();
    }

   private:
    Broadcast& hub_;
    Connection& connection_;
    std::vector<std::shared_ptr<const std::string>> waiting_;
    std::size_t next_ = 0;
  };

  std::vector<Subscriber*> subscribers_;
};

process::FileDescriptor subscribe(std::uint16_t port) {
  process::FileDescriptor client(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  sockaddr_in server{};
  server.sin_family = AF_INET;
  server.sin_port = htons(port);
  server.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  constexpr std::string_view kRequest =
      "GET / HTTP/1.1\r\nHost: localhost\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
      "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n";
  if (connect(client.get(), reinterpret_cast<const sockaddr*>(&server), sizeof server) != 0 ||
      send(client.get(), kRequest.data(), kRequest.size(), MSG_NOSIGNAL) < 0) {
    throw std::system_error(errno, std::generic_category(), "subscriber");
  }
  std::array<char, 1024> answer;
  if (recv(client.get(), answer.data(), answer.size(), 0) <= 0) {
    throw std::system_error(errno, std::generic_category(), "subscriber's handshake");
  }
  return client;
}

// Reads all that comes, and answers the server's pings by sending pongs as often.
void read_until(const std::atomic<bool>& end, std::span<const process::FileDescriptor> clients,
                std::atomic<std::uint64_t>& received_bytes) {
  constexpr std::array<char, 6> kPong{'\x8A', '\x80', 0, 0, 0, 0};
  constexpr std::chrono::milliseconds kPongPeriod{300};
  std::vector<pollfd> polled;
  for (const auto& client : clients) {
    polled.push_back({client.get(), POLLIN, 0});
  }
  std::vector<char> buffer(256 * 1024);
  auto pong_due = std::chrono::steady_clock::now();
  while (!end.load(std::memory_order_relaxed)) {
    poll(polled.data(), polled.size(), 100);
    const bool pong = std::chrono::steady_clock::now() >= pong_due;
    pong_due += pong ? kPongPeriod : std::chrono::milliseconds(0);
    for (const pollfd& client : polled) {
      if (pong) {
        static_cast<void>(send(client.fd, kPong.data(), kPong.size(), MSG_NOSIGNAL));
      }
      if ((client.revents & POLLIN) != 0) {
        const ssize_t got = recv(client.fd, buffer.data(), buffer.size(), MSG_DONTWAIT);
        received_bytes += got > 0 ? static_cast<std::uint64_t>(got) : 0;
      }
    }
  }
}

double thread_cpu_s() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

void subscribers_at_100_hz(benchmark::State& state) {
  const auto messages_a_period = state.range(0);
  const auto message = std::make_shared<const std::string>(kMessageBytes, 'x');
  for (auto _ : state) {
    Broadcast hub;
    ServerOptions options;
    options.port = 0;
    std::atomic<bool> end = false;
    std::atomic<std::uint64_t> received_bytes = 0;
    std::optional<double> cpu_at_begin_s;
    std::int64_t begin_ns = 0;
    double cpu_s = 0.0, elapsed_s = 0.0;
    ServerStatistics before, after;
    Server* running = nullptr;
    const auto on_tick = [&](std::int64_t now_ns) {
      if (hub.subscribers() < kSubscribers && !cpu_at_begin_s) {
        return;
      }
      if (!cpu_at_begin_s) {
        cpu_at_begin_s = thread_cpu_s();
        begin_ns = now_ns;
        before = running->statistics();
      }
      elapsed_s = static_cast<double>(now_ns - begin_ns) * 1e-9;
      if (elapsed_s >= kMeasured_s && !end) {
        cpu_s = thread_cpu_s() - *cpu_at_begin_s;
        after = running->statistics();
        end = true;
        running->stop();
      }
      for (auto count = messages_a_period; count > 0 && !end; --count) {
        hub.publish(message);
      }
    };
    Server server(hub, ServerSetup(options), {.on_tick = on_tick, .on_poll = [](std::int64_t) {}});
    running = &server;
    std::thread reading([&] {
      std::vector<process::FileDescriptor> clients;
      for (std::size_t count = 0; count < kSubscribers; ++count) {
        clients.push_back(subscribe(server.port()));
      }
      read_until(end, clients, received_bytes);
    });
    server.run();
    reading.join();
    const auto sent = static_cast<double>(after.messages_out - before.messages_out);
    state.SetIterationTime(cpu_s);
    state.counters["core_percent"] = 100.0 * cpu_s / elapsed_s;
    state.counters["messages/s"] = sent / elapsed_s;
    state.counters["us/message"] = 1e6 * cpu_s / sent;
    state.counters["messages/write"] = sent / static_cast<double>(after.writes - before.writes);
    state.counters["received_MB"] = static_cast<double>(received_bytes) * 1e-6;
    state.counters["dropped"] = static_cast<double>(after.of(Closing::slow) + after.of(Closing::silent));
  }
}
BENCHMARK(subscribers_at_100_hz)
    ->Arg(1)
    ->Arg(10)
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gaitway::api
