// Which web pages may talk to the robot: a browser names the page's origin when it opens a WebSocket.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gaitway::api {

class OriginRule {
 public:
  // None listed: http and https pages of localhost, 127.0.0.1 and [::1], on any port. Throws ServerSetupError
  // for an entry that is not `http(s)://host` or `http(s)://host:port`.
  explicit OriginRule(std::span<const std::string> allowed = {});

  // `origin`: the header's value. Anything else than a web origin, such as `null` or `file://`, is refused.
  [[nodiscard]] bool allows(std::string_view origin) const;

 private:
  std::vector<std::string> allowed_;
};

}  // namespace gaitway::api
