// The worst-case formulas against the simulation, with everything under way that may be.
#include "gaitway/link/worst_case.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <random>

#include "link_pair.hpp"
#include "repeats.hpp"

namespace gaitway::link::test {
namespace {

constexpr std::size_t kOrderBytes = 40;  // a velocity command

// The longest waits of many orders and stops that come at random moments while state flows.
struct Longest {
  std::int64_t order_ns = 0, lone_order_ns = 0, stop_ns = 0;
};

// `advance_to` advances carrier and ends to a moment; after `emptied_ns` nothing of a stop that has been
// obeyed is on the carrier any more.
template <class Advance>
Longest longest_waits(ModuleEnd& module, ControllerEnd& controller, Advance advance_to,
                      std::int64_t emptied_ns, int trials) {
  std::mt19937_64 random(7);
  std::int64_t now_ns = 0;
  Longest longest;
  std::uint32_t fetched = 0;
  const std::string value(3000, 'v'), order(kOrderBytes, 'o');
  const auto run = [&](std::int64_t duration_ns, auto done) {
    const std::int64_t begin_ns = now_ns;
    while (now_ns < begin_ns + duration_ns && !done()) {
      controller.publish(1, bytes_of(value), now_ns);
      controller.publish(0, bytes_of("small"), now_ns);
      now_ns += 20'000;
      advance_to(now_ns);
      if (const auto next = controller.next_order(now_ns)) {
        ++fetched;
        controller.answer(next->id, 0, {});
      }
      while (module.next_outcome(now_ns)) {
      }
    }
    return now_ns - begin_ns;
  };
  const auto never = [] { return false; };
  run(300 * kMs, never);
  for (int i = 0; i < trials; ++i) {
    const auto kind = random() % 4;
    const bool with_stop = kind < 2, alone = kind == 3;  // else as it comes
    if (alone) {
      run(200 * kMs, [&] { return module.stops().asked() == module.stops().obeyed(); });
      run(emptied_ns, never);
    }
    run(static_cast<std::int64_t>(random() % 40'000'000), never);
    const std::uint32_t stops = controller.stops_asked().stops, before = fetched;
    if (with_stop) module.stop(StopKind::stop);
    EXPECT_EQ(module.submit(1, bytes_of(order), now_ns + 200 * kMs, now_ns).refusal, Refusal::none);
    if (with_stop) {
      longest.stop_ns =
          std::max(longest.stop_ns, run(200 * kMs, [&] { return controller.stops_asked().stops > stops; }));
      controller.stops_obeyed(controller.stops_asked());
    }
    const std::int64_t order_ns = run(200 * kMs, [&] { return fetched > before; });
    longest.order_ns = std::max(longest.order_ns, order_ns);
    if (alone) longest.lone_order_ns = std::max(longest.lone_order_ns, order_ns);
  }
  EXPECT_EQ(fetched, static_cast<std::uint32_t>(trials));
  return longest;
}

void expect_within(const Longest& longest, const CarrierTiming& carrier, const LinkSettings& settings,
                   PumpPeriods periods) {
  const std::int64_t order_ns = worst_order_wait_ns(carrier, settings, kOrderBytes, periods);
  const std::int64_t lone_ns = worst_lone_order_wait_ns(carrier, settings, kOrderBytes, periods);
  const std::int64_t stop_ns = worst_stop_wait_ns(carrier, settings, periods);
  constexpr std::int64_t kGrid_ns = 40'000;  // the test looks every 20 µs
  EXPECT_LE(longest.order_ns, order_ns + kGrid_ns);
  EXPECT_LE(longest.lone_order_ns, lone_ns + kGrid_ns);
  EXPECT_LE(longest.stop_ns, stop_ns + kGrid_ns);
  EXPECT_GE(4 * longest.order_ns, order_ns) << "the formula says far too much";
  testing::Test::RecordProperty("order_bound_us", static_cast<int>(order_ns / 1000));
  testing::Test::RecordProperty("order_longest_us", static_cast<int>(longest.order_ns / 1000));
  testing::Test::RecordProperty("stop_bound_us", static_cast<int>(stop_ns / 1000));
  testing::Test::RecordProperty("stop_longest_us", static_cast<int>(longest.stop_ns / 1000));
  const auto ms = [](std::int64_t duration_ns) { return static_cast<double>(duration_ns) * 1e-6; };
  std::printf("order: %.2f ms of %.2f ms, without a stop: %.2f ms of %.2f ms, stop: %.2f ms of %.2f ms\n",
              ms(longest.order_ns), ms(order_ns), ms(longest.lone_order_ns), ms(lone_ns), ms(longest.stop_ns),
              ms(stop_ns));
}

TEST(WorstCase, HoldsOnI2c) {
  const LinkSettings settings;
  const I2cSettings timing;
  I2cBus bus(timing);
  ModuleEnd module(module_identity(1), kChannels, settings);
  ControllerEnd controller(controller_identity(2), kChannels, settings);
  const auto pump_both = [&](std::int64_t now_ns) {
    pump(module, bus.master(), now_ns);
    pump(controller, bus.slave(), now_ns);
  };
  std::int64_t before_ns = 0;
  const auto advance = [&](std::int64_t until_ns) {
    pump_both(before_ns);
    while (const auto transfer_end_ns = bus.advance(until_ns)) pump_both(*transfer_end_ns);
    before_ns = until_ns;
  };
  const CarrierTiming carrier = i2c_timing(timing);
  expect_within(longest_waits(module, controller, advance, worst_stop_wait_ns(carrier, settings),
                              gaitway::test::repeats(2000)),
                carrier, settings, {});
}

TEST(WorstCase, HoldsOnSerialLines) {
  const LinkSettings settings;
  constexpr PumpPeriods kPeriods{kMs, kMs};
  for (const std::uint32_t baud : {115200U, 1000000U}) {
    SCOPED_TRACE(baud);
    const CarrierTiming timing = serial_timing(baud);
    SimulatedWire wire(timing.byte_ns, timing.buffer_bytes, 1);
    ModuleEnd module(module_identity(1), kChannels, settings);
    ControllerEnd controller(controller_identity(2), kChannels, settings);
    std::int64_t pumped_ns = -kMs;
    const auto advance = [&](std::int64_t until_ns) {
      wire.advance(until_ns);
      if (until_ns - pumped_ns < kMs) return;
      pumped_ns = until_ns;
      pump(module, wire.left(), until_ns);
      pump(controller, wire.right(), until_ns);
    };
    expect_within(longest_waits(module, controller, advance, worst_stop_wait_ns(timing, settings, kPeriods),
                                gaitway::test::repeats(1000)),
                  timing, settings, kPeriods);
  }
}

// The table of the room's page.
TEST(WorstCase, ValuesOfTheReadme) {
  struct Row {
    const char* name;
    CarrierTiming carrier;
    PumpPeriods periods;
    double stop_ms, lone_order_ms, order_ms, stop_with_loss_ms, order_with_loss_ms;
  };
  constexpr PumpPeriods kEachMs{kMs, kMs};
  for (const Row& row :
       {Row{"Unix socket", unix_timing(), kEachMs, 2.0, 2.0, 2.0, 14.0, 29.0},
        Row{"115200 baud", serial_timing(115'200), kEachMs, 18.49, 19.53, 27.43, 46.99, 79.87},
        Row{"1000000 baud", serial_timing(1'000'000), kEachMs, 4.98, 5.46, 6.73, 19.96, 38.46},
        Row{"I2C", i2c_timing({}), {}, 6.47, 6.79, 9.91, 22.93, 44.82}}) {
    SCOPED_TRACE(row.name);
    const LinkSettings settings;
    const auto ms = [](std::int64_t duration_ns) { return static_cast<double>(duration_ns) * 1e-6; };
    const auto& [name, carrier, periods, stop, lone_order, order, stop_with_loss, order_with_loss] = row;
    EXPECT_NEAR(ms(worst_lone_order_wait_ns(carrier, settings, kOrderBytes, periods)), lone_order, 0.005);
    EXPECT_NEAR(ms(worst_stop_wait_ns(carrier, settings, periods)), stop, 0.005);
    EXPECT_NEAR(ms(worst_order_wait_ns(carrier, settings, kOrderBytes, periods)), order, 0.005);
    EXPECT_NEAR(ms(worst_stop_wait_with_losses_ns(carrier, settings, 1, periods)), stop_with_loss, 0.005);
    EXPECT_NEAR(ms(worst_order_wait_with_losses_ns(carrier, settings, kOrderBytes, 1, periods)),
                order_with_loss, 0.005);
  }
}

}  // namespace
}  // namespace gaitway::link::test
