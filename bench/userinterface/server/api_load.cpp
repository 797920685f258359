// Many clients at once: each subscribes to every topic at its full rate and reads what comes, but for some
// that read nothing. Prints what they got. Run by api_load.py beside `gaitway serve`.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/ssl.hpp>
#include <boost/beast/websocket.hpp>
#include <boost/beast/websocket/ssl.hpp>
#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <utility>

#include "gaitway/api/publication.hpp"

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
using tcp = asio::ip::tcp;

using PlainStream = tcp::socket;
using TlsStream = beast::ssl_stream<tcp::socket>;

struct Robot {
  tcp::endpoint server;
  std::string token;  // with one it is reached over TLS
};

template <class Stream>
class Client {
 public:
  template <class... TlsContext>
  Client(asio::io_context& io, const Robot& robot, bool reads, bool cbor, TlsContext&... tls)
      : socket_(io, tls...), robot_(robot), reads_(reads), cbor_(cbor) {}

  // `then`: called once it is in, or is not let in.
  void start(std::function<void()> then) {
    then_ = std::move(then);
    beast::get_lowest_layer(socket_).async_connect(robot_.server, [this](beast::error_code error) {
      if (error) {
        return end(error);
      }
      if constexpr (std::is_same_v<Stream, TlsStream>) {
        socket_.next_layer().async_handshake(
            asio::ssl::stream_base::client,
            [this](beast::error_code refused) { refused ? end(refused) : greet(); });
      } else {
        greet();
      }
    });
  }
  [[nodiscard]] bool open() const noexcept { return open_; }
  [[nodiscard]] std::uint64_t messages() const noexcept { return messages_; }
  [[nodiscard]] std::uint64_t bytes() const noexcept { return bytes_; }
  [[nodiscard]] std::uint64_t told() const noexcept { return told_; }

 private:
  void greet() {
    socket_.async_handshake(robot_.server.address().to_string(), "/", [this](beast::error_code refused) {
      if (refused) {
        return end(refused);
      }
      open_ = true;
      go_on();
      if (robot_.token.empty()) {
        subscribe(0);
      } else {
        request_ = fmt::format(R"({{"op":"auth","token":"{}"}})", robot_.token);
        socket_.async_write(asio::buffer(request_), [this](beast::error_code error, std::size_t) {
          error ? end(error) : subscribe(0);
        });
      }
      if (reads_) {
        read();
      }
    });
  }
  void subscribe(std::size_t topic) {
    if (topic == gaitway::api::kTopicCount) {
      return;
    }
    request_ = fmt::format(R"({{"op":"subscribe","topic":"{}","queue_length":1,"compression":"{}"}})",
                           gaitway::api::kTopics[topic].name, cbor_ ? "cbor" : "none");
    socket_.async_write(asio::buffer(request_), [this, topic](beast::error_code error, std::size_t) {
      if (!error) {
        subscribe(topic + 1);
      }
    });
  }
  void read() {
    socket_.async_read(buffer_, [this](beast::error_code error, std::size_t size) {
      if (error) {
        return end(error);
      }
      ++messages_;
      bytes_ += size;
      const std::string_view start(static_cast<const char*>(buffer_.data().data()),
                                   std::min<std::size_t>(size, 16));
      if (start.find("\"status\"") != std::string_view::npos) {
        ++told_;
      }
      buffer_.consume(size);
      read();
    });
  }
  void end(beast::error_code) {
    open_ = false;
    go_on();
  }
  void go_on() {
    if (const auto then = std::exchange(then_, nullptr)) {
      then();
    }
  }

  beast::websocket::stream<Stream> socket_;
  const Robot& robot_;
  bool reads_, cbor_;
  bool open_ = false;
  std::function<void()> then_;
  std::string request_;
  beast::flat_buffer buffer_;
  std::uint64_t messages_ = 0, bytes_ = 0, told_ = 0;
};

struct Wish {
  int clients = 200, silent = 10;
  double seconds = 10.0;
};

// Runs them, and prints what they got; the exit code.
template <class Stream, class... TlsContext>
int load(const Robot& robot, const Wish& wish, TlsContext&... tls) {
  asio::io_context io;
  std::deque<Client<Stream>> all;
  for (int i = 0; i < wish.clients; ++i) {
    all.emplace_back(io, robot, i >= wish.silent, i % 2 == 0, tls...);
  }
  // One after the other: so many strangers of one address at once are not let in.
  std::function<void(std::size_t)> start = [&](std::size_t at) {
    if (at < all.size()) {
      all[at].start([&start, at] { start(at + 1); });
    }
  };
  start(0);
  asio::steady_timer over(
      io, std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(wish.seconds)));
  over.async_wait([&io](beast::error_code) { io.stop(); });
  io.run();

  std::uint64_t messages = 0, bytes = 0, told = 0, fewest = ~std::uint64_t{0};
  int open = 0;
  for (int i = 0; i < wish.clients; ++i) {
    const Client<Stream>& client = all[static_cast<std::size_t>(i)];
    messages += client.messages();
    bytes += client.bytes();
    told += client.told();
    if (i >= wish.silent) {
      open += client.open() ? 1 : 0;
      fewest = std::min(fewest, client.messages());
    }
  }
  fmt::print(
      R"({{"clients": {}, "silent": {}, "open": {}, "messages": {}, "bytes": {}, "statuses": {}, "fewest_messages": {}}})"
      "\n",
      wish.clients, wish.silent, open, messages, bytes, told, fewest);
  return open == wish.clients - wish.silent ? 0 : 3;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Clients of a robot API that subscribe to everything"};
  std::string address = "127.0.0.1", token;
  std::uint16_t port = 9090;
  Wish wish;
  app.add_option("--address", address)->capture_default_str();
  app.add_option("--port", port)->capture_default_str();
  app.add_option("--token", token, "The robot's; it is then reached over TLS, whatever its certificate");
  app.add_option("--clients", wish.clients, "How many")->capture_default_str();
  app.add_option("--silent", wish.silent, "Of these, how many read nothing")->capture_default_str();
  app.add_option("--seconds", wish.seconds)->capture_default_str();
  app.footer("Example:\n  api_load --port 9090 --clients 200 --seconds 60");
  CLI11_PARSE(app, argc, argv);

  const Robot robot{tcp::endpoint(asio::ip::make_address(address), port), token};
  if (token.empty()) {
    return load<PlainStream>(robot, wish);
  }
  asio::ssl::context tls(asio::ssl::context::tls_client);
  return load<TlsStream>(robot, wish, tls);
}
