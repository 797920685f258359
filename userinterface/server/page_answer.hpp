// What the server answers to browsers that ask for the page and what belongs to it.
#pragma once

#include <boost/beast/http/message.hpp>
#include <boost/beast/http/span_body.hpp>
#include <optional>
#include <variant>

#include "gaitway/api/server_setup.hpp"
#include "gaitway/page/asset_table.hpp"
#include "handshake_check.hpp"

namespace gaitway::api {

// Its body is the asset's own, which outlives it.
using PageAnswer = http::response<http::span_body<const char>>;

// Of a request that is no handshake of a WebSocket.
[[nodiscard]] std::variant<PageAnswer, HandshakeRefusal> answer_page(const HandshakeRequest& request,
                                                                     const page::AssetTable& assets,
                                                                     const ServerSetup& setup);

}  // namespace gaitway::api
