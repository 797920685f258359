// A thread beside a real-time loop: ordinary priority, a small stack (all of it is locked where memory is),
// and no signal of the process is taken by it.
#pragma once

#include <functional>

namespace gaitway::process {

// Runs `work` in a thread that nobody joins. Throws std::runtime_error when there is none to be had.
void start_background_thread(std::function<void()> work);

}  // namespace gaitway::process
