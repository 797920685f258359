// The joint's main program has nothing to do: it sleeps until the next interrupt.
#include "gaitway_target/core_registers.hpp"
#include "gaitway_target/emulated_board.hpp"
#include "gaitway_target/joint_firmware.hpp"

namespace gaitway::target {

volatile BoardRegisters board_registers;

void between_interrupts() noexcept {
  wait_for_interrupt();
}

}  // namespace gaitway::target
