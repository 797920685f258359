// iceoryx as a topic: publisher, subscriber and the daemon that connects them, all in one process.
#include <cstdint>
#include <cstring>
#include <iostream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "iceoryx_hoofs/log/logmanager.hpp"
#include "iceoryx_hoofs/posix_wrapper/posix_access_rights.hpp"
#include "iceoryx_posh/iceoryx_posh_config.hpp"
#include "iceoryx_posh/internal/roudi/roudi.hpp"
#include "iceoryx_posh/popo/untyped_publisher.hpp"
#include "iceoryx_posh/popo/untyped_subscriber.hpp"
#include "iceoryx_posh/roudi/iceoryx_roudi_components.hpp"
#include "iceoryx_posh/runtime/posh_runtime_single_process.hpp"
#include "topic_rival.hpp"

namespace gaitway::peers {
namespace {

constexpr std::uint32_t kHeadersOfChunk_bytes = 256;  // room for what iceoryx puts before a value, and more
constexpr std::uint32_t kChunks = 16;

iox::RouDiConfig_t chunks_of(std::size_t bytes) {
  iox::mepoo::MePooConfig pools;
  const auto largest = static_cast<std::uint32_t>(bytes) + kHeadersOfChunk_bytes;
  pools.addMemPool({(largest + 63) / 64 * 64, kChunks});
  const auto group = iox::posix::PosixGroup::getGroupOfCurrentProcess();
  iox::RouDiConfig_t config;
  config.m_sharedMemorySegments.push_back({group.getName(), group.getName(), pools});
  return config;
}

// What the daemon has to say does not belong to our answer on stdout.
struct Quiet {
  Quiet() {
    std::cout.rdbuf(std::cerr.rdbuf());
    iox::log::LogManager::GetLogManager().SetDefaultLogLevel(iox::log::LogLevel::kError,
                                                             iox::log::LogLevelOutput::kHideLogLevel);
  }
};

class IceoryxTopic final : public TopicRival {
 public:
  explicit IceoryxTopic(std::size_t bytes)
      : TopicRival("iceoryx"), components_(chunks_of(bytes)), written_(bytes / sizeof(std::uint64_t)) {
    if (subscriber_.getSubscriptionState() != iox::SubscribeState::SUBSCRIBED) {
      throw std::runtime_error("iceoryx did not connect its subscriber");
    }
  }
  std::size_t write_and_read(std::size_t pairs) override {
    std::size_t whole = 0;
    const std::size_t bytes = written_.size() * sizeof(std::uint64_t);
    for (std::size_t i = 0; i < pairs; ++i) {
      ++written_[0];
      publisher_.loan(static_cast<std::uint32_t>(bytes)).and_then([&](void*& payload) {
        std::memcpy(payload, written_.data(), bytes);
        publisher_.publish(payload);
      });
      subscriber_.take().and_then([&](const void*& payload) {
        if (*static_cast<const std::uint64_t*>(payload) == written_[0]) ++whole;
        subscriber_.release(payload);
      });
    }
    return whole;
  }

 private:
  // The newest value alone, as our topics have it.
  static iox::popo::SubscriberOptions newest() {
    iox::popo::SubscriberOptions options;
    options.queueCapacity = 1;
    return options;
  }

  Quiet quiet_;
  iox::roudi::IceOryxRouDiComponents components_;
  iox::roudi::RouDi roudi_{components_.rouDiMemoryManager, components_.portManager,
                           iox::roudi::RouDi::RoudiStartupParameters{iox::roudi::MonitoringMode::OFF, false}};
  iox::runtime::PoshRuntimeSingleProcess runtime_{"gaitway_topic_peers"};
  iox::popo::UntypedPublisher publisher_{{"gaitway", "bench", "sample"}};
  iox::popo::UntypedSubscriber subscriber_{{"gaitway", "bench", "sample"}, newest()};
  std::vector<std::uint64_t> written_;
};

}  // namespace

std::unique_ptr<TopicRival> iceoryx_topic(std::size_t bytes) {
  return std::make_unique<IceoryxTopic>(bytes);
}

}  // namespace gaitway::peers
