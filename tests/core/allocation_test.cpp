// The cycle does not allocate: not with plans that go out, and not with faults and refusals.
#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <new>

#include "gaitway/manager/plugin_requests.hpp"
#include "main_controller_fixture.hpp"

namespace {

thread_local bool counting = false;
thread_local int allocations = 0;

void* counted(std::size_t size) {
  allocations += counting ? 1 : 0;
  if (void* const memory = std::malloc(size)) {
    return memory;
  }
  throw std::bad_alloc();
}

}  // namespace

// Also what the plug-ins' libraries allocate with. Not inlined, or the compiler sees a new that ends in free.
[[gnu::noinline]] void* operator new(std::size_t size) {
  return counted(size);
}
[[gnu::noinline]] void* operator new[](std::size_t size) {
  return counted(size);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete[](void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete[](void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace gaitway::core {
namespace {

class Allocation : public MainControllerFixture {
 protected:
  // Allocations of the controller in four cycles, the first left out.
  int allocations_of(const std::string& defect) {
    start(defect);
    batch_tick();
    allocations = 0;
    for (int i = 0; i < 32; ++i) {
      now_ns = next_tick_ns(now_ns);
      counting = true;
      controller->step(now_ns);
      counting = false;
      if (emi.message().take_hand_over(*batch, now_ns + 9'000'000) == msgclient::TakeStatus::mail) {
        answer(msgclient::Verdict::accepted);
      }
    }
    return allocations;
  }
};

TEST_F(Allocation, IsCountedByThisTest) {
  allocations = 0;
  counting = true;
  const auto number = std::make_unique<int>(1);
  counting = false;
  EXPECT_EQ(allocations, *number);
}

TEST_F(Allocation, NoneWhileBatchesAreHandedOver) {
  EXPECT_EQ(allocations_of("none"), 0);
  EXPECT_EQ(controller->statistics().handed_over, 5U);
}

TEST_F(Allocation, NoneWhilePlansAreRefused) {
  EXPECT_EQ(allocations_of("jump"), 0);
  EXPECT_EQ(controller->statistics().refused_locally, 5U);
}

// Requests are taken, put in place and answered in the tick's thread; all else is the other one's.
TEST_F(Allocation, NoneWhileRequestsAreServed) {
  start("none");
  PluginRequests requests(client, controller->plugins());
  auto queue = message_client.write_queue<PluginRequest>("plugin_request");
  auto answers = message_client.read_stream<PluginAnswer>("plugin_answer");
  PluginRequest request{};
  std::strcpy(reinterpret_cast<char*>(request.plugin), "planner");
  std::strcpy(reinterpret_cast<char*>(request.parameter), "speed");
  std::strcpy(reinterpret_cast<char*>(request.value), "0.123456789012345678");
  for (const PluginVerb verb :
       {PluginVerb::describe_parameter, PluginVerb::set, PluginVerb::reload, PluginVerb::unload}) {
    request.verb = static_cast<std::uint32_t>(verb);
    ASSERT_TRUE(queue.push(request, 0));
    PluginAnswer answer{};
    allocations = 0;
    for (int i = 0; i < 40 && !answers.read(answer); ++i) {
      now_ns = next_tick_ns(now_ns);
      controller->step(now_ns);
      counting = true;
      requests.step(now_ns);
      counting = false;
      requests.work();
    }
    EXPECT_EQ(answer.done, 1U) << answer.text;
    EXPECT_EQ(allocations, 0) << "verb " << request.verb;
  }
}

}  // namespace
}  // namespace gaitway::core
