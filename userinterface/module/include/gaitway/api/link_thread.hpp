// Keeps the link going from a thread of its own, so that nothing that clients do delays an order on it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <thread>

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

 private:
  void run(const std::stop_token& stop);
  void connect(std::int64_t now_ns);
  void follow_session(std::int64_t now_ns);
  void wait() const;

  ModuleLink& link_;
  const link::LinkAddress address_;
  std::function<void(const std::string&)> tell_;
  process::FileDescriptor wake_;  // an eventfd
  std::unique_ptr<link::Carrier> carrier_;
  int carrier_fd_ = -1;
  std::int64_t tried_ns_ = 0;
  std::string told_;  // why there is no link, as told last
  std::int64_t closed_ns_ = 0;
  bool open_ = false, complained_ = false;
  std::jthread thread_;
};

}  // namespace gaitway::api
