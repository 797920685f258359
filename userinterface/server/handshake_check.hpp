// Whether a client's HTTP request may become a WebSocket, and what to answer if not.
#pragma once

#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "gaitway/api/server_setup.hpp"
#include "gaitway/api/server_statistics.hpp"

namespace gaitway::api {

// What every answer says of this server: by its number clients see whether they fit.
inline constexpr const char* kServerName = "gaitway/" GAITWAY_VERSION;

namespace http = boost::beast::http;
using HandshakeRequest = http::request<http::empty_body>;
using HttpAnswer = http::response<http::string_body>;

// Of a request's field.
[[nodiscard]] std::string_view plain(boost::beast::string_view text) noexcept;

struct HandshakeRefusal {
  http::status status;
  Refusal cause;
  std::string text;         // for people
  std::string detail = {};  // of the web page that was refused: "origin 'https://...'"
};

// `view`: there is one. `page_version`: the page's that is served here.
[[nodiscard]] std::optional<HandshakeRefusal> check_handshake(const HandshakeRequest& request,
                                                              const ServerSetup& setup, bool view,
                                                              std::string_view page_version);

// Whether it asks for the view rather than for the robot API: /view, or /view?page=VERSION by a page that
// wants it from a server of its own version alone.
[[nodiscard]] bool asks_for_view(const HandshakeRequest& request);

// Whether the request carries the token, or none is wanted. Of a request that has been checked.
[[nodiscard]] bool is_authorised(const HandshakeRequest& request, const std::optional<AccessToken>& token);

// The whole answer, after which the connection ends.
[[nodiscard]] HttpAnswer answer(const HandshakeRefusal& refusal);

}  // namespace gaitway::api
