// Connections over plain TCP.
#include "websocket_connection.hpp"

namespace gaitway::api {

std::shared_ptr<ClientLink> make_plain_connection(ServerCore& core, TcpSocket socket,
                                                  const ClientLink::Endpoint& peer, bool surplus) {
  return std::make_shared<WebSocketConnection<TcpSocket>>(core, peer, surplus, std::move(socket));
}

}  // namespace gaitway::api
