// How often a test does the same with further random values.
#pragma once

namespace gaitway::test {

// Under a sanitizer a tenth: it looks at what the code does, not at rare figures, and takes ten times as
// long.
constexpr int repeats(int usual) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return (usual + 9) / 10;
#else
  return usual;
#endif
}

}  // namespace gaitway::test
