// The checks in the order in which a person would want to hear of them.
#include "handshake_check.hpp"

#include <boost/beast/http/field.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <string_view>

#include "page_host.hpp"

namespace gaitway::api {
namespace {

constexpr std::size_t kQuotedBytes = 200;
constexpr std::size_t kKeyBytes = 24;  // 16 in base64
constexpr boost::beast::string_view kViewOfPage = "/view?page=";

// What a client sent, fit to be shown to people.
std::string quoted(boost::beast::string_view text) {
  std::string result = "'";
  for (const char c : plain(text).substr(0, kQuotedBytes)) {
    result += c >= ' ' && c <= '~' ? c : '?';
  }
  return result + (text.size() > kQuotedBytes ? "...'" : "'");
}

// Nothing when it is of another scheme.
std::optional<std::string_view> bearer_token(boost::beast::string_view header) {
  constexpr boost::beast::string_view kScheme = "Bearer ";
  if (header.size() < kScheme.size() || !boost::beast::iequals(header.substr(0, kScheme.size()), kScheme)) {
    return std::nullopt;
  }
  return plain(header.substr(kScheme.size()));
}

bool is_root(boost::beast::string_view target) {
  return target == "/" || target.starts_with("/?");
}

}  // namespace

std::string_view plain(boost::beast::string_view text) noexcept {
  return {text.data(), text.size()};
}

bool asks_for_view(const HandshakeRequest& request) {
  return request.target() == "/view" || request.target().starts_with(kViewOfPage);
}

std::optional<HandshakeRefusal> check_handshake(const HandshakeRequest& request, const ServerSetup& setup,
                                                bool view, std::string_view page_version) {
  const std::optional<AccessToken>& token = setup.token();
  if (!is_root(request.target()) && !(view && asks_for_view(request))) {
    return HandshakeRefusal{http::status::not_found, Refusal::wrong_path,
                            "there is nothing at " + quoted(request.target()) + ": the robot API is at /\n"};
  }
  if (request.method() != http::verb::get) {
    return HandshakeRefusal{http::status::method_not_allowed, Refusal::bad_request,
                            "the robot API is a WebSocket, which is opened with GET\n"};
  }
  if (!boost::beast::websocket::is_upgrade(request)) {
    return HandshakeRefusal{
        http::status::upgrade_required, Refusal::no_websocket,
        "This is a robot's API: rosbridge v2 over WebSocket (version 13, HTTP/1.1). Connect "
        "with a WebSocket client, for example roslibjs or roslibpy.\n"};
  }
  if (request.count(http::field::sec_websocket_key) != 1 ||
      request[http::field::sec_websocket_key].size() != kKeyBytes) {
    return HandshakeRefusal{http::status::bad_request, Refusal::bad_request,
                            "Sec-WebSocket-Key must be there once, with 16 random bytes in base64\n"};
  }
  for (const auto& field : request) {
    if (field.name() == http::field::origin && !setup.origins().allows(plain(field.value())) &&
        !is_own_page(plain(field.value()), plain(request[http::field::host]), setup.has_tls())) {
      return HandshakeRefusal{http::status::forbidden, Refusal::foreign_origin,
                              "web pages of the origin " + quoted(field.value()) +
                                  " may not talk to the robot: add it to the API's parameter origins "
                                  "(--origins of gaitway serve), "
                                  "or serve the page from an origin that is listed there\n",
                              "origin " + quoted(field.value())};
    }
  }
  if (request.target().starts_with(kViewOfPage) &&
      plain(request.target()).substr(kViewOfPage.size()) != page_version) {
    const std::string page = quoted(request.target().substr(kViewOfPage.size()));
    return HandshakeRefusal{http::status::conflict, Refusal::other_page,
                            "the page is of the version " + page + ", this robot serves '" +
                                std::string(page_version) + "': load the page again\n",
                            "page " + page};
  }
  if (token && request.count(http::field::authorization) != 0 && !is_authorised(request, token)) {
    return HandshakeRefusal{http::status::unauthorized, Refusal::wrong_token,
                            "the token is wrong: send `Authorization: Bearer TOKEN` with the token that the "
                            "robot's token_file holds\n"};
  }
  return std::nullopt;
}

bool is_authorised(const HandshakeRequest& request, const std::optional<AccessToken>& token) {
  if (!token) {
    return true;
  }
  const auto offered = bearer_token(request[http::field::authorization]);
  return offered && request.count(http::field::authorization) == 1 && token->matches(*offered);
}

HttpAnswer answer(const HandshakeRefusal& refusal) {
  HttpAnswer response(refusal.status, 11);
  response.set(http::field::server, kServerName);
  response.set(http::field::content_type, "text/plain; charset=utf-8");
  response.set(http::field::connection, "close");
  if (refusal.status == http::status::upgrade_required) {
    response.set(http::field::upgrade, "websocket");
    response.set(http::field::connection, "Upgrade, close");
    response.set(http::field::sec_websocket_version, "13");
  } else if (refusal.status == http::status::unauthorized) {
    response.set(http::field::www_authenticate, "Bearer");
  } else if (refusal.status == http::status::method_not_allowed) {
    response.set(http::field::allow, "GET");
  } else if (refusal.status == http::status::service_unavailable) {
    response.set(http::field::retry_after, "1");
  }
  response.body() = refusal.text;
  response.prepare_payload();
  return response;
}

}  // namespace gaitway::api
