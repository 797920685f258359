// Whether a simulated camera may differ from its file as much as a real one does.
#pragma once

#include <filesystem>

#include "gaitway/simulator/stereo_camera.hpp"

namespace gaitway::simulator {

// Throws input::InputError, which names the file, if a lens that may be drawn for some seed, at this scale of
// the mismatch or at 1, whichever is less, does not see each pixel of its picture. For one file the same for
// each seed.
void require_room_for_mismatch(const urdf::StereoCamera& camera, const std::filesystem::path& file,
                               double scale);

}  // namespace gaitway::simulator
