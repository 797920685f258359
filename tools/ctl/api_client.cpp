// Beast's blocking WebSocket, with time-outs of the socket's.
#include "tools/ctl/api_client.hpp"

#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/time.h>

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/ssl.hpp>
#include <boost/beast/websocket.hpp>
#include <boost/beast/websocket/ssl.hpp>
#include <cmath>
#include <deque>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string_view>
#include <variant>

namespace gaitway::tools {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
using tcp = asio::ip::tcp;

struct Url {
  bool tls = false;
  std::string host, port;
};

Url parse_url(const std::string& url) {
  Url result;
  std::string_view rest = url;
  if (rest.starts_with("wss://")) {
    result.tls = true;
    rest.remove_prefix(6);
  } else if (rest.starts_with("ws://")) {
    rest.remove_prefix(5);
  } else {
    throw ApiError(
        fmt::format("--url {}: must begin with ws:// or wss://, for example ws://127.0.0.1:9090", url));
  }
  rest = rest.substr(0, rest.find('/'));
  const std::size_t bracket = rest.find(']');
  const std::size_t colon = rest.find(':', bracket == std::string_view::npos ? 0 : bracket);
  result.host = rest.substr(0, colon);
  if (bracket != std::string_view::npos && result.host.starts_with('[')) {
    result.host = result.host.substr(1, bracket - 1);
  }
  result.port = colon == std::string_view::npos ? (result.tls ? "443" : "80") : rest.substr(colon + 1);
  if (result.host.empty() || result.port.empty()) {
    throw ApiError(fmt::format("--url {}: needs host and port, for example ws://127.0.0.1:9090", url));
  }
  return result;
}

std::string read_token(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string token;
  if (!stream.is_open() || !std::getline(stream, token) || token.empty()) {
    throw ApiError(fmt::format("--token-file {}: cannot be read, or its first line is empty", file.string()));
  }
  return token;
}

}  // namespace

class ApiClient::Link {
 public:
  explicit Link(const ApiAddress& address) : address_(address) {
    const Url url = parse_url(address.url);
    try {
      open(url);
    } catch (const boost::system::system_error& error) {
      throw ApiError(fmt::format("{}: {}. Is the robot API running there (gaitway serve)?", address.url,
                                 error.code().message()));
    }
  }
  ~Link() {
    beast::error_code ignored;
    std::visit([&ignored](auto& socket) { socket->close(beast::websocket::close_code::normal, ignored); },
               socket_);
  }
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;

  void write(const nlohmann::json& message) {
    guarded([&] {
      const std::string text = message.dump();
      std::visit([&text](auto& socket) { socket->write(asio::buffer(text)); }, socket_);
    });
  }
  // Nothing within the time-out.
  std::optional<nlohmann::json> read() {
    std::optional<nlohmann::json> result;
    guarded([&] {
      beast::flat_buffer buffer;
      beast::error_code error;
      std::visit([&](auto& socket) { socket->read(buffer, error); }, socket_);
      if (error == asio::error::would_block || error == asio::error::try_again) {
        return;
      }
      if (error) {
        throw boost::system::system_error(error);
      }
      const auto* const begin = static_cast<const char*>(buffer.cdata().data());
      result = nlohmann::json::parse(begin, begin + buffer.size(), nullptr, false);
      if (result->is_discarded()) {
        throw ApiError(fmt::format("{}: answers with what is no JSON", address_.url));
      }
    });
    return result;
  }
  std::deque<nlohmann::json> waiting;  // messages of topics that came while an answer was awaited
  std::deque<std::string> problems;

 private:
  using Plain = beast::websocket::stream<tcp::socket>;
  using Secure = beast::websocket::stream<asio::ssl::stream<tcp::socket>>;

