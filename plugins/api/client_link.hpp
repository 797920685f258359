// One connection's life: handshake, conversation, closing, each with its deadlines. What does the reading and
// writing derives from it.
#pragma once

#include <boost/asio/basic_stream_socket.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/context.hpp>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "gaitway/api/session.hpp"
#include "outgoing_queue.hpp"
#include "server_core.hpp"

namespace gaitway::api {

class ClientLink : public Connection, public std::enable_shared_from_this<ClientLink> {
 public:
  using Endpoint = boost::asio::ip::tcp::endpoint;

  // `surplus`: takes nobody's place, and is only told that there is none.
  ClientLink(ServerCore& core, const Endpoint& peer, bool surplus, std::int64_t now_ns);

  // Connection: both only take note, and act from the server's loop.
  void wake() noexcept final;
  void close(std::uint16_t code, std::string_view reason) noexcept final;

  virtual void start() = 0;
  void pump_woken(std::int64_t now_ns);
  // Deadlines and pings.
  void sweep(std::int64_t now_ns);
  // The server stops.
  void shut_down();
  // At once, without a word.
  void cut(Closing cause);

  // Whether it holds a place without being in a conversation with somebody who may be here.
  [[nodiscard]] bool may_give_way() const noexcept;
  // Leaves its place to another, at once.
  void give_way();

  [[nodiscard]] const boost::asio::ip::address& address() const noexcept { return address_; }
  [[nodiscard]] std::int64_t since_ns() const noexcept { return since_ns_; }
  [[nodiscard]] bool is_surplus() const noexcept { return surplus_; }
  [[nodiscard]] bool is_view() const noexcept { return view_; }
  std::size_t place = 0;  // in the core's table

 protected:
  // Done by the WebSocket. write_queue() writes of what waits: it calls consumed(), or blocked() and later
  // unblocked().
  virtual void write_queue() = 0;
  virtual void begin_close(std::uint16_t code, const std::string& reason) = 0;
  virtual void begin_ping() = 0;
  virtual void raw_written() = 0;
  virtual void cut_socket() noexcept = 0;
  virtual void widen_send_buffer() noexcept = 0;
  // Buffers of the queue are in use by a write that is under way.
  [[nodiscard]] virtual bool holds_gathered() const noexcept = 0;

  // Told by the WebSocket.
  void refusing(Refusal cause);  // an answer is being written
  void giving_page();            // so is a file of the page
  void opened(bool authorised, bool view);
  void received(std::string_view message, bool binary);
  void heard(std::size_t bytes);
  void control_frame();
  void client_closes();
  void library_closes();       // a close frame is on its way that nobody here asked for
  void failed(Closing cause);  // the conversation has ended
  void left(Refusal cause);    // the handshake has
  void pump(std::int64_t now_ns);
  void consumed(std::size_t bytes);
  void blocked() noexcept { blocked_ = true; }
  void unblocked() noexcept { blocked_ = false; }

  [[nodiscard]] ServerCore& core() noexcept { return core_; }
  [[nodiscard]] OutgoingQueue& queue() noexcept { return queue_; }
  // A step of the handshake may end after the deadline, or the server, has ended the connection.
  [[nodiscard]] bool in_handshake() const noexcept { return phase_ == Phase::handshake; }
  [[nodiscard]] bool reads() const noexcept { return phase_ == Phase::open; }
  void pinged() noexcept { pinging_ = false; }

 private:
  enum class Phase : std::uint8_t { handshake, refusing, open, closing, over };

  void fill(std::int64_t now_ns);
  void sweep_open(std::int64_t now_ns);
  void end_conversation(Closing cause, std::uint16_t code, const std::string& reason);
  void enter_closing(Closing cause);
  void end();

  ServerCore& core_;
  const boost::asio::ip::address address_;
  const std::string peer_;
  const std::int64_t since_ns_;
  const bool surplus_;
  bool view_ = false;
  Phase phase_ = Phase::handshake;
  std::unique_ptr<Session> session_;
  OutgoingQueue queue_;
  Closing cause_ = Closing::lost;
  std::uint16_t close_code_ = 0;
  std::string close_reason_;
  bool woken_ = false, blocked_ = false, pinging_ = false, was_open_ = false;
  bool close_asked_ = false;
  std::int64_t deadline_ns_;  // of handshake, refusal, closing
  std::int64_t heard_ns_ = 0, pinged_ns_ = 0, front_ns_ = 0, second_ns_ = 0;
  unsigned control_frames_ = 0;
};

using TcpSocket =
    boost::asio::basic_stream_socket<boost::asio::ip::tcp, boost::asio::io_context::executor_type>;

// `surplus`: it gets a 503 for its request, and holds no place.
[[nodiscard]] std::shared_ptr<ClientLink> make_plain_connection(ServerCore& core, TcpSocket socket,
                                                                const ClientLink::Endpoint& peer,
                                                                bool surplus);
[[nodiscard]] std::shared_ptr<ClientLink> make_tls_connection(ServerCore& core, TcpSocket socket,
                                                              const ClientLink::Endpoint& peer, bool surplus,
                                                              boost::asio::ssl::context& tls);

}  // namespace gaitway::api
