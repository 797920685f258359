// One kind of order, from those who ask to the one who obeys: two topics of requests, one of commands.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "gaitway/msgclient/client.hpp"
#include "gaitway/msgclient/topics.hpp"

namespace gaitway::msgcontroller {

// Whose order is in force; as CommandState::in_force has it.
enum class OrderSource : std::uint8_t { nobody, behaviour, person };

template <class Order>
class CommandChannel {
 public:
  // The topics' names. Throws msgclient::TopicError when somebody else writes `commands`.
  CommandChannel(msgclient::Client& client, const char* behaviour, const char* person, const char* commands)
      : requests_{client.read<Order>(behaviour), client.read<Order>(person)},
        commands_(client.write<Order>(commands)) {}

  // The newest request that has not been taken yet, if there is one. No allocation.
  [[nodiscard]] std::optional<Order> take(OrderSource source) noexcept {
    msgclient::Reader<Order>& requests = requests_[index(source)];
    std::uint64_t& seen = seen_[index(source)];
    if (requests.newest_sequence() == seen) return std::nullopt;
    Order order;
    const auto read = requests.read(order);
    if (!read) return std::nullopt;  // a newer one is being written: in the next millisecond
    seen = read.sequence;
    return order;
  }
  // What lies there does not count.
  void drop(OrderSource source) noexcept {
    seen_[index(source)] = requests_[index(source)].newest_sequence();
  }

  // It is the command from now on.
  void command(Order order, OrderSource source, std::int64_t now_ns) noexcept {
    order.stamp_ns = now_ns;
    current_ = order;
    in_force_ = source;
    commands_.publish(order, now_ns);
  }
  // The command has come to its end by itself.
  void is_done() noexcept { in_force_ = OrderSource::nobody; }

  [[nodiscard]] const Order& current() const noexcept { return current_; }
  [[nodiscard]] OrderSource in_force() const noexcept { return in_force_; }

 private:
  static std::size_t index(OrderSource source) noexcept { return source == OrderSource::person ? 1 : 0; }

  std::array<msgclient::Reader<Order>, 2> requests_;
  std::array<std::uint64_t, 2> seen_{};
  msgclient::Writer<Order> commands_;
  Order current_{};
  OrderSource in_force_ = OrderSource::nobody;
};

}  // namespace gaitway::msgcontroller
