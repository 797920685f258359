// How many times this test binary has asked for memory.
#pragma once

namespace gaitway::zmp::test {

[[nodiscard]] long allocation_count() noexcept;  // calls of operator new since the start

}  // namespace gaitway::zmp::test
