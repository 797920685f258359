// The kernel's error frames, as linux/can/error.h defines their bits.
#include "gaitway/can/socketcan_port.hpp"

#include <gtest/gtest.h>
#include <linux/can/error.h>

namespace gaitway::can {
namespace {

using Data = std::array<std::uint8_t, 8>;

TEST(ErrorFrame, AControllersNewStateIsTold) {
  const auto state = [](std::uint8_t controller) {
    return read_error_frame(CAN_ERR_CRTL, Data{0, controller}).state;
  };
  EXPECT_EQ(state(CAN_ERR_CRTL_TX_PASSIVE), BusState::error_passive);
  EXPECT_EQ(state(CAN_ERR_CRTL_RX_PASSIVE), BusState::error_passive);
  EXPECT_EQ(state(CAN_ERR_CRTL_TX_WARNING), BusState::error_active);
  EXPECT_EQ(state(CAN_ERR_CRTL_ACTIVE), BusState::error_active);
  EXPECT_EQ(state(CAN_ERR_CRTL_RX_OVERFLOW), std::nullopt);
  EXPECT_EQ(read_error_frame(CAN_ERR_BUSOFF, {}).state, BusState::bus_off);
  EXPECT_EQ(read_error_frame(CAN_ERR_BUSOFF | CAN_ERR_CRTL, Data{0, CAN_ERR_CRTL_TX_PASSIVE}).state,
            BusState::bus_off);
  EXPECT_EQ(read_error_frame(CAN_ERR_RESTARTED, {}).state, BusState::error_active);
  EXPECT_TRUE(read_error_frame(CAN_ERR_RESTARTED, {}).restarted);
}

TEST(ErrorFrame, CountersAreReadWhereTheyAre) {
  const Data data{0, CAN_ERR_CRTL_TX_PASSIVE, 0, 0, 0, 0, 136, 12};
  EXPECT_EQ(read_error_frame(CAN_ERR_CRTL | CAN_ERR_CNT, data).counters, (ErrorCounters{136, 12}));
  EXPECT_EQ(read_error_frame(CAN_ERR_CRTL, data).counters, (ErrorCounters{136, 12})) << "an older driver";
  EXPECT_EQ(read_error_frame(CAN_ERR_CNT, {}).counters, (ErrorCounters{0, 0}));
  EXPECT_EQ(read_error_frame(CAN_ERR_CRTL, Data{0, CAN_ERR_CRTL_ACTIVE}).counters, std::nullopt);
  EXPECT_EQ(read_error_frame(CAN_ERR_PROT, data).counters, std::nullopt);
}

TEST(ErrorFrame, EachCauseIsToldByItself) {
  EXPECT_TRUE(read_error_frame(CAN_ERR_ACK, {}).no_acknowledge);
  EXPECT_TRUE(read_error_frame(CAN_ERR_LOSTARB, {}).lost_arbitration);
  EXPECT_TRUE(read_error_frame(CAN_ERR_PROT, {}).protocol_violation);
  EXPECT_TRUE(read_error_frame(CAN_ERR_BUSERROR, {}).protocol_violation);
  EXPECT_TRUE(read_error_frame(CAN_ERR_TRX, {}).transceiver_fault);
  EXPECT_TRUE(read_error_frame(CAN_ERR_TX_TIMEOUT, {}).transmit_timeout);
  EXPECT_TRUE(read_error_frame(CAN_ERR_CRTL, Data{0, CAN_ERR_CRTL_RX_OVERFLOW}).receive_overflow);
  EXPECT_TRUE(read_error_frame(CAN_ERR_CRTL, Data{0, CAN_ERR_CRTL_TX_OVERFLOW}).transmit_overflow);
  const ErrorReport ack = read_error_frame(CAN_ERR_ACK, Data{0, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF});
  EXPECT_FALSE(ack.state || ack.counters || ack.restarted || ack.lost_arbitration || ack.protocol_violation ||
               ack.transceiver_fault || ack.transmit_timeout || ack.receive_overflow || ack.transmit_overflow)
      << "bytes of other causes mean nothing";
}

}  // namespace
}  // namespace gaitway::can
