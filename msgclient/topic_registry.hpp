// The owner's book of topics: declares, checks, lends. The local clients and the server both ask here.
#pragma once

#include <map>
#include <mutex>
#include <vector>

#include "directory.hpp"
#include "gaitway/msgclient/memory_block.hpp"

namespace gaitway::msgclient {

using ClientId = std::uint64_t;

// Why a client that was sealed gets no topic.
[[nodiscard]] std::string sealed_text(std::string_view client, std::string_view topic);

class TopicRegistry {
 public:
  explicit TopicRegistry(std::size_t block_bytes);

  [[nodiscard]] ClientId new_client() noexcept;
  // The grant carries no claim: whoever lends it further arranges for release(). Throws TopicError.
  [[nodiscard]] TopicGrant open(ClientId client, const std::string& client_name,
                                const TopicDescriptor& wanted, Role role);
  // Gives back one claim; nothing happens if it isn't this client's.
  void release(ClientId client, const std::string& topic, Role role) noexcept;
  void release_all(ClientId client) noexcept;
  // Who writes the topic, or reads its queue; 0: nobody.
  [[nodiscard]] ClientId holder(std::string_view topic, Role role) const noexcept;

  void keep_to_this_process();
  void share_anew();

  void beat(std::int64_t now_ns) noexcept { directory_.beat(now_ns); }
  [[nodiscard]] const Directory& directory() const noexcept { return directory_; }
  [[nodiscard]] const Segment& directory_segment() const noexcept { return directory_segment_; }
  [[nodiscard]] std::size_t block_bytes() const noexcept { return block_bytes_; }
  [[nodiscard]] std::size_t used_bytes() const noexcept;

 private:
  struct Topic {
    TopicInfo info;
    std::string declared_by;
    RingGeometry geometry;
    std::shared_ptr<Segment> storage;
    std::shared_ptr<Segment> cursor;  // queues only
    ClientId writer = 0;              // 0: nobody
    ClientId reader = 0;              // of a queue
  };

  Topic& declare(const TopicDescriptor& wanted, const std::string& client_name);
  void claim(Topic& topic, ClientId client, const std::string& client_name, Role role);
  void give_back(Topic& topic, ClientId client, Role role) noexcept;
  void show(const Topic& topic) noexcept {
    directory_.store_row(index_.at(topic.info.descriptor.name), topic.info);
  }

  mutable std::mutex
      mutex_;  // set-up calls of several threads of the owner's process; never taken in the cycle
  std::size_t block_bytes_;
  std::size_t used_bytes_ = 0;
  ClientId last_client_ = 0;
  Segment directory_segment_;
  Directory directory_;
  std::vector<Topic> topics_;
  std::map<std::string, std::size_t, std::less<>> index_;
};

}  // namespace gaitway::msgclient
