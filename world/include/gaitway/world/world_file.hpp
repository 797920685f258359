// Reads a world file. docs/simulator.md has the format as a table; in short:
//
//   floor: {friction: 0.8, surface: carpet}
//   start: {position_m: [0, 0], yaw_deg: 90}
//   surfaces:
//     carpet: {noise: [[0.5, 0.4, 0.4], [0.6, 0.5, 0.5]], repeat_m: 0.5, seed: 3}
//   boxes:  [{position_m: [1, 0], size_m: [0.3, 0.2, 0.1], yaw_deg: 30, friction: 0.5, surface: carpet}]
//   steps:  [{position_m: [1, 0], count: 4, rise_m: 0.01, run_m: 0.3, width_m: 1, top_m: 0.8, down: true}]
//   slopes: [{position_m: [1, 0], length_m: 1, rise_m: 0.05, width_m: 1, top_m: 0.5, down: true}]
//   tiles:  [{position_m: [1, 0], size_m: [2, 1], tile_m: 0.1, height_m: 0.005, seed: 3}]
//   walls:  [{from_m: [1, -2], to_m: [1, 2], height_m: 0.5, doors: [{at_m: 2, width_m: 0.6, height_m: 0.9}]}]
//   things: [{shape: sphere, diameter_m: 0.1, mass_kg: 0.1, position_m: [1, 0]}]
//   lights: [{sun: [-0.3, -0.4, -1]}, {lamp: [0, 0, 2.5], colour: [0.5, 0.5, 0.4]}]
//   tags:   [{id: 7, size_m: 0.15, position_m: [2, 0, 0.4], yaw_deg: 180}]
//   random: [{seed: 1, boxes: 45, from_m: [-3, -3], to_m: [3, 3], smallest_m: [0.1, 0.1, 0.05],
//             largest_m: [0.4, 0.4, 0.2], keep_out_m: 0.8}]
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "gaitway/world/world.hpp"

namespace gaitway::world {

// `random_seed`: in place of the seeds of the file's random courses. Throws input::InputError with file,
// line, field, value and rule. Whether a robot's body has room at the start, the simulator says.
[[nodiscard]] World read_world(const std::filesystem::path& file,
                               std::optional<std::uint64_t> random_seed = std::nullopt);

}  // namespace gaitway::world
