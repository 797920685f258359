// Opening of topics, the same for every source.
#include "gaitway/msgclient/client.hpp"

#include <algorithm>

namespace gaitway::msgclient {

UntypedWriter Client::write_untyped(const TopicDescriptor& descriptor) {
  return UntypedWriter(source_->open(descriptor, Role::writer));
}
UntypedReader Client::read_untyped(const TopicDescriptor& descriptor) {
  return UntypedReader(source_->open(descriptor, Role::reader));
}
UntypedStreamReader Client::read_stream_untyped(const TopicDescriptor& descriptor, bool from_oldest) {
  return UntypedStreamReader(source_->open(descriptor, Role::reader), from_oldest);
}
UntypedQueueWriter Client::write_queue_untyped(const TopicDescriptor& descriptor) {
  return UntypedQueueWriter(source_->open(descriptor, Role::writer));
}
UntypedQueueReader Client::read_queue_untyped(const TopicDescriptor& descriptor) {
  return UntypedQueueReader(source_->open(descriptor, Role::reader));
}

TopicGrant Client::open_window(std::string_view name, std::uint32_t bytes, Role role) {
  return source_->open({std::string(name), "window", 0, bytes, TopicKind::window, 0}, role);
}

std::optional<TopicInfo> Client::find(std::string_view topic) const {
  auto rows = source_->directory();
  const auto found = std::find_if(rows.begin(), rows.end(),
                                  [&](const TopicInfo& row) { return row.descriptor.name == topic; });
  return found == rows.end() ? std::nullopt : std::optional(std::move(*found));
}

}  // namespace gaitway::msgclient
