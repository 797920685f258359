// Who reads what from whom: the order of the steps, and everything that is wrong with it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "gaitway/instance/topic_port.hpp"

namespace gaitway::core {

struct ExternalTopic {  // one that is in the memory block already
  std::string topic;
  std::string writer;  // empty: nobody writes it at the moment
};

struct DataFlow {
  std::vector<std::size_t> order;  // indices into the nodes, as they are to be stepped
  // Both in that order: whose outputs of the same tick one depends on, directly or through others; itself
  // included.
  std::vector<std::vector<bool>> depends_on;
};

// Each plug-in after those whose topics it reads; otherwise in the order of `nodes`. Throws PluginError,
// naming plug-ins and topics: double writer, types that disagree, missing input, cycle.
DataFlow order_by_data_flow(std::span<const DataFlowNode> nodes, std::span<const ExternalTopic> external);

}  // namespace gaitway::core
