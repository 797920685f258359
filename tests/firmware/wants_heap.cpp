// Code that no firmware may contain: it must not link. One sin for each image, by its definition.
#include <cstddef>
#include <cstdlib>
#include <new>

volatile std::size_t size = 100;
void* volatile kept;

int main() {
#if defined(GAITWAY_WANTS_MALLOC)
  kept = std::malloc(size);
#elif defined(GAITWAY_WANTS_NEW)
  kept = ::operator new(size);
#else
  throw 1;
#endif
  while (true) {
  }
}
