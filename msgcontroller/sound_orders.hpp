// Orders as other processes write them: what of them may become a command.
#pragma once

#include <cstdint>

#include "gaitway/msgclient/topics.hpp"

namespace gaitway::msgcontroller {

[[nodiscard]] WalkCommand stand() noexcept;
// One that is over or nonsense is a stand.
[[nodiscard]] WalkCommand made_sound(WalkCommand walk, std::int64_t now_ns) noexcept;
// With a name that ends.
[[nodiscard]] MotionRequest made_sound(MotionRequest motion) noexcept;
[[nodiscard]] bool is_sensible(const HeadCommand& head) noexcept;
// Whether it is about the motion that plays.
[[nodiscard]] bool leaves(const MotionRequest& motion) noexcept;

}  // namespace gaitway::msgcontroller
