// One implementation for both kinds of stream.
#include "websocket_client.hpp"

#include <openssl/ssl.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/ssl/ssl_stream.hpp>
#include <boost/beast/websocket/ssl.hpp>
#include <boost/beast/websocket/stream.hpp>

namespace gaitway::api {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = boost::beast::websocket;
using asio::ip::tcp;

asio::ssl::context any_certificate(int highest_tls) {
  asio::ssl::context context(asio::ssl::context::tls_client);
  context.set_verify_mode(asio::ssl::verify_none);
  if (highest_tls != 0) {
    SSL_CTX_set_security_level(context.native_handle(), 0);  // or it would not even offer the old ones
    SSL_CTX_set_min_proto_version(context.native_handle(), 0);
    SSL_CTX_set_max_proto_version(context.native_handle(), highest_tls);
  }
  return context;
}

}  // namespace

class WebSocketClient::Impl {
 public:
  virtual ~Impl() = default;
  virtual void send(std::string_view message, bool binary) = 0;
  virtual void send_in_fragments(std::string_view message, std::size_t bytes) = 0;
  virtual Message receive() = 0;
  virtual unsigned receive_close() = 0;
  virtual void close() = 0;
};

template <class Stream>
class WebSocketClient::Over final : public Impl {
 public:
  Over(std::uint16_t port, const Options& options)
      : tls_(any_certificate(options.highest_tls)), socket_(make()) {
    beast::get_lowest_layer(socket_).connect({asio::ip::address_v4::loopback(), port});
    if constexpr (!std::is_same_v<Stream, tcp::socket>) {
      socket_.next_layer().handshake(asio::ssl::stream_base::client);
    }
    socket_.set_option(websocket::stream_base::decorator([&](websocket::request_type& request) {
      for (const auto& [name, value] : options.headers) {
        request.set(name, value);
      }
    }));
    socket_.handshake("localhost", options.target);
  }

  void send(std::string_view message, bool binary) override {
    socket_.binary(binary);
    socket_.write(asio::buffer(message.data(), message.size()));
  }
  void send_in_fragments(std::string_view message, std::size_t bytes) override {
    socket_.text(true);
    while (!message.empty()) {
      const std::string_view part = message.substr(0, bytes);
      message.remove_prefix(part.size());
      socket_.write_some(message.empty(), asio::buffer(part.data(), part.size()));
    }
  }
  Message receive() override {
    beast::flat_buffer buffer;
    socket_.read(buffer);
    return {beast::buffers_to_string(buffer.data()), socket_.got_binary()};
  }
  unsigned receive_close() override {
    beast::error_code error;
    while (!error) {
      beast::flat_buffer buffer;
      socket_.read(buffer, error);
    }
    return error == websocket::error::closed ? socket_.reason().code : 0;
  }
  void close() override { socket_.close(websocket::close_code::normal); }

 private:
  websocket::stream<Stream> make() {
    if constexpr (std::is_same_v<Stream, tcp::socket>) {
      return websocket::stream<Stream>(io_);
    } else {
      return websocket::stream<Stream>(io_, tls_);
    }
  }

  asio::io_context io_{1};
  asio::ssl::context tls_;
  websocket::stream<Stream> socket_;
};

WebSocketClient::WebSocketClient(std::uint16_t port) : WebSocketClient(port, Options{}) {}

WebSocketClient::WebSocketClient(std::uint16_t port, const Options& options) {
  if (options.tls) {
    impl_ = std::make_unique<Over<beast::ssl_stream<tcp::socket>>>(port, options);
  } else {
    impl_ = std::make_unique<Over<tcp::socket>>(port, options);
  }
}

WebSocketClient::~WebSocketClient() = default;

void WebSocketClient::send(std::string_view message, bool binary) {
  impl_->send(message, binary);
}

void WebSocketClient::send_in_fragments(std::string_view message, std::size_t bytes) {
  impl_->send_in_fragments(message, bytes);
}

WebSocketClient::Message WebSocketClient::receive() {
  return impl_->receive();
}

unsigned WebSocketClient::receive_close() {
  return impl_->receive_close();
}

void WebSocketClient::close() {
  impl_->close();
}

std::string client_hello() {
  const std::unique_ptr<SSL_CTX, decltype(&SSL_CTX_free)> context(SSL_CTX_new(TLS_client_method()),
                                                                  SSL_CTX_free);
  const std::unique_ptr<SSL, decltype(&SSL_free)> client(SSL_new(context.get()), SSL_free);
  BIO* const out = BIO_new(BIO_s_mem());
  SSL_set_bio(client.get(), BIO_new(BIO_s_mem()), out);  // which it owns
  SSL_connect(client.get());
  std::string hello(static_cast<std::size_t>(BIO_pending(out)), '\0');
  BIO_read(out, hello.data(), static_cast<int>(hello.size()));
  return hello;
}

}  // namespace gaitway::api
