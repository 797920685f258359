// Carries out what local processes ask of a simulation that runs, between two of its milliseconds.
#pragma once

#include <filesystem>
#include <functional>

#include "gaitway/simulation/control_server.hpp"
#include "gaitway/simulator/cosimulation.hpp"
#include "gaitway/simulator/push_taker.hpp"
#include "gaitway/simulator/scenario.hpp"

namespace gaitway::simulator {

class SimulationDesk {
 public:
  // What was done, as a scenario does it again: it begins in the millisecond that comes next.
  using OnApplied = std::function<void(const ScenarioEvent& event)>;

  // Listens at `socket`; `run` outlives it. Throws process::SocketError.
  SimulationDesk(Cosimulation& run, const std::filesystem::path& socket, OnApplied on_applied);

  // Before each millisecond: some system calls at most, and none of them waits.
  void step() { server_.step(); }

 private:
  PushTaker pushes_;
  OnApplied on_applied_;
  simulation::ControlServer server_;
};

}  // namespace gaitway::simulator
