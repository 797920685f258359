// Whether the main controller is at the other end of the link, since when, and why not: for people.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "gaitway/api/ros_messages.hpp"
#include "gaitway/link/link_address.hpp"
#include "gaitway/link/session.hpp"

namespace gaitway::api {

struct LinkReport {
  // refused: lasts until somebody does something about it.
  enum class State : std::uint8_t { down, refused, up };
  State state = State::down;
  std::string text = {};      // what is wrong, with values, and what to do; empty: nothing
  std::int64_t since_ns = 0;  // monotonic
};

// What is to be seen of the link.
struct LinkSight {
  bool open = false;
  bool same_calibration = true;  // at both ends
  link::SessionEnd why = link::SessionEnd::not_begun;
  std::string description = {};  // of the session's end
  std::string error = {};        // why there is no carrier; empty: there is one, or was
};

// Passive: told the time. Ends of a link that come and go within a second are not told of.
class LinkWatch {
 public:
  LinkWatch(const link::LinkAddress& address, std::int64_t now_ns);

  // Often. Gives a line for the log when there is news.
  [[nodiscard]] std::optional<std::string> look(const LinkSight& sight, std::int64_t now_ns);
  [[nodiscard]] const LinkReport& report() const noexcept { return report_; }

 private:
  [[nodiscard]] std::string reason_of(const LinkSight& sight) const;

  std::string address_;
  LinkReport report_;
  std::string reason_;          // that is waited for, whether it lasts
  std::int64_t reason_ns_ = 0;  // since when
  std::int64_t lost_ns_ = 0;
};

[[nodiscard]] ros::LinkState link_state_of(const LinkReport& report, std::string_view link,
                                           std::int64_t now_ns);

}  // namespace gaitway::api
