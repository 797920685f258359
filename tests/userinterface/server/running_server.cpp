// The echoing hub, and the thread.
#include "running_server.hpp"

#include <chrono>
#include <deque>
#include <utility>

#include "raw_client.hpp"
#include "websocket_client.hpp"

namespace gaitway::api {
namespace {

constexpr std::size_t kManyBytes = 16 * 1024;
constexpr std::chrono::milliseconds kWork{1};

class EchoSession final : public Session {
 public:
  EchoSession(EchoHub& hub, Connection& connection, bool authorised)
      : hub_(hub), connection_(connection), authorised_(authorised) {
    ++hub_.sessions;
  }
  ~EchoSession() override { --hub_.sessions; }

  void take(std::string_view message, bool binary, std::int64_t wall_ns) override {
    if (message == "age") {  // in ms
      answer(std::to_string(connection_.message_age_ns(wall_ns) / 1'000'000), false);
    } else if (message == "close") {
      answer("one", false);
      answer("two", false);
      connection_.close(1008, "as you wish");
    } else if (message.starts_with("many ")) {
      for (int left = std::stoi(std::string(message.substr(5))); left > 0; --left) {
        answer(std::string(kManyBytes, 'm'), true);
      }
    } else if (message == "hold") {
      hub_.held.release();
      hub_.released.acquire();
    } else if (message == "work") {
      hub_.taken.emplace_back(message);
      const auto begin = std::chrono::steady_clock::now();
      while (std::chrono::steady_clock::now() - begin < kWork) {
      }
    } else if (message.starts_with("urgent") || message.starts_with("emergency")) {
      hub_.taken.emplace_back(message);
    } else {
      answer(std::string(message), binary);
    }
  }
  void take_overtaken(std::string_view message, bool binary, std::int64_t wall_ns) override {
    take(message, binary, wall_ns);
    if (!hub_.taken.empty()) {
      hub_.taken.back().insert(0, "overtaken ");
    }
  }
  [[nodiscard]] Urgency urgency(std::string_view message, bool /*binary*/) const noexcept override {
    return message.starts_with("emergency") ? Urgency::emergency
           : message.starts_with("urgent")  ? Urgency::urgent
                                            : Urgency::none;
  }
  std::optional<Frame> next_frame(std::int64_t /*wall_ns*/) override {
    if (frames_.empty()) {
      return std::nullopt;
    }
    Frame frame = std::move(frames_.front());
    frames_.pop_front();
    return frame;
  }

  [[nodiscard]] bool authorised() const noexcept override { return authorised_; }

 private:
  void answer(std::string text, bool binary) {
    frames_.push_back({std::make_shared<const std::string>(std::move(text)), binary});
    connection_.wake();
  }

  EchoHub& hub_;
  Connection& connection_;
  bool authorised_;
  std::deque<Frame> frames_;
};

}  // namespace

std::unique_ptr<Session> EchoHub::open(Connection& connection, std::string peer, bool authorised,
                                       std::int64_t /*wall_ns*/) {
  if (sessions >= most_sessions) {
    return nullptr;
  }
  opened.push_back({std::move(peer), authorised});
  return std::make_unique<EchoSession>(*this, connection, authorised);
}

void EchoHub::step(std::int64_t /*wall_ns*/) {
  ++steps;
}

ServerOptions local() {
  ServerOptions options;
  options.port = 0;
  return options;
}

RunningServer::RunningServer(ServerOptions options, std::function<void()> before_running)
    : server_(hub_, ServerSetup(std::move(options)),
              {.on_tick = [this](std::int64_t) { look(); },
               .on_poll = {},
               .on_refusals = [this](const std::string& line) { refusals_.push_back(line); }}),
      thread_([this, before_running = std::move(before_running)] {
        if (before_running) {
          before_running();
        }
        server_.run();
      }) {}

RunningServer::~RunningServer() {
  stop();
}

std::vector<std::string> RunningServer::refusals() {
  std::vector<std::string> result;
  await([&](const ServerStatistics&, EchoHub&) {
    result = refusals_;
    return true;
  });
  return result;
}

void RunningServer::stop() {
  if (thread_.joinable()) {
    server_.stop();
    thread_.join();
  }
}

void RunningServer::look() {
  const std::lock_guard lock(mutex_);
  if (condition_ && condition_(server_.statistics(), hub_)) {
    condition_ = nullptr;
    met_.notify_all();
  }
}

void RunningServer::await(Condition condition) {
  std::unique_lock lock(mutex_);
  condition_ = std::move(condition);
  met_.wait(lock, [this] { return !condition_; });
}

void RunningServer::while_held(RawClient& client, const std::function<void()>& meanwhile) {
  client.send(masked_frame(kText, "hold"));
  hold(meanwhile);
}

void RunningServer::while_held(WebSocketClient& client, const std::function<void()>& meanwhile) {
  client.send("hold");
  hold(meanwhile);
}

void RunningServer::hold(const std::function<void()>& meanwhile) {
  hub_.held.acquire();
  meanwhile();
  hub_.released.release();
}

ServerStatistics RunningServer::statistics() {
  if (!thread_.joinable()) {
    return server_.statistics();
  }
  ServerStatistics result;
  await([&](const ServerStatistics& now, EchoHub&) {
    result = now;
    return true;
  });
  return result;
}

}  // namespace gaitway::api
