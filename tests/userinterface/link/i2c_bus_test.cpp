// I2C to the nanosecond, and each of its troubles.
#include "gaitway/link/i2c_bus.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "link_pair.hpp"

namespace gaitway::link::test {
namespace {

using Stream = std::vector<std::uint8_t>;

constexpr I2cSettings kExact{.slave_service_ns = 0};

Stream take(Carrier& carrier) {
  Stream all(kReadBytes);
  all.resize(carrier.read(all));
  return all;
}

TEST(I2c, ATransferLastsToTheBit) {
  I2cBus bus(kExact);
  EXPECT_EQ(bus.advance(1000), std::nullopt);
  EXPECT_EQ(bus.master().write(Stream{1, 2, 3}), 3U);
  // Start 0.6 µs; address and three bytes of 9 bits, 2.5 µs each; stop 0.6 µs; 1.3 µs until the next start.
  const std::int64_t end_ns = 1000 + 600 + 4 * 9 * 2500 + 600 + 1300;
  EXPECT_EQ(bus.advance(end_ns - 1), std::nullopt);
  EXPECT_EQ(bus.advance(end_ns), end_ns);
  EXPECT_EQ(take(bus.slave()), (Stream{1, 2, 3}));
  EXPECT_EQ(kExact.transfer_ns(3), end_ns - 1000);
}

TEST(I2c, TheSlaveIsReadAsLongAsItIsReady) {
  I2cBus bus(kExact);
  bus.slave().write(Stream{7, 8});
  EXPECT_EQ(bus.advance(1'000'000), kExact.transfer_ns(2));
  EXPECT_EQ(take(bus.master()), (Stream{7, 8}));
  EXPECT_EQ(bus.advance(1'000'000), std::nullopt);  // nobody polls a slave that is not ready
  EXPECT_EQ(bus.counts().reads, 1U);
}

TEST(I2c, LongTransfersAreCutAndReadsGetTheirTurn) {
  I2cSettings settings = kExact;
  settings.transfer_bytes = 4;
  settings.writes_per_read = 2;
  I2cBus bus(settings);
  std::string turns;
  for (std::int64_t until_ns = 20'000'000; turns.size() < 9;) {
    bus.master().write(Stream(4, 1));
    bus.slave().write(Stream(4, 2));
    const std::uint64_t reads = bus.counts().reads;
    ASSERT_TRUE(bus.advance(until_ns));
    turns += bus.counts().reads > reads ? 'r' : 'w';
    take(bus.master());
    take(bus.slave());
  }
  EXPECT_EQ(turns, "wwrwwrwwr");
}

TEST(I2c, BytesThatAreNotAcknowledgedStay) {
  I2cBus bus(kExact);
  bus.set_faults({.address_nack = 0.5, .data_nack = 0.2, .arbitration_loss = 0.2, .stretch = 0.1});
  Stream sent, received;
  for (int i = 0; i < 500; ++i) {
    const Stream byte{static_cast<std::uint8_t>(i)};
    if (bus.master().write(byte) == 1) sent.push_back(byte[0]);
    bus.advance(100'000 * (i + 1));
    const Stream some = take(bus.slave());
    received.insert(received.end(), some.begin(), some.end());
  }
  while (bus.advance(2'000'000'000)) {
    const Stream some = take(bus.slave());
    received.insert(received.end(), some.begin(), some.end());
  }
  EXPECT_EQ(received, sent);
  EXPECT_GT(bus.counts().nacks, 0U);
  EXPECT_GT(bus.counts().arbitration_losses, 0U);
  EXPECT_GT(bus.counts().stretches, 0U);
}

TEST(I2c, AFullSlaveTakesNoMore) {
  I2cBus bus(kExact);
  Stream sent;
  for (std::uint8_t i = 0; i < 40; ++i) {
    while (bus.master().write(Stream{i}) == 0 && bus.advance(bus.counts().nacks > 3 ? 0 : 50'000'000)) {
    }
  }
  bus.advance(50'000'000);
  EXPECT_EQ(take(bus.slave()).size(), kExact.transfer_bytes);
  EXPECT_GT(bus.counts().nacks, 0U);
}

TEST(I2c, AStuckBusIsClockedFree) {
  I2cBus bus(kExact);
  bus.stick(5);
  bus.master().write(Stream{1});
  const std::optional<std::int64_t> recovered_ns = bus.advance(1'000'000);
  ASSERT_TRUE(recovered_ns);
  EXPECT_EQ(*recovered_ns, 5 * 2500 + 600 + 1300 + kExact.retry_ns);
  EXPECT_EQ(bus.counts().recoveries, 1U);
  ASSERT_TRUE(bus.advance(1'000'000));
  EXPECT_EQ(take(bus.slave()), Stream{1});
}

TEST(I2c, ABusThatStaysStuckIsClockedAgainAndAgain) {
  I2cBus bus(kExact);
  bus.stick(5, 10'000'000);
  bus.master().write(Stream{1});
  while (bus.advance(20'000'000)) {
  }
  EXPECT_EQ(take(bus.slave()), Stream{1});
  EXPECT_GT(bus.counts().recoveries, 50U);
  EXPECT_GT(bus.counts().recovery_clocks, 9 * (bus.counts().recoveries - 1));  // nine each, but for the last
}

TEST(I2c, AClockThatIsHeldTooLongEndsTheTransfer) {
  I2cSettings settings = kExact;
  settings.stretch_limit_ns = 100'000;
  I2cBus bus(settings);
  bus.set_faults({.stretch = 1.0, .stretch_ns = 1'000'000});
  bus.master().write(Stream{1});
  for (int i = 0; i < 20; ++i) bus.advance(1'000'000'000);
  EXPECT_GT(bus.counts().timeouts, 0U);
  bus.set_faults({});
  while (bus.advance(2'000'000'000)) {
  }
  EXPECT_EQ(take(bus.slave()), Stream{1});
}

TEST(I2c, ASlaveWithoutPowerAcknowledgesNothing) {
  I2cBus bus(kExact);
  bus.power_slave(false);
  bus.master().write(Stream{1});
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(bus.advance(100'000'000));
  EXPECT_EQ(bus.counts().nacks, 10U);
  bus.power_slave(true);
  ASSERT_TRUE(bus.advance(100'000'000));
  EXPECT_EQ(take(bus.slave()), Stream{1});
}

TEST(I2c, SettingsThatCannotWorkAreRefused) {
  EXPECT_THROW(I2cBus({.transfer_bytes = 0}), std::invalid_argument);
  EXPECT_THROW(I2cBus({.transfer_bytes = 129}), std::invalid_argument);
  EXPECT_THROW(I2cBus({.writes_per_read = 0}), std::invalid_argument);
}

}  // namespace
}  // namespace gaitway::link::test