  void open(const Url& url) {
    tcp::resolver resolver(io_);
    const auto endpoints = resolver.resolve(url.host, url.port);
    const auto request = [this](beast::websocket::request_type& head) {
      if (!address_.token_file.empty()) {
        head.set(beast::http::field::authorization, "Bearer " + read_token(address_.token_file));
      }
    };
    const std::string host = url.host + ":" + url.port;
    if (!url.tls) {
      auto socket = std::make_unique<Plain>(io_);
      asio::connect(socket->next_layer(), endpoints);
      limit_waiting(socket->next_layer());
      socket->set_option(beast::websocket::stream_base::decorator(request));
      handshake(*socket, host);
      socket_ = std::move(socket);
      return;
    }
    if (address_.ca_file.empty()) {
      tls_.set_default_verify_paths();
    } else {
      tls_.load_verify_file(address_.ca_file.string());
    }
    tls_.set_verify_mode(asio::ssl::verify_peer);
    auto socket = std::make_unique<Secure>(io_, tls_);
    socket->next_layer().set_verify_callback(asio::ssl::host_name_verification(url.host));
    asio::connect(beast::get_lowest_layer(*socket), endpoints);
    limit_waiting(beast::get_lowest_layer(*socket));
    SSL_set_tlsext_host_name(socket->next_layer().native_handle(), url.host.c_str());
    socket->next_layer().handshake(asio::ssl::stream_base::client);
    socket->set_option(beast::websocket::stream_base::decorator(request));
    handshake(*socket, host);
    socket_ = std::move(socket);
  }
  template <class Socket>
  void handshake(Socket& socket, const std::string& host) {
    beast::websocket::response_type response;
    beast::error_code error;
    socket.handshake(response, host, "/", error);
    if (error == beast::websocket::error::upgrade_declined) {
      throw ApiError(fmt::format("{}: refused: {} {}", address_.url, response.result_int(), response.body()));
    }
    if (error) {
      throw boost::system::system_error(error);
    }
  }
  void limit_waiting(tcp::socket& socket) const {
    timeval time{};
    time.tv_sec = static_cast<time_t>(address_.timeout_s);
    time.tv_usec = static_cast<suseconds_t>((address_.timeout_s - std::floor(address_.timeout_s)) * 1e6);
    setsockopt(socket.native_handle(), SOL_SOCKET, SO_RCVTIMEO, &time, sizeof time);
    setsockopt(socket.native_handle(), SOL_SOCKET, SO_SNDTIMEO, &time, sizeof time);
  }
  template <class Work>
  void guarded(const Work& work) {
    try {
      work();
    } catch (const boost::system::system_error& error) {
      throw ApiError(fmt::format("{}: the connection has ended: {}", address_.url, error.code().message()));
    }
  }

  ApiAddress address_;
  asio::io_context io_;
  asio::ssl::context tls_{asio::ssl::context::tls_client};
  std::variant<std::unique_ptr<Plain>, std::unique_ptr<Secure>> socket_;
};

ApiClient::ApiClient(const ApiAddress& address) : link_(std::make_unique<Link>(address)) {}
ApiClient::~ApiClient() = default;

ApiClient::ServiceAnswer ApiClient::call(const std::string& service, const nlohmann::json& arguments,
                                         nlohmann::json& values) {
  const std::string id = fmt::format("call_{}", ++last_id_);
  link_->write({{"op", "call_service"}, {"id", id}, {"service", service}, {"args", arguments}});
  while (const auto message = link_->read()) {
    const std::string op = message->value("op", "");
    if (op == "service_response" && message->value("id", "") == id) {
      values = message->value("values", nlohmann::json());
      const bool result = message->value("result", false);
      return {result, result ? "" : (values.is_string() ? values.get<std::string>() : values.dump())};
    }
    if (op == "publish") {
      link_->waiting.push_back(*message);
    } else if (op == "status" && message->value("level", "") == "error") {
      link_->problems.push_back(message->value("msg", ""));
    }
  }
  throw ApiError(fmt::format("{}: no answer", service));
}

void ApiClient::advertise(const std::string& topic, const std::string& type) {
  link_->write({{"op", "advertise"}, {"topic", topic}, {"type", type}});
}

void ApiClient::publish(const std::string& topic, const nlohmann::json& message) {
  link_->write({{"op", "publish"}, {"topic", topic}, {"msg", message}});
}

void ApiClient::subscribe(const std::string& topic) {
  link_->write({{"op", "subscribe"}, {"topic", topic}, {"queue_length", 1}});
}

std::optional<nlohmann::json> ApiClient::next_message() {
  while (link_->waiting.empty()) {
    auto message = link_->read();
    if (!message) {
      return std::nullopt;
    }
    const std::string op = message->value("op", "");
    if (op == "publish") {
      link_->waiting.push_back(std::move(*message));
    } else if (op == "status" && message->value("level", "") == "error") {
      throw ApiError(message->value("msg", ""));
    }
  }
  nlohmann::json message = std::move(link_->waiting.front());
  link_->waiting.pop_front();
  return message;
}

void ApiClient::throw_reported_errors() {
  if (!link_->problems.empty()) {
    const std::string problem = link_->problems.front();
    link_->problems.clear();
    throw ApiError(problem);
  }
}

}  // namespace gaitway::tools
