// Stations that send numbered frames over a simulated bus, and everything that the bus tells meanwhile.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "gaitway/can/frame.hpp"
#include "gaitway/can/simulated/simulated_bus.hpp"
#include "gaitway/facts/facts.hpp"

namespace gaitway::can {

inline constexpr std::int64_t kBit_ns = facts::kBitTime_ns;

inline Frame numbered_frame(std::uint32_t id, std::uint8_t number = 0, std::uint8_t size = 8) {
  return {id, size, {number, 0x5A, 0x11, 0xC3, 0x00, 0x00, 0x7F, 0xE0}};
}

struct Trace {
  std::vector<SimulatedBus::Delivery> deliveries;
  std::vector<ErrorFrame> errors;
  std::vector<StateChange> changes;

  // Runs the bus up to `until_ns`. `on_delivery` may answer.
  template <class OnDelivery>
  void run(SimulatedBus& bus, std::int64_t until_ns, OnDelivery&& on_delivery) {
    while (const auto delivery = bus.advance(until_ns)) {
      fetch(bus);
      deliveries.push_back(*delivery);
      on_delivery(*delivery);
    }
    fetch(bus);
  }
  void run(SimulatedBus& bus, std::int64_t until_ns) {
    run(bus, until_ns, [](const SimulatedBus::Delivery&) {});
  }

 private:
  void fetch(SimulatedBus& bus) {
    while (const auto error = bus.next_error_frame()) {
      errors.push_back(*error);
    }
    while (const auto change = bus.next_state_change()) {
      changes.push_back(*change);
    }
  }
};

inline void attach(SimulatedBus& bus, int stations) {
  for (int i = 0; i < stations; ++i) {
    bus.attach();
  }
}

}  // namespace gaitway::can
