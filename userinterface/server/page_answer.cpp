// Nothing but GET and HEAD of what is in the table, for those who ask for the robot under a name that is its
// own.
#include "page_answer.hpp"

#include <boost/beast/http/field.hpp>
#include <string>
#include <string_view>

#include "page_host.hpp"

namespace gaitway::api {
namespace {

// The page runs its own script and style alone, talks to this server alone, and is nobody's frame.
constexpr const char* kPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; connect-src 'self'; base-uri "
    "'none'; "
    "form-action 'none'; frame-ancestors 'none'";

std::optional<HandshakeRefusal> refusal_of(const HandshakeRequest& request, const page::Asset* asset,
                                           const ServerSetup& setup) {
  const std::string_view host = plain(request[http::field::host]);
  const std::string own_origin = (setup.has_tls() ? "https://" : "http://") + std::string(host);
  if (!is_numeric_host(host) && !setup.origins().allows(own_origin)) {
    return HandshakeRefusal{http::status::misdirected_request, Refusal::foreign_origin,
                            "the robot is not known by this name: ask for its numeric address, or add '" +
                                own_origin + "' to the API's parameter origins\n"};
  }
  if (asset == nullptr) {
    return HandshakeRefusal{http::status::not_found, Refusal::wrong_path,
                            "there is nothing here: the page is at /, and so is the robot API\n"};
  }
  if (request.method() != http::verb::get && request.method() != http::verb::head) {
    return HandshakeRefusal{http::status::method_not_allowed, Refusal::bad_request,
                            "the page can be got, and nothing else\n"};
  }
  if (asset->wants_token && !is_authorised(request, setup.token())) {
    return HandshakeRefusal{http::status::unauthorized, Refusal::wrong_token,
                            "the robot wants its token: send `Authorization: Bearer TOKEN`\n"};
  }
  return std::nullopt;
}

}  // namespace

std::variant<PageAnswer, HandshakeRefusal> answer_page(const HandshakeRequest& request,
                                                       const page::AssetTable& assets,
                                                       const ServerSetup& setup) {
  const page::Asset* const asset = assets.find(plain(request.target()));
  if (auto refusal = refusal_of(request, asset, setup)) {
    return std::move(*refusal);
  }
  const bool gzip =
      !asset->gzip.empty() && http::token_list(request[http::field::accept_encoding]).exists("gzip");
  const std::string& body = gzip ? asset->gzip : asset->body;
  PageAnswer response(http::status::ok, 11);
  response.set(http::field::server, kServerName);
  response.set(http::field::content_type, asset->type);
  response.set("Content-Security-Policy", kPolicy);
  response.set(http::field::x_frame_options, "DENY");
  response.set(http::field::cache_control, "no-cache");
  response.set("X-Content-Type-Options", "nosniff");
  response.set("Referrer-Policy", "no-referrer");
  response.set("Cross-Origin-Resource-Policy", "same-origin");
  response.set(http::field::vary, "Accept-Encoding");
  if (gzip) {
    response.set(http::field::content_encoding, "gzip");
  }
  response.set(http::field::connection, "close");
  response.content_length(body.size());
  if (request.method() == http::verb::get) {
    response.body() = {body.data(), body.size()};
  }
  return response;
}

}  // namespace gaitway::api
