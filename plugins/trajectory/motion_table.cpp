// Lengths of exits.
#include "gaitway/trajectory/motion_table.hpp"

#include "gaitway/msgclient/topics.hpp"

namespace gaitway::trajectory {

std::size_t MotionTable::exit_points(std::size_t batches) const noexcept {
  const MotionExit& exit = exits[batches];
  const std::size_t way = exit.way < 0 ? 0 : ways[static_cast<std::size_t>(exit.way)].size();
  return std::size_t{exit.go_on_batches} * kBatchPoints + way;
}

}  // namespace gaitway::trajectory
