// Rows by their kind.
#include "gaitway/contract/order_table.hpp"

#include <algorithm>

namespace gaitway::contract {

const OrderRow* find_order(std::uint16_t kind) noexcept {
  const auto* const found = std::ranges::find(
      kOrders, kind, [](const OrderRow& order) { return static_cast<std::uint16_t>(order.kind); });
  return found == kOrders.end() ? nullptr : found;
}

const OrderRow& row(OrderKind kind) noexcept {
  return *find_order(static_cast<std::uint16_t>(kind));
}

}  // namespace gaitway::contract
