// How many times this test program has asked for memory.
#pragma once

namespace gaitway::test {

[[nodiscard]] long allocation_count() noexcept;  // calls of operator new since the start

}  // namespace gaitway::test
