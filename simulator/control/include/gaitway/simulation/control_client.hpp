// The asking side of a simulator's control channel. Passive, told the time, and never waits.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/facts/facts.hpp"
#include "gaitway/process/file_descriptor.hpp"
#include "gaitway/simulation/control_messages.hpp"

namespace gaitway::simulation {

// Connects by itself, and again when the simulator has been started anew. Nothing is sent twice: what was not
// answered is reported as such. Answers come in any order.
class ControlClient {
 public:
  static constexpr std::int64_t kPatience_ns = 2 * facts::kSecond_ns;  // for the answer to a push
  static constexpr std::int64_t kBetweenTries_ns = 50 * facts::kMillisecond_ns;

  // To who listens, or will listen, at `socket`. Throws process::SocketError for a path that none can have.
  explicit ControlClient(std::filesystem::path socket);

  // The number under which take_answer() tells what became of it; never 0. Throws std::invalid_argument, with
  // objection()'s text.
  std::uint32_t push(const Push& push, std::int64_t now_ns);
  // Likewise, of an order that waits for its answer so long: what the simulator has to compute first comes
  // when it is done. Throws std::invalid_argument with objection_to_order()'s text.
  std::uint32_t order(std::string_view json, std::int64_t now_ns, std::int64_t patience_ns);

  // Takes what has come, gives up what has waited too long, connects where there is no connection.
  void step(std::int64_t now_ns);
  [[nodiscard]] std::optional<Answer> take_answer();
  [[nodiscard]] bool connected() const noexcept { return static_cast<bool>(socket_); }

 private:
  struct Waiting {
    std::uint32_t number = 0;
    std::int64_t until_ns = 0;
    std::int64_t patience_ns = 0;
  };
  // The number that the next request bears.
  [[nodiscard]] std::uint32_t next_number() const noexcept {
    return last_number_ == UINT32_MAX ? 1 : last_number_ + 1;
  }
  std::uint32_t ask(const Request& request, std::int64_t now_ns, std::int64_t patience_ns);
  void connect(std::int64_t now_ns);
  void receive();
  void take(Answer answer);
  void disconnect(const std::string& why);
  void refuse(std::uint32_t number, const std::string& why) { answers_.push_back({number, false, why}); }

  std::filesystem::path path_;
  process::FileDescriptor socket_;
  std::optional<std::int64_t> tried_ns_;
  std::string absent_;  // why there is no connection
  std::uint32_t last_number_ = 0;
  Packet packet_ = Packet(kMostAnswerBytes);  // what is being received
  std::vector<Waiting> waiting_;
  std::deque<Answer> answers_;
};

}  // namespace gaitway::simulation
