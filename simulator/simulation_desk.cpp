// Pushes out of the socket.
#include "gaitway/simulator/simulation_desk.hpp"

#include <utility>

namespace gaitway::simulator {

SimulationDesk::SimulationDesk(Cosimulation& run, const std::filesystem::path& socket, OnApplied on_applied)
    : pushes_(run),
      on_applied_(std::move(on_applied)),
      server_(socket, [this](const simulation::Ticket&, const simulation::Push& asked) {
        on_applied_(pushes_.take(asked));
        return true;
      }) {}

}  // namespace gaitway::simulator
