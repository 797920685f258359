// The solids of the simulator's world, read part by part when somebody wants them and they are others than
// before.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "simulation_orders.hpp"
#include "simulator_answers.hpp"

namespace gaitway::api {

class SimulationGeometry {
 public:
  using Then = std::function<void(const std::vector<SolidAnswer>& solids)>;
  static constexpr std::uint32_t kMostSolids = 20'000;  // that are kept

  explicit SimulationGeometry(SimulationOrders& orders) : orders_(orders) {}

  // Calls `then` with the solids of this state, at once or when they have been read; the call fails with the
  // reason when they cannot be. One reading serves all who wait.
  void want(const SimulationCall& call, const StateAnswer& state, Then then) {
    want(call, Version{state.run, state.geometry}, std::move(then));
  }
  // Ends what has waited for too long.
  void step(std::int64_t now_ns);
  void forget(std::uint64_t client);

 private:
  // Another run, which goes on from an earlier instant, counts its geometries on from there.
  struct Version {
    std::uint32_t run = 0, geometry = 0;
    friend bool operator==(const Version&, const Version&) = default;
  };
  struct Waiting {
    SimulationCall call;
    Version version;
    Then then;
  };
  void want(const SimulationCall& call, const Version& version, Then then);
  void read_on();
  void take_part(const GeometryAnswer& part);
  void finish();
  void fail(std::string_view why);

  SimulationOrders& orders_;
  std::optional<Version> version_;  // of solids_
  std::vector<SolidAnswer> solids_;
  bool is_reading_ = false;
  std::uint32_t read_run_ = 0;                  // of who began the reading
  std::optional<std::uint32_t> read_geometry_;  // of read_
  std::vector<SolidAnswer> read_;
  int beginnings_ = 0;  // of this reading
  std::vector<Waiting> waiting_;
};

}  // namespace gaitway::api
