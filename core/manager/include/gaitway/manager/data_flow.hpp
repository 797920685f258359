// Who reads what from whom: the order of the steps, and everything that is wrong with it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/manager/plugin_error.hpp"
#include "gaitway/plugin/abi.h"

namespace gaitway::core {

// Same numbers as in the ABI.
enum class Access : std::uint32_t {
  read = GAITWAY_READ,
  read_previous = GAITWAY_READ_PREVIOUS,
  read_optional = GAITWAY_READ_OPTIONAL,
  write = GAITWAY_WRITE,
  read_previous_optional = GAITWAY_READ_PREVIOUS_OPTIONAL
};
inline constexpr std::array kAccesses{Access::read, Access::read_previous, Access::read_optional,
                                      Access::write, Access::read_previous_optional};

// Of the tick before: such a use orders nothing.
constexpr bool is_of_tick_before(Access access) noexcept {
  return access == Access::read_previous || access == Access::read_previous_optional;
}
constexpr bool needs_writer(Access access) noexcept {
  return access == Access::read || access == Access::read_previous;
}

struct TopicUse {
  Access access = Access::read;
  std::string topic;
  std::string type_name;
  std::uint64_t type_hash = 0;
  std::uint32_t size = 0;
  std::string number_fields = {};  // its floating-point fields and where they lie, for people
};

struct DataFlowNode {  // a plug-in
  std::string name;
  std::vector<TopicUse> uses;
};

struct ExternalTopic {  // one that is in the memory block already
  std::string topic;
  std::string writer;  // empty: nobody writes it at the moment
};

struct DataFlow {
  std::vector<std::size_t> order;  // indices into the nodes, as they are to be stepped
  // [node]: whose outputs of the same tick a node depends on, directly or through others; itself included.
  std::vector<std::vector<bool>> depends_on;
};

// Each plug-in after those whose topics it reads; otherwise in the order of `nodes`. Throws PluginError,
// naming plug-ins and topics: double writer, types that disagree, missing input, cycle.
DataFlow order_by_data_flow(std::span<const DataFlowNode> nodes, std::span<const ExternalTopic> external);

}  // namespace gaitway::core
