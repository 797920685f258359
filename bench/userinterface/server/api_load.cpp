// Many clients at once: each subscribes to every topic at its full rate and reads what comes, but for some
// that read nothing. Prints what they got. Run by api_load.py beside `gaitway serve`.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <cstdint>
#include <deque>
#include <string>

#include "gaitway/api/publication.hpp"

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
using tcp = asio::ip::tcp;

class Client {
 public:
  Client(asio::io_context& io, const tcp::endpoint& server, bool reads, bool cbor)
      : socket_(io), server_(server), reads_(reads), cbor_(cbor) {}

  void start() {
    socket_.next_layer().async_connect(server_, [this](beast::error_code error) {
      if (error) {
        return end(error);
      }
      socket_.async_handshake("127.0.0.1", "/", [this](beast::error_code refused) {
        if (refused) {
          return end(refused);
        }
        open_ = true;
        subscribe(0);
        if (reads_) {
          read();
        }
      });
    });
  }
  [[nodiscard]] bool open() const noexcept { return open_; }
  [[nodiscard]] std::uint64_t messages() const noexcept { return messages_; }
  [[nodiscard]] std::uint64_t bytes() const noexcept { return bytes_; }
  [[nodiscard]] std::uint64_t told() const noexcept { return told_; }

 private:
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
  void end(beast::error_code) { open_ = false; }

  beast::websocket::stream<tcp::socket> socket_;
  tcp::endpoint server_;
  bool reads_, cbor_;
  bool open_ = false;
  std::string request_;
  beast::flat_buffer buffer_;
  std::uint64_t messages_ = 0, bytes_ = 0, told_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Clients of a robot API that subscribe to everything"};
  std::uint16_t port = 9090;
  int clients = 200, silent = 10;
  double seconds = 10.0;
  app.add_option("--port", port)->capture_default_str();
  app.add_option("--clients", clients, "How many")->capture_default_str();
  app.add_option("--silent", silent, "Of these, how many read nothing")->capture_default_str();
  app.add_option("--seconds", seconds)->capture_default_str();
  app.footer("Example:\n  api_load --port 9090 --clients 200 --seconds 60");
  CLI11_PARSE(app, argc, argv);

  asio::io_context io;
  const tcp::endpoint server(asio::ip::make_address("127.0.0.1"), port);
  std::deque<Client> all;
  for (int i = 0; i < clients; ++i) {
    all.emplace_back(io, server, i >= silent, i % 2 == 0);
    all.back().start();
  }
  asio::steady_timer over(
      io, std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(seconds)));
  over.async_wait([&io](beast::error_code) { io.stop(); });
  io.run();

  std::uint64_t messages = 0, bytes = 0, told = 0, fewest = ~std::uint64_t{0};
  int open = 0;
  for (int i = 0; i < clients; ++i) {
    const Client& client = all[static_cast<std::size_t>(i)];
    messages += client.messages();
    bytes += client.bytes();
    told += client.told();
    if (i >= silent) {
      open += client.open() ? 1 : 0;
      fewest = std::min(fewest, client.messages());
    }
  }
  fmt::print(
      R"({{"clients": {}, "silent": {}, "open": {}, "messages": {}, "bytes": {}, "statuses": {}, "fewest_messages": {}}})"
      "\n",
      clients, silent, open, messages, bytes, told, fewest);
  return open == clients - silent ? 0 : 3;
}
