// A server of many WebSockets that has no robot: sends each client so many messages a second of so many
// bytes, as the user interface module does to who subscribes to everything. What a crowd costs the robot
// although it is somebody else's is measured with it (crowd.py).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
using tcp = asio::ip::tcp;

struct Speech {
  std::size_t bytes = 500;
  double messages_per_s = 920.0;  // to each client
  int at_once = 9;                // in each of its turns
};

// A client, until it goes. One that does not read is written no more.
class Listener : public std::enable_shared_from_this<Listener> {
 public:
  Listener(tcp::socket socket, const Speech& speech)
      : socket_(std::move(socket)), timer_(socket_.get_executor()), speech_(speech), turn_(frames(speech)) {}
  void start() {
    socket_.next_layer().set_option(tcp::no_delay(true));
    socket_.async_accept([self = shared_from_this()](beast::error_code error) {
      if (!error) {
        self->due_ = std::chrono::steady_clock::now();
        self->read();
        self->speak();
      }
    });
  }

 private:
  // Whole, as nobody else writes.
  static std::string frames(const Speech& speech) {
    constexpr std::array<char, 2> kTextOfTwoLengthBytes{'\x81', 126};
    std::string result;
    for (int i = 0; i < speech.at_once; ++i) {
      result.append(kTextOfTwoLengthBytes.data(), kTextOfTwoLengthBytes.size());
      result += static_cast<char>(speech.bytes >> 8U);
      result += static_cast<char>(speech.bytes & 0xFFU);
      result.append(speech.bytes, 'x');
    }
    return result;
  }
  void read() {
    socket_.async_read(heard_, [self = shared_from_this()](beast::error_code error, std::size_t) {
      if (!error) {
        self->heard_.clear();
        self->read();
      }
    });
  }
  void speak() {
    asio::async_write(socket_.next_layer(), asio::buffer(turn_),
                      [self = shared_from_this()](beast::error_code error, std::size_t) {
                        if (!error) {
                          self->wait();
                        }
                      });
  }
  void wait() {
    due_ +=
        std::chrono::nanoseconds(static_cast<std::int64_t>(1e9 * speech_.at_once / speech_.messages_per_s));
    timer_.expires_at(due_);
    timer_.async_wait([self = shared_from_this()](beast::error_code error) {
      if (!error) {
        self->speak();
      }
    });
  }

  beast::websocket::stream<tcp::socket> socket_;
  asio::steady_timer timer_;
  const Speech& speech_;
  const std::string turn_;
  beast::flat_buffer heard_;
  std::chrono::steady_clock::time_point due_;
};

void accept(tcp::acceptor& listening, const Speech& speech) {
  listening.async_accept([&listening, &speech](beast::error_code error, tcp::socket socket) {
    if (!error) {
      std::make_shared<Listener>(std::move(socket), speech)->start();
      accept(listening, speech);
    }
  });
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"A server of many WebSockets that has no robot"};
  std::uint16_t port = 0;
  Speech speech;
  app.add_option("--port", port, "0: any; it is printed")->capture_default_str();
  app.add_option("--bytes", speech.bytes, "Of a message")
      ->check(CLI::Range(126, 65535))
      ->capture_default_str();
  app.add_option("--messages-per-s", speech.messages_per_s, "To each client")->capture_default_str();
  app.add_option("--at-once", speech.at_once, "Of these, in each turn")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  asio::io_context io;
  tcp::acceptor listening(io, {asio::ip::address_v4::loopback(), port});
  accept(listening, speech);
  fmt::print("serves on port {}\n", listening.local_endpoint().port());
  std::fflush(stdout);
  io.run();
}
