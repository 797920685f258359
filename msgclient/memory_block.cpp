// The memory block and its clients inside the owner's process.
#include "gaitway/msgclient/memory_block.hpp"

#include "topic_registry.hpp"

namespace gaitway::msgclient {
namespace {

class LocalSource final : public TopicSource {
 public:
  LocalSource(std::shared_ptr<TopicRegistry> registry, std::string name)
      : registry_(std::move(registry)), name_(std::move(name)), id_(registry_->new_client()) {}

  TopicGrant open(const TopicDescriptor& descriptor, Role role) override {
    if (sealed_) {
      throw TopicError(sealed_text(name_, descriptor.name));
    }
    TopicGrant grant = registry_->open(id_, name_, descriptor, role);
    if (role == Role::writer || descriptor.kind == TopicKind::queue) {
      grant.claim = Claim([registry = registry_, id = id_, topic = descriptor.name, role] {
        registry->release(id, topic, role);
      });
    }
    return grant;
  }
  void seal() override { sealed_ = true; }
  std::vector<TopicInfo> directory() const override { return registry_->directory().rows(); }
  std::uint64_t generation() const noexcept override { return registry_->directory().generation(); }
  std::int64_t heartbeat_ns() const noexcept override { return registry_->directory().heartbeat_ns(); }

 private:
  std::shared_ptr<TopicRegistry> registry_;
  std::string name_;
  ClientId id_;
  bool sealed_ = false;
};

}  // namespace

MemoryBlock::MemoryBlock(std::size_t size_bytes) : registry_(std::make_shared<TopicRegistry>(size_bytes)) {}
MemoryBlock::~MemoryBlock() = default;
MemoryBlock::MemoryBlock(MemoryBlock&&) noexcept = default;
MemoryBlock& MemoryBlock::operator=(MemoryBlock&&) noexcept = default;

Client MemoryBlock::local_client(const std::string& name) {
  return Client(std::make_shared<LocalSource>(registry_, name), name);
}
void MemoryBlock::beat(std::int64_t now_ns) noexcept {
  registry_->beat(now_ns);
}
void MemoryBlock::keep_to_this_process() {
  registry_->keep_to_this_process();
}

void MemoryBlock::share_anew() {
  registry_->share_anew();
}
std::size_t MemoryBlock::size_bytes() const noexcept {
  return registry_->block_bytes();
}
std::size_t MemoryBlock::used_bytes() const noexcept {
  return registry_->used_bytes();
}

}  // namespace gaitway::msgclient
