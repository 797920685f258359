// Names in the shared page, none of which is believed to have an end.
#include "gaitway/manager/step_watch.hpp"

#include <algorithm>
#include <cstring>

#include "gaitway/instance/event_log.hpp"

namespace gaitway::core {

StepWatch StepWatch::make() {
  return StepWatch(msgclient::Segment::create("gaitway_step_watch", sizeof(Page)));
}

StepWatch StepWatch::open(int inherited) {
  return StepWatch(msgclient::Segment::map(process::FileDescriptor(inherited), sizeof(Page),
                                           msgclient::Access::read_write));
}

std::uint32_t StepWatch::add(std::string_view plugin) noexcept {
  Name name{};
  copy_text(plugin, name);
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

void StepWatch::begin_change(std::string_view plugin) noexcept {
  copy_text(plugin, page_->names[0]);
  page_->changes.store(1, std::memory_order_relaxed);
}

std::string StepWatch::changed() const {
  const Name& name = page_->names[0];
  const bool changes = page_->changes.load(std::memory_order_relaxed) != 0;
  return changes ? std::string(name.data(), strnlen(name.data(), name.size())) : std::string();
}

std::string StepWatch::current() const {
  const std::uint32_t id = page_->current.load(std::memory_order_relaxed);
  if (id == 0 || id > kCapacity) {
    return {};
  }
  const Name& name = page_->names[id];
  return {name.data(), strnlen(name.data(), name.size())};
}

}  // namespace gaitway::core
