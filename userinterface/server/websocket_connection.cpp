// The reading and writing of one connection, over plain TCP or TLS.
#include <boost/asio/io_context.hpp>
#include <boost/asio/socket_base.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/ssl/ssl_stream.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <charconv>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include "client_link.hpp"
#include "gathering_stream.hpp"
#include "handshake_check.hpp"
#include "page_answer.hpp"

namespace gaitway::api {

namespace beast = boost::beast;
namespace websocket = boost::beast::websocket;
using TlsStream = beast::ssl_stream<TcpSocket>;

// `Stream`: TcpSocket or TlsStream.
template <class Stream>
class WebSocketConnection final : public ClientLink {
 public:
  static constexpr bool kTls = std::is_same_v<Stream, TlsStream>;

  WebSocketConnection(ServerCore& core, const Endpoint& peer, bool surplus, Stream stream)
      : ClientLink(core, peer, surplus, wall_now_ns()),
        socket_(std::move(stream), [this](const std::string& bytes) { append_raw(bytes); }),
        request_bytes_(core.options.header_bytes),
        message_(core.options.limits.message_bytes + kReadSlack) {
    tcp().non_blocking(true, ignored_);
  }

  void start() override;
  void shake_hands() override;

 private:
  using ErrorCode = beast::error_code;
  static constexpr std::size_t kReadSlack = 4096;
  // At once of one client: a stop behind a hundred others' large messages waits for so much of each.
  static constexpr std::size_t kReadBytes = 4096;
  static constexpr unsigned char kCloseFrame = 0x88;

  [[nodiscard]] auto self() { return std::static_pointer_cast<WebSocketConnection>(shared_from_this()); }
  [[nodiscard]] auto& stream() { return socket_.next_layer().next_layer(); }
  [[nodiscard]] TcpSocket& tcp() { return beast::get_lowest_layer(socket_); }

  void await_hello();
  void read_request();
  void decide(ErrorCode error);
  void refuse(HandshakeRefusal refusal);
  void answer_refusal() override;
  void give_page();
  void await_end();
  void accept(bool authorised);
  void serve(bool authorised);
  void watch_control_frames();
  void read() override;
  void take(ErrorCode error, std::size_t bytes);
  void append_raw(const std::string& bytes);

  void write_queue() override;
  void begin_close(std::uint16_t code, const std::string& reason) override;
  void begin_ping(std::int64_t now_ns) override;
  void raw_written() override { socket_.next_layer().end_write({}); }
  void cut_socket() noexcept override;
  void widen_send_buffer() noexcept override;
  [[nodiscard]] bool holds_gathered() const noexcept override { return kTls; }

