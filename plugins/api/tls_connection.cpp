// Connections over TLS.
#include "websocket_connection.hpp"

namespace gaitway::api {

std::shared_ptr<ClientLink> make_tls_connection(ServerCore& core, TcpSocket socket,
                                                const ClientLink::Endpoint& peer, bool surplus,
                                                boost::asio::ssl::context& tls) {
  return std::make_shared<WebSocketConnection<TlsStream>>(core, peer, surplus,
                                                          TlsStream(std::move(socket), tls));
}

}  // namespace gaitway::api
