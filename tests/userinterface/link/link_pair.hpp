// Both ends of the link on a simulated wire, with what the tests ask of them again and again.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/link/controller_end.hpp"
#include "gaitway/link/module_end.hpp"
#include "simulated_wire.hpp"

namespace gaitway::link::test {

inline constexpr std::int64_t kMs = facts::kMillisecond_ns;
inline constexpr std::array kChannels{Channel{"small", 40}, Channel{"large", 3000}, Channel{"text", 200}};
inline constexpr std::uint32_t kTableHash = 0x67617901;
// The robot's clock against the module's: nothing may take one for the other.
inline constexpr std::int64_t kRobotAhead_ns = 7'000'000'000'000;

inline Bytes bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}
inline std::string text_of(Bytes bytes) {
  return {bytes.begin(), bytes.end()};
}

inline LinkIdentity module_identity(std::uint64_t boot) {
  return {Role::module, boot, kTableHash, "user_interface"};
}
inline LinkIdentity controller_identity(std::uint64_t boot) {
  return {Role::controller, boot, kTableHash, "main_controller"};
}

// Pumps both ends at every step of the virtual time.
class LinkPair {
 public:
  explicit LinkPair(const LinkSettings& settings = {}, std::int64_t byte_ns = 1000,
                    std::size_t buffer_bytes = 256, std::uint64_t seed = 1)
      : wire(byte_ns, buffer_bytes, seed), settings_(settings) {
    restart_module();
    restart_controller();
  }

  void run(std::int64_t duration_ns, std::int64_t step_ns = kMs) {
    for (const std::int64_t end_ns = now_ns + duration_ns; now_ns < end_ns;) {
      now_ns += step_ns;
      wire.advance(now_ns);
      pump(*module, wire.left(), now_ns);
      pump(*controller, wire.right(), robot_ns());
    }
  }
  void restart_module() {
    module = std::make_unique<ModuleEnd>(module_identity(++boots_), kChannels, settings_);
  }
  void restart_controller() {
    controller = std::make_unique<ControllerEnd>(controller_identity(++boots_), kChannels, settings_);
  }
  [[nodiscard]] std::int64_t robot_ns() const { return now_ns + kRobotAhead_ns; }
  [[nodiscard]] bool open() const { return module->session().open() && controller->session().open(); }

  Submission submit(std::string_view text, std::int64_t validity_ns = 200 * kMs) {
    return module->submit(1, bytes_of(text), module->robot_time_ns(now_ns).value_or(0) + validity_ns, now_ns);
  }
  std::vector<Outcome> outcomes() {
    std::vector<Outcome> all;
    while (const std::optional<Outcome> outcome = module->next_outcome(now_ns)) all.push_back(*outcome);
    return all;
  }

  SimulatedWire wire;
  std::unique_ptr<ModuleEnd> module;
  std::unique_ptr<ControllerEnd> controller;
  std::int64_t now_ns = 0;

 private:
  LinkSettings settings_;
  std::uint64_t boots_ = 100;
};

}  // namespace gaitway::link::test
