// One asynchronous operation after the other, each run until it has ended or its deadline has come.
#include "tools/ctl/api_link.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>

#include <algorithm>
#include <boost/asio/connect.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string_view>

#include "gaitway/input/text.hpp"

namespace gaitway::tools {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;

constexpr std::chrono::seconds kLongestClose{1};  // of a server that has answered
constexpr std::size_t kShownBody = 300;

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

std::string remedy_for(const boost::system::error_code& error, const ApiAddress& address) {
  const std::string text = error.message();
  const bool is_secure = address.url.starts_with("wss://");
  if (text.find("certificate verify failed") != std::string::npos) {
    return "Who vouches for its certificate is not known here: give that file (PEM), --ca (of a twin: "
           "--robot-ca)";
  }
  if (is_secure && text.find("wrong version number") != std::string::npos) {
    return "It does not speak TLS: ws:// instead of wss://?";
  }
  if (!is_secure && (error == asio::error::eof || error == beast::http::error::end_of_stream)) {
    return "Does it speak TLS: wss:// instead of ws://?";
  }
  return "Is the robot API running there (gaitway serve)?";
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

ApiLink::ApiLink(const ApiAddress& address) : address_(address) {
  try {
    open();
  } catch (const boost::system::system_error& error) {
    const std::string why =
        fmt::format("{}: {}. {}", address.url, error.code().message(), remedy_for(error.code(), address));
    if (error.code() == asio::error::connection_refused) throw NobodyThere(why);
    throw ApiError(why);
  }
  start_reading();
}

ApiLink::~ApiLink() {
  bool closed = false;
  if (!ended_) {
    std::visit(
        [&closed](auto& socket) {
          socket->async_close(beast::websocket::close_code::normal, [&closed](Error) { closed = true; });
        },
        socket_);
    run_until(std::min(deadline(), std::chrono::steady_clock::now() + kLongestClose),
              [&closed] { return closed; });
  }
  give_up();
}

ApiLink::Time ApiLink::deadline() const {
  return std::chrono::steady_clock::now() + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                                std::chrono::duration<double>(address_.timeout_s));
}

void ApiLink::write(const nlohmann::json& message, Time deadline) {
  const std::string text = message.dump();
  try {
    complete(
        [&](auto ended) {
          std::visit([&](auto& socket) { socket->async_write(asio::buffer(text), ended); }, socket_);
        },
        deadline);
  } catch (const boost::system::system_error& error) {
    throw ApiError(fmt::format("{}: the connection has ended: {}", address_.url, error.code().message()));
  }
}

std::optional<nlohmann::json> ApiLink::read(Time deadline) {
  run_until(deadline, [this] { return !received_.empty() || ended_ || interrupted(); });
  if (received_.empty()) {
    if (ended_) {
      throw ApiError(fmt::format("{}: the connection has ended: {}", address_.url, ended_->message()));
    }
    return std::nullopt;
  }
  nlohmann::json message = nlohmann::json::parse(received_.front(), nullptr, false);
  received_.pop_front();
  if (message.is_discarded()) {
    throw ApiError(fmt::format("{}: answers with what is no JSON", address_.url));
  }
  return message;
}

void ApiLink::wait(Time end) {
  run_until(end, [this] { return ended_ || interrupted(); });
}

void ApiLink::heed_signals(bool heed) {
  heeds_signals_ = heed;
  if (heed) {
    signals_.add(SIGINT);
    signals_.add(SIGTERM);
    signals_.async_wait([this](Error error, int) {
      if (!error) {
        signalled_ = true;
        signals_.clear();
      }
    });
  }
}

void ApiLink::give_up() noexcept {
  if (!ended_) {
    ended_ = asio::error::timed_out;
  }
  signals_.cancel();
  std::visit(
      [](auto& socket) {
        Error ignored;
        beast::get_lowest_layer(*socket).close(ignored);
      },
      socket_);
  io_.restart();
  io_.run();  // every operation is told that it has failed
}

// Names are looked up by the system, which has time-outs of its own.
void ApiLink::open() {
  const Url url = parse_url(address_.url);
  asio::ip::tcp::resolver resolver(io_);
  const auto endpoints = resolver.resolve(url.host, url.port);
  if (url.tls) {
    socket_ = secure_socket(url.host);
  } else {
    socket_ = std::make_unique<Plain>(io_);
  }
  const Time end = deadline();
  complete(
      [&](auto ended) {
        std::visit(
            [&](auto& socket) { asio::async_connect(beast::get_lowest_layer(*socket), endpoints, ended); },
            socket_);
      },
      end);
  // Programs that are started meanwhile do not get it.
  std::visit(
      [](auto& socket) { fcntl(beast::get_lowest_layer(*socket).native_handle(), F_SETFD, FD_CLOEXEC); },
      socket_);
  if (auto* const secure = std::get_if<std::unique_ptr<Secure>>(&socket_)) {
    auto& tls = (*secure)->next_layer();
    complete([&](auto ended) { tls.async_handshake(asio::ssl::stream_base::client, ended); }, end);
  }
  std::visit([&](auto& socket) { shake_hands(*socket, url.host + ":" + url.port, end); }, socket_);
}

std::unique_ptr<ApiLink::Secure> ApiLink::secure_socket(const std::string& host) {
  if (address_.ca_file.empty()) {
    tls_.set_default_verify_paths();
  } else {
    tls_.load_verify_file(address_.ca_file.string());
  }
  tls_.set_verify_mode(asio::ssl::verify_peer);
  auto socket = std::make_unique<Secure>(io_, tls_);
  if (!address_.any_name) {
    socket->next_layer().set_verify_callback(asio::ssl::host_name_verification(host));
  }
  SSL_set_tlsext_host_name(socket->next_layer().native_handle(), host.c_str());
  return socket;
}

template <class Socket>
void ApiLink::shake_hands(Socket& socket, const std::string& host, Time deadline) {
  socket.set_option(beast::websocket::stream_base::decorator([this](beast::websocket::request_type& head) {
    if (!address_.token_file.empty()) {
      head.set(beast::http::field::authorization, "Bearer " + read_token(address_.token_file));
    }
  }));
  beast::websocket::response_type response;
  try {
    complete([&](auto ended) { socket.async_handshake(response, host, "/", ended); }, deadline);
    const auto server = response[beast::http::field::server];
    server_.assign(server.data(), server.size());
  } catch (const boost::system::system_error& error) {
    if (error.code() != beast::websocket::error::upgrade_declined) {
      throw;
    }
    const std::string why = fmt::format("{}: refused: {} {}", address_.url, response.result_int(),
                                        input::terminal_text(response.body().substr(0, kShownBody)));
    const bool is_right = response.result() == beast::http::status::unauthorized ||
                          response.result() == beast::http::status::forbidden;
    if (is_right) throw NotLetIn(why);
    throw ApiError(why);
  }
}

void ApiLink::start_reading() {
  std::visit(
      [this](auto& socket) {
        socket->async_read(buffer_, [this](Error error, std::size_t) {
          if (error) {
            ended_ = error;
            return;
          }
          received_.push_back(beast::buffers_to_string(buffer_.cdata()));
          buffer_.clear();
          start_reading();
        });
      },
      socket_);
}

// `start` is given what is to be called at the operation's end.
template <class Start>
void ApiLink::complete(const Start& start, Time deadline) {
  std::optional<Error> result;
  start([&result](Error error, const auto&...) { result = error; });
  run_until(deadline, [&result] { return result.has_value(); });
  if (!result) {
    give_up();
    throw NoAnswer(fmt::format("{}: no answer within {:g} s", address_.url, address_.timeout_s));
  }
  if (*result) {
    throw boost::system::system_error(*result);
  }
}

template <class Done>
void ApiLink::run_until(Time deadline, const Done& done) {
  io_.restart();
  while (!done() && io_.run_one_until(deadline) != 0) {
  }
}

}  // namespace gaitway::tools
