// The whole chain of a walk, beside MuJoCo alone: mj_step of the same model with the torques that the walk's
// motors gave. One round, as JSON. With a folder it leaves there what others need to do the same.
#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "gaitway/simulator/cosimulation.hpp"
#include "plant_implementation.hpp"
#include "turns.hpp"

namespace gaitway::peers {
namespace {

constexpr std::size_t kTurns = 3;
constexpr std::int64_t kStand_ns = 960'000'000;  // before it walks
constexpr std::int64_t kLongest_s = 600;

std::unique_ptr<simulator::Cosimulation> walk() {
  simulator::CosimulationOptions options;
  options.main_controller.configuration = GAITWAY_CONFIGURATION;
  options.main_controller.plugin_path = {GAITWAY_PLUGINS};
  auto chain = std::make_unique<simulator::Cosimulation>(urdf::load_robot(GAITWAY_HUMANOID22), options);
  chain->apply(
      {static_cast<double>(kStand_ns) * 1e-9, simulator::WalkEvent{.velocity_m_per_s = {0.15, 0.0}}});
  return chain;
}

void advance(simulator::Cosimulation& chain, std::int64_t end_ns) {
  while (chain.now_ns() < end_ns) chain.advance_millisecond();
}

// What the motors give in each step.
class Torques final : public simulator::CosimulationObserver {
 public:
  explicit Torques(const simulator::Cosimulation& chain) : chain_(chain) {}
  void on_frame(const can::SimulatedBus::Delivery&) override {}
  void on_millisecond(std::int64_t) override {
    for (const double torque_Nm : chain_.plant().sensors().motor_torque_Nm) {
      given_Nm_.push_back(static_cast<float>(torque_Nm));
    }
  }
  [[nodiscard]] const std::vector<float>& given_Nm() const noexcept { return given_Nm_; }

 private:
  const simulator::Cosimulation& chain_;
  std::vector<float> given_Nm_;
};

template <class T>
void write(const std::filesystem::path& path, std::span<const T> values) {
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(values.size_bytes()));
  if (!file.flush()) throw std::runtime_error(fmt::format("{}: cannot be written", path.string()));
}

// Model, start and torques, and where the robot is in the end.
void leave(const std::filesystem::path& folder, const simulator::Plant& start, const simulator::Plant& end,
           std::span<const float> torques_Nm) {
  std::filesystem::create_directories(folder);
  const simulator::Plant::Implementation& plant = start.implementation();
  mj_saveModel(plant.model.get(), (folder / "model.mjb").c_str(), nullptr, 0);
  if (!std::filesystem::exists(folder / "model.mjb")) {
    throw std::runtime_error(fmt::format("{}: the model cannot be written", folder.string()));
  }
  write(folder / "start.f64", start.positions());
  write(folder / "end.f64", end.positions());
  write(folder / "torques.f32", torques_Nm);
  write(folder / "velocity_addresses.i32", std::span<const int>(plant.velocity_address));
}

void run(std::int64_t seconds, const char* folder) {
  const std::int64_t end_ns = seconds * 1'000'000'000;
  const auto at_start = walk(), recorded = walk();
  Torques torques(*recorded);
  recorded->observe(&torques);
  advance(*recorded, end_ns);
  if (recorded->plant().fallen()) throw std::runtime_error("the robot fell: nothing can be compared");
  const std::span<const float> given_Nm(torques.given_Nm());
  const std::vector<double> replayed = at_start->plant().replay(given_Nm).positions;
  if (!std::ranges::equal(replayed, recorded->plant().positions())) {
    throw std::runtime_error("MuJoCo alone does not end where the chain does: they did not do the same");
  }
  if (folder != nullptr) leave(folder, at_start->plant(), recorded->plant(), given_Nm);

  std::vector<std::unique_ptr<simulator::Cosimulation>> chains;
  for (std::size_t i = 0; i < kTurns; ++i) chains.push_back(walk());
  std::size_t next = 0;
  const std::vector<double> taken_ns =
      median_turn_ns(kTurns, {[&] { advance(*chains[next++], end_ns); },
                              [&] { static_cast<void>(at_start->plant().replay(given_Nm)); }});
  const auto steps = static_cast<double>(given_Nm.size() / at_start->robot().joints.size());
  const nlohmann::ordered_json result{
      {"steps", steps}, {"chain", {{"ns", taken_ns[0] / steps}}}, {"mj_step", {{"ns", taken_ns[1] / steps}}}};
  fmt::print("{}\n", result.dump(1));
}

}  // namespace
}  // namespace gaitway::peers

int main(int argument_count, char** arguments) {
  const std::int64_t seconds = argument_count > 1 ? std::atoll(arguments[1]) : 0;
  if (argument_count > 3 || seconds < 1 || seconds > gaitway::peers::kLongest_s) {
    fmt::print(stderr, "Usage: chain_peers SECONDS [FOLDER]   (1 to {} s)\n", gaitway::peers::kLongest_s);
    return EXIT_FAILURE;
  }
  try {
    gaitway::peers::run(seconds, argument_count > 2 ? arguments[2] : nullptr);
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    fmt::print(stderr, "chain_peers: {}\n", error.what());
    return EXIT_FAILURE;
  }
}
