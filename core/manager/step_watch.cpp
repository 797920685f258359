// One shared page of memory (memfd), which the supervisor maps, too.
#include "gaitway/manager/step_watch.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <new>
#include <system_error>
#include <utility>

namespace gaitway::core {
namespace {

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

}  // namespace

StepWatch::StepWatch(process::FileDescriptor memory) : memory_(std::move(memory)) {
  void* const page = mmap(nullptr, sizeof(Page), PROT_READ | PROT_WRITE, MAP_SHARED, memory_.get(), 0);
  if (page == MAP_FAILED) {
    fail("the step watch's shared memory");
  }
  page_ = static_cast<Page*>(page);  // all zero in a new one: what its members begin with
}

StepWatch StepWatch::make() {
  process::FileDescriptor memory(memfd_create("gaitway_step_watch", MFD_CLOEXEC));
  if (!memory || ftruncate(memory.get(), sizeof(Page)) != 0) {
    fail("the step watch's shared memory");
  }
  return StepWatch(std::move(memory));
}

StepWatch StepWatch::open(int inherited) {
  return StepWatch(process::FileDescriptor(inherited));
}

StepWatch::StepWatch(StepWatch&& other) noexcept
    : memory_(std::move(other.memory_)), page_(std::exchange(other.page_, nullptr)) {}

StepWatch::~StepWatch() {
  if (page_ != nullptr) {
    munmap(page_, sizeof(Page));
  }
}

std::uint32_t StepWatch::add(std::string_view plugin) noexcept {
  std::array<char, 48> name{};
  std::copy_n(plugin.begin(), std::min(plugin.size(), name.size() - 1), name.begin());
  const std::uint32_t count = page_->count.load(std::memory_order_relaxed);
  const auto known = std::find(page_->names.begin() + 1, page_->names.begin() + 1 + count, name);
  const auto id = static_cast<std::uint32_t>(known - page_->names.begin());
  if (id <= count) {
    return id;
  }
  if (id > kCapacity) {
    return 0;
  }
  page_->names[id] = name;
  page_->count.store(id, std::memory_order_relaxed);
  return id;
}

std::string StepWatch::current() const {
  const std::uint32_t id = page_->current.load(std::memory_order_relaxed);
  return id == 0 || id > kCapacity ? std::string() : std::string(page_->names[id].data());
}

}  // namespace gaitway::core
