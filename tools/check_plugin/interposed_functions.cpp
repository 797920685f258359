// Stands in front of the C library's functions that a step may not use. Part of the executable, whose symbols
// come before those of every library that is loaded; while no guard is on, they only pass on.
#include <dlfcn.h>
#include <pthread.h>
#include <semaphore.h>

#include <cerrno>
#include <cstddef>
#include <typeinfo>

#include "tools/check_plugin/call_guard.hpp"

// The C library's own names of its allocator.
extern "C" {
void* __libc_malloc(std::size_t bytes);
void __libc_free(void* memory);
void* __libc_calloc(std::size_t count, std::size_t bytes);
void* __libc_realloc(void* memory, std::size_t bytes);
void* __libc_memalign(std::size_t alignment, std::size_t bytes);
}

namespace {

using gaitway::plugin_check::count_allocated;
using gaitway::plugin_check::count_freed;
using gaitway::plugin_check::note_call;

// Fresh memory on its way out.
void* filled(void* memory, std::size_t bytes) noexcept {
  count_allocated(memory);
  gaitway::plugin_check::fill_allocated(memory, bytes);
  return memory;
}

// The function of this name in the libraries behind this one.
template <class Function>
Function* behind(const char* name) noexcept {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

#define GAITWAY_INTERPOSED extern "C" __attribute__((visibility("default"), used))

GAITWAY_INTERPOSED void* malloc(std::size_t bytes) noexcept {
  note_call("malloc");
  return filled(__libc_malloc(bytes), bytes);
}
GAITWAY_INTERPOSED void free(void* memory) noexcept {
  if (memory != nullptr) {
    note_call("free");
  }
  count_freed(memory);
  __libc_free(memory);
}
GAITWAY_INTERPOSED void* calloc(std::size_t count, std::size_t bytes) noexcept {
  note_call("calloc");
  void* const memory = __libc_calloc(count, bytes);
  count_allocated(memory);
  return memory;
}
GAITWAY_INTERPOSED void* realloc(void* memory, std::size_t bytes) noexcept {
  note_call("realloc");
  count_freed(memory);
  void* const moved = __libc_realloc(memory, bytes);
  count_allocated(moved == nullptr && bytes != 0 ? memory : moved);  // what cannot grow stays where it is
  return moved;
}
GAITWAY_INTERPOSED void* memalign(std::size_t alignment, std::size_t bytes) noexcept {
  note_call("memalign");
  return filled(__libc_memalign(alignment, bytes), bytes);
}
GAITWAY_INTERPOSED void* aligned_alloc(std::size_t alignment, std::size_t bytes) noexcept {
  note_call("aligned_alloc");
  return filled(__libc_memalign(alignment, bytes), bytes);
}
GAITWAY_INTERPOSED int posix_memalign(void** memory, std::size_t alignment, std::size_t bytes) noexcept {
  note_call("posix_memalign");
  *memory = filled(__libc_memalign(alignment, bytes), bytes);
  return *memory == nullptr ? ENOMEM : 0;
}

// A call that may wait, of a lock of this type: noted and passed on.
#define GAITWAY_INTERPOSED_LOCK(name, type)              \
  GAITWAY_INTERPOSED int name(type* lock) noexcept {     \
    static auto* const next = behind<int(type*)>(#name); \
    note_call(#name);                                    \
    return next(lock);                                   \
  }

GAITWAY_INTERPOSED_LOCK(pthread_mutex_lock, pthread_mutex_t)
GAITWAY_INTERPOSED_LOCK(pthread_mutex_trylock, pthread_mutex_t)
GAITWAY_INTERPOSED_LOCK(pthread_rwlock_rdlock, pthread_rwlock_t)
GAITWAY_INTERPOSED_LOCK(pthread_rwlock_wrlock, pthread_rwlock_t)
GAITWAY_INTERPOSED_LOCK(pthread_spin_lock, pthread_spinlock_t)

GAITWAY_INTERPOSED int sem_wait(sem_t* semaphore) {
  static auto* const next = behind<int(sem_t*)>("sem_wait");
  note_call("sem_wait");
  return next(semaphore);
}

GAITWAY_INTERPOSED [[noreturn]] void __cxa_throw(void* exception, std::type_info* type,
                                                 void (*destroy)(void*)) {
  using Throw = void(void*, std::type_info*, void (*)(void*));
  static auto* const next = behind<Throw>("__cxa_throw");
  gaitway::plugin_check::note_exception();
  next(exception, type, destroy);
  __builtin_unreachable();
}
