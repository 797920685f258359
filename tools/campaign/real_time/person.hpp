// The person who commands the robot in a trial, over its API as any client does: takes the command, renews
// the walk ten times a second, and begins anew whenever the connection, the lease or the robot is lost.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

#include "tools/ctl/api_client.hpp"

namespace gaitway::tools {

class Person {
 public:
  Person(std::string url, double speed_m_per_s);

  // From now on; else nothing is ordered, and the command is kept.
  void walk(bool wanted) noexcept { walks_ = wanted; }
  // The connection stays open, and nothing more comes over it; another one is made in its place.
  void fall_silent() noexcept { falls_silent_ = true; }

 private:
  void run(const std::stop_token& end);
  void renew();
  void connect();

  std::string url_;
  double speed_m_per_s_;
  std::atomic<bool> walks_ = false, falls_silent_ = false;
  std::unique_ptr<ApiClient> client_, silent_;  // of the thread alone
  std::string lease_;                           // likewise
  std::jthread thread_;
};

// Somebody else, with a connection of his own, who asks for a stop until he is told that it was obeyed.
class StopAsker {
 public:
  StopAsker(std::string url, std::int64_t at_ns);

  // When it was first sent; 0: not yet.
  [[nodiscard]] std::int64_t asked_ns() const noexcept { return asked_ns_; }

 private:
  void run(const std::stop_token& end, std::int64_t at_ns);

  std::string url_;
  std::atomic<std::int64_t> asked_ns_ = 0;
  std::jthread thread_;
};

}  // namespace gaitway::tools
