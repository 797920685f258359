// Keeps the link going from a thread of its own, so that nothing that clients do delays an order on it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "gaitway/api/link_watch.hpp"
#include "gaitway/api/module_link.hpp"
#include "gaitway/link/link_address.hpp"
#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::api {

class LinkThread {
 public:
  // `tell`: lines for people, from that thread. Connects, and connects anew, by itself. Throws
  // std::system_error.
  LinkThread(ModuleLink& link, link::LinkAddress address, std::function<void(const std::string&)> tell);
  LinkThread(const LinkThread&) = delete;
  LinkThread& operator=(const LinkThread&) = delete;
  ~LinkThread();

  // As of now.
  [[nodiscard]] LinkReport report() const;

 private:
  void run(const std::stop_token& stop);
  void connect(std::int64_t now_ns);
  void watch(std::int64_t now_ns);
  void wait() const;

  ModuleLink& link_;
  const link::LinkAddress address_;
  std::function<void(const std::string&)> tell_;
  process::FileDescriptor wake_;  // an eventfd
  std::unique_ptr<link::Carrier> carrier_;
  int carrier_fd_ = -1;
  std::int64_t tried_ns_ = 0;
  std::string error_;  // why there is no carrier
  mutable std::mutex mutex_;
  LinkWatch watch_;  // with the mutex
  std::jthread thread_;
};

}  // namespace gaitway::api
