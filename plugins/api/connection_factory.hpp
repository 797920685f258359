// Makes the connection for a socket that has been accepted.
#pragma once

#include <boost/asio/basic_stream_socket.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/context.hpp>
#include <memory>

#include "client_link.hpp"

namespace gaitway::api {

using TcpSocket =
    boost::asio::basic_stream_socket<boost::asio::ip::tcp, boost::asio::io_context::executor_type>;

// `surplus`: it gets a 503 for its request.
[[nodiscard]] std::shared_ptr<ClientLink> make_plain_connection(ServerCore& core, TcpSocket socket,
                                                                const ClientLink::Endpoint& peer,
                                                                bool surplus);
[[nodiscard]] std::shared_ptr<ClientLink> make_tls_connection(ServerCore& core, TcpSocket socket,
                                                              const ClientLink::Endpoint& peer, bool surplus,
                                                              boost::asio::ssl::context& tls);

}  // namespace gaitway::api
