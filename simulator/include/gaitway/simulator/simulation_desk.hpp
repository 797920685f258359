// Carries out what local processes ask of a simulation that runs, between two of its milliseconds.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "gaitway/simulation/control_server.hpp"
#include "gaitway/simulator/cosimulation.hpp"
#include "gaitway/simulator/scenario.hpp"

namespace gaitway::simulator {

class SimulationDesk {
 public:
  static constexpr std::size_t kMostPushes = 8;  // at once: more than people have hands, and no flood

  // What was done, as a scenario does it again: it begins in the millisecond that comes next.
  using OnApplied = std::function<void(const ScenarioEvent& event)>;

  // Listens at `socket`; `run` outlives it. Throws process::SocketError.
  SimulationDesk(Cosimulation& run, const std::filesystem::path& socket, OnApplied on_applied);

  // Before each millisecond: some system calls at most, and none of them waits.
  void step() { server_.step(); }

 private:
  // Throws std::invalid_argument: why not.
  void push(const simulation::Push& asked);

  Cosimulation& run_;
  OnApplied on_applied_;
  std::vector<std::int64_t> ends_ns_;  // of the pushes under way
  simulation::ControlServer server_;
};

}  // namespace gaitway::simulator
