// What libFuzzer calls: one binary a target. GAITWAY_FUZZ_TARGET is the target's function.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>

#include "fuzz_input.hpp"

namespace gaitway::fuzz {
void GAITWAY_FUZZ_TARGET(std::span<const std::uint8_t> bytes);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    gaitway::fuzz::GAITWAY_FUZZ_TARGET({data, size});
  } catch (const gaitway::fuzz::BrokenProperty& broken) {
    std::fprintf(stderr, "broken property: %s\n", broken.what.c_str());
    std::abort();
  }
  return 0;
}
