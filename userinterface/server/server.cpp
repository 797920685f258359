// Accepts connections, keeps the time, and ends it all.
#include "gaitway/api/server.hpp"

#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <boost/asio/error.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cerrno>
#include <chrono>
#include <optional>
#include <utility>

#include "client_link.hpp"
#include "server_core.hpp"

namespace gaitway::api {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;

// Beyond the limit, so many more may wait for the answer that there are too many.
constexpr std::size_t kSurplus = 32;
// Taken in one turn; then the others have theirs.
constexpr int kAcceptsInATurn = 16;

// An IPv4 client at an IPv6 socket is the same client.
tcp::endpoint plain(const tcp::endpoint& peer) {
  const auto address = peer.address();
  if (address.is_v6() && address.to_v6().is_v4_mapped()) {
    return {asio::ip::make_address_v4(asio::ip::v4_mapped, address.to_v6()), peer.port()};
  }
  return peer;
}

// What concerns the one client that waited, and not those after it (accept(2)).
bool is_of_one_client(int error) {
  switch (error) {
    case EINTR:
    case ECONNABORTED:
    case EPROTO:
    case ENETDOWN:
    case ENETUNREACH:
    case EHOSTDOWN:
    case EHOSTUNREACH:
    case ENOPROTOOPT:
    case ENONET:
    case EOPNOTSUPP:
    case ETIMEDOUT:
      return true;
    default:
      return false;
  }
}

}  // namespace

class Server::Impl {
 public:
  Impl(SessionHub& hub, ServerSetup setup, ServerCallbacks callbacks, const ServerPage& page)
      : setup_(std::move(setup)),
        callbacks_(std::move(callbacks)),
        core_(hub, setup_, page),
        listener_(core_.io),
        timer_(core_.io),
        period_ns_(callbacks_.on_poll ? setup_.options().poll_ns : setup_.options().tick_ns) {
    if (TlsContext tls = setup_.take_tls()) {
      tls_.emplace(tls.release());
    }
    process::FileDescriptor listening = setup_.take_listener();
    listener_.assign(setup_.is_ipv6() ? tcp::v6() : tcp::v4(), listening.get());
    static_cast<void>(listening.release());
  }

  ~Impl() {
    stop_listening();
    timer_.cancel();
    while (!core_.links().empty()) {
      core_.links().back()->cut(Closing::shut_down);
    }
    core_.io.restart();
    core_.io.poll();  // the handlers let go of what they hold
  }

  void run() {
    await_clients();
    due_ns_ = ticked_ns_ = wall_now_ns();
    keep_time();
    core_.io.run();
  }

  void stop() {
    asio::post(core_.io, [this] {
      if (std::exchange(stopping_, true)) {
        return;
      }
      stop_listening();
      for (std::size_t at = core_.links().size(); at-- > 0;) {
        core_.links()[at]->shut_down();
      }
    });
  }

  [[nodiscard]] const ServerSetup& setup() const noexcept { return setup_; }
  [[nodiscard]] const ServerStatistics& statistics() const noexcept { return core_.statistics; }

 private:
  void stop_listening() {
    boost::system::error_code ignored;
    listener_.close(ignored);
  }

  void await_clients() {
    if (!listener_.is_open()) {
      return;
    }
    listener_.async_wait(tcp::acceptor::wait_read, [this](boost::system::error_code error) {
      if (!error) {
        accept_clients();
      }
    });
  }

  // Asio would accept without the flags, and need further calls for them.
  void accept_clients() {
    for (int count = 0; count < kAcceptsInATurn; ++count) {
      tcp::endpoint peer(setup_.is_ipv6() ? tcp::v6() : tcp::v4(), 0);
      auto length = static_cast<socklen_t>(peer.capacity());
      const int socket =
          ::accept4(listener_.native_handle(), peer.data(), &length, SOCK_NONBLOCK | SOCK_CLOEXEC);
      if (socket >= 0) {
        peer.resize(length);
        add(socket, plain(peer));
        continue;
      }
      if (errno == EAGAIN || errno == EWOULDBLOCK) {
        break;
      }
      ++core_.statistics.accept_errors;
      if (!is_of_one_client(errno)) {
        accept_again_ns_ = wall_now_ns() + setup_.options().accept_pause_ns;
        return;
      }
    }
    await_clients();
  }

