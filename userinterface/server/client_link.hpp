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

#include "client_inbox.hpp"
#include "gaitway/api/session.hpp"
#include "outgoing_queue.hpp"
#include "server_core.hpp"
#include "urgent_share.hpp"

namespace gaitway::api {

class ClientLink : public Connection,
                   public FairTurns::Worker,
                   public std::enable_shared_from_this<ClientLink> {
 public:
  using Endpoint = boost::asio::ip::tcp::endpoint;

  // `surplus`: takes nobody's place, and is only told that there is none.
  ClientLink(ServerCore& core, const Endpoint& peer, bool surplus, std::int64_t now_ns);

  // Connection: all only take note, and act from the server's loop.
  void wake() noexcept final;
  void shown_wrong_token() noexcept final;
  [[nodiscard]] std::int64_t message_age_ns(std::int64_t wall_ns) const noexcept final {
    return wall_ns - sent_after_ns_;
  }
  void close(std::uint16_t code, std::string_view reason) noexcept final;

  // FairTurns::Worker: the session takes the oldest message that waits.
  bool work() final;

  virtual void start() = 0;
  // Takes what has come of the handshake over TLS, which costs up to some milliseconds.
  virtual void shake_hands() = 0;
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
  // The client gives it back: see answered_ping().
  virtual void begin_ping(std::int64_t now_ns) = 0;
  virtual void raw_written() = 0;
  virtual void read() = 0;
  virtual void answer_refusal() = 0;
  virtual void cut_socket() noexcept = 0;
  virtual void widen_send_buffer() noexcept = 0;
  // Buffers of the queue are in use by a write that is under way.
  [[nodiscard]] virtual bool holds_gathered() const noexcept = 0;

  // Told by the WebSocket.
  void refusing();  // an answer is being written
  // answer_refusal() comes as late as the address must wait for it. `origin`: of a web page, or empty.
  void refuse(Refusal cause, const std::string& detail);
  void giving_page();  // a file of the page is being written
  void opened(bool authorised, bool view);
  void received(std::string_view message, bool binary);
  void heard(std::size_t bytes);
  void control_frame();
  // What it sends from now on it has sent after that ping had reached it.
  void answered_ping(std::int64_t pinged_ns) noexcept;
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
  // What follows is read now, or once there is room for it.
  void read_on();
  void pinged() noexcept { pinging_ = false; }

 private:
  enum class Phase : std::uint8_t { handshake, refused, refusing, open, closing, over };

  void fill(std::int64_t now_ns);
  void drop_session() noexcept;
  // Ends the session once it has taken what waits.
  void let_session_finish() noexcept;
  void sweep_open(std::int64_t now_ns);
  [[nodiscard]] std::int64_t ping_period_ns() const noexcept;
  [[nodiscard]] bool acknowledges(std::int64_t listened_ns) const noexcept;
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
  ClientInbox inbox_;
  OutgoingQueue queue_;
  Closing cause_ = Closing::lost;
  std::uint16_t close_code_ = 0;
  std::string close_reason_;
  bool woken_ = false, blocked_ = false, pinging_ = false, was_open_ = false;
  bool close_asked_ = false;
  bool in_line_ = false;        // for its turn
  bool reading_rests_ = false;  // since the inbox is full
  std::int64_t deadline_ns_;    // of handshake, refusal (its begin, then its end), closing
  std::int64_t pinged_ns_ = 0, second_ns_ = 0;
  std::int64_t silent_until_ns_ = 0;  // before then it is told nothing, since it guesses tokens
  std::int64_t answered_ns_ = 0;      // the newest ping that the client has answered, or when it was let in
  std::int64_t sent_after_ns_ = 0;    // of the message that is being taken
  std::int64_t heard_ns_ = 0, front_ns_ = 0;  // by the time in which it was listened to
  unsigned control_frames_ = 0;
  UrgentShare urgent_share_;
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
