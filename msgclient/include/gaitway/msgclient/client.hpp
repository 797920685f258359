// A program's door to the memory block: opens topics to write and to read. The same in the message
// controller's own process (MemoryBlock::local_client) and in any other (Client::connect).
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/msgclient/handles.hpp"
#include "gaitway/msgclient/topic.hpp"

namespace gaitway::msgclient {

enum class Role : std::uint32_t { reader = 0, writer = 1 };

// Where a client gets its topics from: the block itself or a server's socket. All calls are for set-up.
class TopicSource {
 public:
  virtual ~TopicSource() = default;
  virtual TopicGrant open(const TopicDescriptor& descriptor, Role role) = 0;
  virtual void seal() = 0;
  [[nodiscard]] virtual std::vector<TopicInfo> directory() const = 0;
  [[nodiscard]] virtual std::uint64_t generation() const noexcept = 0;
  [[nodiscard]] virtual std::int64_t heartbeat_ns() const noexcept = 0;
  [[nodiscard]] virtual int hang_up_fd() const noexcept { return -1; }
};

// Every opening call may allocate and throws TopicError, whose message names the topic, both sides and the
// remedy: a second writer, a type that disagrees, no room. A topic is declared by whoever opens it first,
// reader or writer. A writer's claim ends with its handle, or with the process. Use from one thread at a
// time.
class Client {
 public:
  // Connects to a MemoryBlockServer's socket. Each set-up call waits for its answer for at most `timeout`.
  // Throws TopicError.
  static Client connect(const std::filesystem::path& socket, const std::string& client_name,
                        std::chrono::milliseconds timeout = std::chrono::seconds(2));
  Client(std::shared_ptr<TopicSource> source, std::string name)
      : source_(std::move(source)), name_(std::move(name)) {}

  template <class T>
  [[nodiscard]] Writer<T> write(std::string_view topic) {
    return Writer<T>(write_untyped(TopicDescriptor::of<T>(topic)));
  }
  template <class T>
  [[nodiscard]] Reader<T> read(std::string_view topic) {
    return Reader<T>(read_untyped(TopicDescriptor::of<T>(topic)));
  }
  // A stream keeps its newest `capacity` values; 0: as declared by the other side, or kDefaultQueueCapacity.
  template <class T>
  [[nodiscard]] Writer<T> write_stream(std::string_view topic, std::uint32_t capacity = 0) {
    return Writer<T>(write_untyped(TopicDescriptor::of<T>(topic, TopicKind::stream, capacity)));
  }
  template <class T>
  [[nodiscard]] StreamReader<T> read_stream(std::string_view topic, std::uint32_t capacity = 0,
                                            bool from_oldest = false) {
    return StreamReader<T>(
        read_stream_untyped(TopicDescriptor::of<T>(topic, TopicKind::stream, capacity), from_oldest));
  }
  // A queue holds at most `capacity` values that its reader, one at a time, has not taken yet.
  template <class T>
  [[nodiscard]] QueueWriter<T> write_queue(std::string_view topic, std::uint32_t capacity = 0) {
    return QueueWriter<T>(write_queue_untyped(TopicDescriptor::of<T>(topic, TopicKind::queue, capacity)));
  }
  template <class T>
  [[nodiscard]] QueueReader<T> read_queue(std::string_view topic, std::uint32_t capacity = 0) {
    return QueueReader<T>(read_queue_untyped(TopicDescriptor::of<T>(topic, TopicKind::queue, capacity)));
  }

  [[nodiscard]] UntypedWriter write_untyped(const TopicDescriptor& descriptor);
  [[nodiscard]] UntypedReader read_untyped(const TopicDescriptor& descriptor);
  [[nodiscard]] UntypedStreamReader read_stream_untyped(const TopicDescriptor& descriptor,
                                                        bool from_oldest = false);
  [[nodiscard]] UntypedQueueWriter write_queue_untyped(const TopicDescriptor& descriptor);
  [[nodiscard]] UntypedQueueReader read_queue_untyped(const TopicDescriptor& descriptor);
  // Bare words: writable for the one with Role::writer.
  [[nodiscard]] TopicGrant open_window(std::string_view name, std::uint32_t bytes, Role role);

  // Gives up all that opens a topic, for good: the memory block's side refuses it from now on, so that
  // whoever takes this process over gets nothing that it has not got already. Handles work on, and give their
  // claims back. Throws TopicError when nobody answers.
  void seal() { source_->seal(); }

  // All declared topics, in the order of their declaration.
  [[nodiscard]] std::vector<TopicInfo> directory() const { return source_->directory(); }
  [[nodiscard]] std::optional<TopicInfo> find(std::string_view topic) const;
  // Grows whenever the directory changes.
  [[nodiscard]] std::uint64_t generation() const noexcept { return source_->generation(); }
  // Latest MemoryBlock::beat(): how a client sees that the message controller is alive.
  [[nodiscard]] std::int64_t heartbeat_ns() const noexcept { return source_->heartbeat_ns(); }
  // To wait on with poll() for POLLRDHUP alone: the message controller's process has ended, however it did,
  // and this client has to be made anew. -1: the memory block is this process's own.
  [[nodiscard]] int hang_up_fd() const noexcept { return source_->hang_up_fd(); }
  // Asks the system; without waiting.
  [[nodiscard]] bool server_has_ended() const noexcept;
  [[nodiscard]] const std::string& name() const noexcept { return name_; }

 private:
  std::shared_ptr<TopicSource> source_;
  std::string name_;
};

// Of the message controller, as long as it keeps what this returns: no hardware is on its bus. Who finds no
// such mark may have a robot of metal before it.
[[nodiscard]] TopicGrant mark_simulated(Client& message_controller);
[[nodiscard]] bool is_marked_simulated(const Client& client);

}  // namespace gaitway::msgclient