  void add(int descriptor, const tcp::endpoint& peer) {
    ++core_.statistics.accepted;
    TcpSocket socket(core_.io);
    boost::system::error_code error;
    socket.assign(setup_.is_ipv6() ? tcp::v6() : tcp::v4(), descriptor, error);
    const bool surplus = !error && !core_.make_room_for(peer.address());
    if (error || (surplus && core_.surplus_links() >= kSurplus)) {
      core_.statistics.count(Refusal::too_many);
      if (error) {
        ::close(descriptor);
      }
      return;
    }
    auto link = tls_ ? make_tls_connection(core_, std::move(socket), peer, surplus, *tls_)
                     : make_plain_connection(core_, std::move(socket), peer, surplus);
    core_.add(link);
    link->start();
  }

  // Due times do not drift; those that have passed already are left out.
  void keep_time() {
    const std::int64_t late_ns = std::max<std::int64_t>(wall_now_ns() - due_ns_, 0);
    due_ns_ += (late_ns / period_ns_ + 1) * period_ns_;
    timer_.expires_at(std::chrono::steady_clock::time_point(std::chrono::nanoseconds(due_ns_)));
    timer_.async_wait([this](boost::system::error_code error) {
      if (error) {
        return;
      }
      const std::int64_t now_ns = wall_now_ns();
      if (callbacks_.on_poll) {
        callbacks_.on_poll(now_ns);
      }
      if (due_ns_ - ticked_ns_ >= setup_.options().tick_ns) {
        ticked_ns_ = due_ns_;
        tick(now_ns);
      }
      if (stopping_ && core_.links().empty()) {
        core_.io.stop();
      } else {
        keep_time();
      }
    });
  }

  void tick(std::int64_t now_ns) {
    core_.listening.tick(now_ns);
    core_.hub.step(now_ns);
    if (core_.page.view != nullptr) {
      core_.page.view->step(now_ns);
    }
    if (callbacks_.on_tick) {
      callbacks_.on_tick(now_ns);
    }
    if (callbacks_.on_refusals) {
      while (const auto line = core_.refusal_log.take(now_ns)) {
        callbacks_.on_refusals(*line);
      }
    }
    core_.urgent_beyond = 0;
    for (std::size_t at = core_.links().size(); at-- > 0;) {  // a link that ends gives its place to the last
      core_.links()[at]->sweep(now_ns);
    }
    if (accept_again_ns_ != 0 && now_ns >= accept_again_ns_) {
      accept_again_ns_ = 0;
      await_clients();
    }
  }

  ServerSetup setup_;
  ServerCallbacks callbacks_;
  ServerCore core_;
  std::optional<asio::ssl::context> tls_;
  tcp::acceptor listener_;
  asio::steady_timer timer_;
  std::int64_t period_ns_;
  std::int64_t due_ns_ = 0, ticked_ns_ = 0, accept_again_ns_ = 0;
  bool stopping_ = false;
};

Server::Server(SessionHub& hub, ServerSetup setup, ServerCallbacks callbacks, ServerPage page)
    : impl_(std::make_unique<Impl>(hub, std::move(setup), std::move(callbacks), page)) {}

Server::~Server() = default;

void Server::run() {
  impl_->run();
}

void Server::stop() {
  impl_->stop();
}

std::uint16_t Server::port() const noexcept {
  return impl_->setup().port();
}

const ServerStatistics& Server::statistics() const noexcept {
  return impl_->statistics();
}

}  // namespace gaitway::api
