// The simulation as the sessions reach it: over the simulator's control channel, whose other end `gaitway
// simulator` or `gaitway serve` has.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "gaitway/api/simulation_port.hpp"
#include "gaitway/simulation/control_client.hpp"

namespace gaitway::api {

// Out of `unix:PATH`, as people write where a simulator listens. Throws std::invalid_argument.
[[nodiscard]] std::filesystem::path simulator_socket(std::string_view text);

// For one thread.
class SimulatorPort final : public SimulationPort {
 public:
  // Throws process::SocketError for a path that no socket can have. Connects by itself, now or later.
  explicit SimulatorPort(std::filesystem::path socket) : client_(std::move(socket)) {}

  // Tells it the time, by any clock that does not go back; before whatever is asked of it.
  void step(std::int64_t now_ns) {
    now_ns_ = now_ns;
    client_.step(now_ns);
  }

  std::uint32_t push(const LinkPush& push) override;
  std::uint32_t order(const std::string& json, std::int64_t patience_ns) override;
  std::optional<OrderResult> take_result() override;

 private:
  simulation::ControlClient client_;
  std::int64_t now_ns_ = 0;
};

}  // namespace gaitway::api