  websocket::stream<GatheringStream<Stream>, false> socket_;
  beast::flat_buffer request_bytes_;
  http::request_parser<http::empty_body> request_;
  HttpAnswer answer_;
  PageAnswer page_;
  std::optional<http::response_serializer<PageAnswer::body_type>> head_;
  beast::flat_buffer message_;
  ErrorCode ignored_;
};

template <class Stream>
void WebSocketConnection<Stream>::start() {
  if constexpr (kTls) {
    await_hello();
  } else {
    read_request();
  }
}

template <class Stream>
void WebSocketConnection<Stream>::await_hello() {
  tcp().async_wait(TcpSocket::wait_read, [self = self()](ErrorCode error) {
    if (error) {
      self->left(Refusal::tls);
    } else if (self->in_handshake()) {
      self->core().want_handshake(self);
    }
  });
}

template <class Stream>
void WebSocketConnection<Stream>::shake_hands() {
  if constexpr (kTls) {
    if (!in_handshake()) {
      return;
    }
    ErrorCode error;
    stream().handshake(boost::asio::ssl::stream_base::server, error);
    if (error == boost::asio::error::would_block) {
      await_hello();
    } else if (error) {
      left(Refusal::tls);
    } else {
      read_request();
    }
  }
}

template <class Stream>
void WebSocketConnection<Stream>::read_request() {
  request_.header_limit(static_cast<std::uint32_t>(core().options.header_bytes));
  http::async_read_header(socket_.next_layer(), request_bytes_, request_,
                          [self = self()](ErrorCode error, std::size_t) { self->decide(error); });
}

template <class Stream>
void WebSocketConnection<Stream>::decide(ErrorCode error) {
  if (!in_handshake()) {
    return;
  }
  if (error == http::error::header_limit || error == http::error::buffer_overflow) {
    refuse(
        {http::status::request_header_fields_too_large, Refusal::bad_request,
         "the request's header is longer than " + std::to_string(core().options.header_bytes) + " bytes\n"});
  } else if (error == http::error::end_of_stream || error == http::error::partial_message ||
             (error && error.category() != make_error_code(http::error::bad_method).category())) {
    left(Refusal::left);
  } else if (error) {
    refuse({http::status::bad_request, Refusal::bad_request,
            "this is no HTTP request: " + error.message() + "\n"});
  } else if (is_surplus()) {
    refuse({http::status::service_unavailable, Refusal::too_many,
            "there are too many connections, to the robot or from your address: try again later\n"});
  } else if (core().page.assets != nullptr && !websocket::is_upgrade(request_.get())) {
    give_page();
  } else if (auto refusal = check_handshake(request_.get(), core().setup, core().page.view != nullptr,
                                            core().page.version)) {
    refuse(std::move(*refusal));
  } else if (!request_.is_done() || request_bytes_.size() > 0) {
    refuse({http::status::bad_request, Refusal::bad_request,
            "bytes follow the request before its answer: a WebSocket's handshake has no body\n"});
  } else {
    accept(is_authorised(request_.get(), core().setup.token()));
  }
}

template <class Stream>
void WebSocketConnection<Stream>::refuse(HandshakeRefusal refusal) {
  answer_ = answer(refusal);
  ClientLink::refuse(refusal.cause, refusal.detail);
}

template <class Stream>
void WebSocketConnection<Stream>::answer_refusal() {
  refusing();
  http::async_write(socket_.next_layer(), answer_,
                    [self = self()](ErrorCode, std::size_t) { self->await_end(); });
}

template <class Stream>
void WebSocketConnection<Stream>::give_page() {
  auto answer = answer_page(request_.get(), *core().page.assets, core().setup);
  if (auto* const refusal = std::get_if<HandshakeRefusal>(&answer)) {
    refuse(std::move(*refusal));
    return;
  }
  giving_page();
  page_ = std::move(std::get<PageAnswer>(answer));
  const auto finish = [self = self()](ErrorCode, std::size_t) { self->await_end(); };
  if (request_.get().method() == http::verb::head) {
    head_.emplace(page_);
    http::async_write_header(socket_.next_layer(), *head_, finish);
  } else {
    http::async_write(socket_.next_layer(), page_, finish);
  }
}

// The client closes first: if it had sent more, closing here would reset the connection, and take the answer
// with it.
template <class Stream>
void WebSocketConnection<Stream>::await_end() {
  tcp().shutdown(TcpSocket::shutdown_send, ignored_);
  request_bytes_.clear();
  tcp().async_read_some(request_bytes_.prepare(request_bytes_.max_size()),
                        [self = self()](ErrorCode error, std::size_t) {
                          if (error) {
                            self->left(Refusal::left);
                          } else {
                            self->await_end();
                          }
                        });
}

template <class Stream>
void WebSocketConnection<Stream>::accept(bool authorised) {
  socket_.read_message_max(core().options.limits.message_bytes);
  socket_.set_option(websocket::stream_base::decorator(
      [](websocket::response_type& response) { response.set(http::field::server, kServerName); }));
  socket_.async_accept(request_.get(), [self = self(), authorised](ErrorCode error) {
    if (!self->in_handshake()) {
      return;
    }
    if (!error) {
      self->serve(authorised);
    } else if (error.category() == make_error_code(websocket::error::bad_sec_key).category()) {
      self->core().statistics.count(Refusal::bad_request);  // Beast has answered 400
      self->refusing();
      self->await_end();
    } else {
      self->left(Refusal::left);
    }
  });
}

template <class Stream>
void WebSocketConnection<Stream>::serve(bool authorised) {
  watch_control_frames();
  opened(authorised, asks_for_view(request_.get()));
  read_on();
}

template <class Stream>
void WebSocketConnection<Stream>::watch_control_frames() {
  socket_.control_callback([this](websocket::frame_type kind, beast::string_view payload) {
    if (kind == websocket::frame_type::close) {
      client_closes();
      return;
    }
    control_frame();
    std::int64_t pinged_ns = 0;
    const char* const end = payload.data() + payload.size();
    if (kind == websocket::frame_type::pong && std::from_chars(payload.data(), end, pinged_ns).ptr == end) {
      answered_ping(pinged_ns);
    }
  });
}

template <class Stream>
void WebSocketConnection<Stream>::read() {
  socket_.async_read_some(message_, kReadBytes,
                          [self = self()](ErrorCode error, std::size_t bytes) { self->take(error, bytes); });
}

template <class Stream>
void WebSocketConnection<Stream>::take(ErrorCode error, std::size_t bytes) {
  if (error == websocket::error::closed) {
    failed(Closing::by_client);
  } else if (error == websocket::error::message_too_big || error == websocket::error::buffer_overflow) {
    failed(Closing::too_big);
  } else if (error == websocket::condition::protocol_violation) {
    failed(Closing::protocol_error);
  } else if (error) {
    failed(Closing::lost);
  } else {
    heard(bytes);
    if (socket_.is_message_done()) {
      const auto data = message_.data();
      received({static_cast<const char*>(data.data()), data.size()}, socket_.got_binary());
      message_.consume(data.size());
    }
    read_on();
  }
}

template <class Stream>
void WebSocketConnection<Stream>::append_raw(const std::string& bytes) {
  const bool closes = static_cast<unsigned char>(bytes.front()) == kCloseFrame;
  queue().append_raw(bytes);
  if (closes) {
    library_closes();
  }
  wake();
}

template <class Stream>
void WebSocketConnection<Stream>::write_queue() {
  if constexpr (kTls) {
    blocked();
    stream().async_write_some(queue().gather(), [self = self()](ErrorCode error, std::size_t bytes) {
      self->unblocked();
      if (error) {
        self->failed(Closing::lost);
      } else {
        self->consumed(bytes);
        self->pump(wall_now_ns());
      }
    });
  } else {
    ErrorCode error;
    const std::size_t bytes = tcp().write_some(queue().gather(), error);
    if (error == boost::asio::error::would_block) {
      blocked();
      tcp().async_wait(TcpSocket::wait_write, [self = self()](ErrorCode wait_error) {
        self->unblocked();
        if (!wait_error) {
          self->pump(wall_now_ns());
        }
      });
    } else if (error) {
      failed(Closing::lost);
    } else {
      consumed(bytes);
    }
  }
}

template <class Stream>
void WebSocketConnection<Stream>::begin_close(std::uint16_t code, const std::string& reason) {
  socket_.async_close(websocket::close_reason(static_cast<websocket::close_code>(code), reason),
                      [self = self()](ErrorCode) { self->failed(Closing::lost); });
}

template <class Stream>
void WebSocketConnection<Stream>::begin_ping(std::int64_t now_ns) {
  websocket::ping_data payload;
  payload.append(std::to_string(now_ns));
  socket_.async_ping(payload, [self = self()](ErrorCode) { self->pinged(); });
}

template <class Stream>
void WebSocketConnection<Stream>::cut_socket() noexcept {
  tcp().close(ignored_);
  socket_.next_layer().end_write(boost::asio::error::operation_aborted);
}

template <class Stream>
void WebSocketConnection<Stream>::widen_send_buffer() noexcept {
  tcp().set_option(
      boost::asio::socket_base::send_buffer_size(static_cast<int>(2 * core().options.send_buffer_bytes)),
      ignored_);
}

std::shared_ptr<ClientLink> make_plain_connection(ServerCore& core, TcpSocket socket,
                                                  const ClientLink::Endpoint& peer, bool surplus) {
  return std::make_shared<WebSocketConnection<TcpSocket>>(core, peer, surplus, std::move(socket));
}

std::shared_ptr<ClientLink> make_tls_connection(ServerCore& core, TcpSocket socket,
                                                const ClientLink::Endpoint& peer, bool surplus,
                                                boost::asio::ssl::context& tls) {
  return std::make_shared<WebSocketConnection<TlsStream>>(core, peer, surplus,
                                                          TlsStream(std::move(socket), tls));
}

}  // namespace gaitway::api
