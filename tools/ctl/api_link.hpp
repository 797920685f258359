// The WebSocket to the robot API. Every step ends by a deadline, whatever the other side leaves undone.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/ssl.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/ssl.hpp>
#include <boost/beast/websocket.hpp>
#include <boost/beast/websocket/ssl.hpp>
#include <chrono>
#include <deque>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <variant>

#include "tools/ctl/api_client.hpp"

namespace gaitway::tools {

// Blocks; for one thread. Throws ApiError, and NoAnswer past a deadline, after which nothing can be asked.
class ApiLink {
 public:
  using Time = std::chrono::steady_clock::time_point;

  explicit ApiLink(const ApiAddress& address);
  ~ApiLink();
  ApiLink(const ApiLink&) = delete;
  ApiLink& operator=(const ApiLink&) = delete;

  // Of what is begun now.
  [[nodiscard]] Time deadline() const;
  void write(const nlohmann::json& message, Time deadline);
  // Nothing past the deadline, or when interrupted.
  std::optional<nlohmann::json> read(Time deadline);
  // Until then, or until interrupted.
  void wait(Time end);
  // While it heeds signals, the first SIGINT or SIGTERM interrupts; a second one ends the program.
  void heed_signals(bool heed);
  [[nodiscard]] bool interrupted() const noexcept { return heeds_signals_ && signalled_; }
  // As the other side names itself, "gaitway/0.1.0"; empty: it does not.
  [[nodiscard]] const std::string& server() const noexcept { return server_; }
  // The other side is not waited for any more, nor told of the end.
  void give_up() noexcept;

 private:
  using Tcp = boost::asio::ip::tcp::socket;
  using Plain = boost::beast::websocket::stream<Tcp>;
  using Secure = boost::beast::websocket::stream<boost::asio::ssl::stream<Tcp>>;
  using Error = boost::beast::error_code;

  void open();
  std::unique_ptr<Secure> secure_socket(const std::string& host);
  template <class Socket>
  void shake_hands(Socket& socket, const std::string& host, Time deadline);
  void start_reading();
  template <class Start>
  void complete(const Start& start, Time deadline);
  template <class Done>
  void run_until(Time deadline, const Done& done);

  ApiAddress address_;
  std::string server_;
  boost::asio::io_context io_;
  boost::asio::signal_set signals_{io_};
  boost::asio::ssl::context tls_{boost::asio::ssl::context::tls_client};
  std::variant<std::unique_ptr<Plain>, std::unique_ptr<Secure>> socket_;
  boost::beast::flat_buffer buffer_;
  std::deque<std::string> received_;
  std::optional<Error> ended_;  // nothing comes any more
  bool heeds_signals_ = false, signalled_ = false;
};

}  // namespace gaitway::tools
