// Those who watch the view: each gets the newest frame, and as many as it takes.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <string_view>

#include "gaitway/api/session.hpp"
#include "gaitway/page/view_layout.hpp"

namespace gaitway::api {

class ViewSession;

struct ViewOptions {
  std::function<bool(std::string_view offered)> is_token;  // without it none is right
  std::int64_t authentication_ns = 5'000'000'000;          // from the handshake to the token
};

// Sessions must not outlive their hub.
class ViewHub final : public SessionHub {
 public:
  static constexpr std::int64_t kPeriod_ns = 33'333'333;  // of frames, at least
  static constexpr std::size_t kMostInFlight = 8;         // frames that a client has not acknowledged

  explicit ViewHub(ViewOptions options) : options_(std::move(options)) {}
  ViewHub(const ViewHub&) = delete;
  ViewHub& operator=(const ViewHub&) = delete;

  std::unique_ptr<Session> open(Connection& connection, std::string peer, bool authorised,
                                std::int64_t wall_ns) override;
  void step(std::int64_t wall_ns) override;

  // Whether anybody watches at all.
  [[nodiscard]] bool watched() const noexcept { return !sessions_.empty(); }
  // Whether somebody watches, and it is time for a frame.
  [[nodiscard]] bool due(std::int64_t wall_ns) const noexcept { return watched() && wall_ns >= due_ns_; }
  // The frame's number is the hub's.
  void show(const page::ViewState& state, std::int64_t wall_ns);

 private:
  friend class ViewSession;

  ViewOptions options_;
  std::set<ViewSession*> sessions_;
  page::ViewState state_;
  std::string commander_;  // state_.commander points here
  std::int64_t due_ns_ = 0;
};

}  // namespace gaitway::api
