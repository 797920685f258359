// The table of connections, and the turns in which they write.
#include "server_core.hpp"

#include <algorithm>
#include <boost/asio/post.hpp>
#include <chrono>
#include <utility>

#include "client_link.hpp"

namespace gaitway::api {
namespace {

// Those of one address who may give way.
struct Strangers {
  std::size_t count = 0;
  std::shared_ptr<ClientLink> oldest;
};

// Where most are, the oldest gives way; of equally many the one that came first.
std::pair<std::size_t, std::int64_t> rank(
    const std::pair<const boost::asio::ip::address, Strangers>& of_address) {
  const Strangers& strangers = of_address.second;
  return {strangers.count, -strangers.oldest->since_ns()};
}

}  // namespace

std::int64_t wall_now_ns() noexcept {
  return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
}

ServerCore::ServerCore(SessionHub& sessions, const ServerSetup& server_setup, const ServerPage& server_page)
    : hub(sessions),
      setup(server_setup),
      options(server_setup.options()),
      page(server_page),
      listening(wall_now_ns(), 2 * options.tick_ns) {}

bool ServerCore::make_room_for(const boost::asio::ip::address& whose) {
  const boost::asio::ip::address address = counted_address(whose);
  std::map<boost::asio::ip::address, Strangers> strangers;
  for (const auto& link : links_) {
    if (link->may_give_way()) {
      Strangers& of_its = strangers[counted_address(link->address())];
      ++of_its.count;
      if (!of_its.oldest || link->since_ns() < of_its.oldest->since_ns()) {
        of_its.oldest = link;
      }
    }
  }
  const Limits& limits = options.limits;
  const auto known = of_address_.find(address);
  const auto own = strangers.find(address);
  std::shared_ptr<ClientLink> leaves;
  if ((known != of_address_.end() && known->second >= limits.connections_of_one_address) ||
      (own != strangers.end() && own->second.count >= limits.strangers_of_one_address)) {
    leaves = own != strangers.end() ? own->second.oldest : nullptr;
  } else if (places_taken_ < limits.connections) {
    return true;
  } else if (const auto most = std::ranges::max_element(strangers, {}, rank); most != strangers.end()) {
    leaves = most->second.oldest;
  }
  if (leaves) {
    leaves->give_way();
  }
  return leaves != nullptr;
}

void ServerCore::add(std::shared_ptr<ClientLink> link) {
  if (!link->is_surplus()) {
    ++of_address_[counted_address(link->address())];
    ++places_taken_;
  }
  link->place = links_.size();
  links_.push_back(std::move(link));
  woken_.reserve(links_.size());
  pumped_.reserve(links_.size());
  statistics.connected = links_.size();
}

void ServerCore::remove(ClientLink& link) {
  if (!link.is_surplus()) {
    if (const auto known = of_address_.find(counted_address(link.address())); --known->second == 0) {
      of_address_.erase(known);
    }
    --places_taken_;
  }
  const std::size_t place = link.place;
  const std::shared_ptr<ClientLink> last = std::move(links_.back());
  links_.pop_back();
  if (last.get() != &link) {
    const std::shared_ptr<ClientLink> removed = std::exchange(links_[place], last);
    last->place = place;
  }
  statistics.connected = links_.size();
}

void ServerCore::want_pump(std::shared_ptr<ClientLink> link) noexcept {
  woken_.push_back(std::move(link));
  if (!std::exchange(pump_posted_, true)) {
    boost::asio::post(io, [this] { pump_all(); });
  }
}

void ServerCore::want_work(std::shared_ptr<ClientLink> link) {
  turns_.add(std::move(link));
  post_work();
}

void ServerCore::want_handshake(std::shared_ptr<ClientLink> link) {
  handshakes_.push_back(std::move(link));
  post_work();
}

void ServerCore::post_work() {
  if (!std::exchange(work_posted_, true)) {
    boost::asio::post(io, [this] { work(); });
  }
}

// Sockets first: a stop may be among what has come.
void ServerCore::work() {
  const std::int64_t begin_ns = wall_now_ns();
  while (io.poll_one() > 0 && wall_now_ns() - begin_ns < kSockets_ns) {
  }
  if (!handshakes_.empty()) {
    const std::shared_ptr<ClientLink> link = std::move(handshakes_.front());
    handshakes_.pop_front();
    link->shake_hands();
  }
  const bool more = turns_.run();
  work_posted_ = false;
  if (more || !handshakes_.empty()) {
    post_work();
  }
}

void ServerCore::pump_all() {
  pump_posted_ = false;
  pumped_.swap(woken_);
  const std::int64_t now_ns = wall_now_ns();
  std::stable_partition(pumped_.begin(), pumped_.end(), [](const auto& link) { return link->is_view(); });
  for (const auto& link : pumped_) {
    link->pump_woken(now_ns);
  }
  pumped_.clear();
}

}  // namespace gaitway::api
