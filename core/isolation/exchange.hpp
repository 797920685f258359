// The memory that the manager and one child share, and how each waits for the other. The child never
// maps anything else of the manager's. All sizes and places come from what each side was told at set-up:
// nothing in the segment is an offset or a length that the manager believes.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "gaitway/instance/managed_plugin.hpp"
#include "gaitway/plugin/abi.h"

namespace gaitway::core {

inline constexpr std::uint64_t kExchangeGuard = 0x6761'6974'7761'7921U;
inline constexpr std::size_t kExchangeReports = 16;

enum class ChildCall : std::uint32_t {
  step,
  activate,
  deactivate,
  save_state,
  restore_state,
  set_parameter,
  end,  // deactivated: destroys the plug-in and exits; has no answer
};

// A number that one side counts up and the other waits for.
struct alignas(64) Doorbell {
  std::atomic<std::uint32_t> number{0};
  std::atomic<std::uint32_t> asleep{0};  // 1: the waiting side is in the kernel, or about to be
};
static_assert(std::atomic<std::uint32_t>::is_always_lock_free);

struct ChildRequest {  // written by the manager
  ChildCall call = ChildCall::step;
  std::uint32_t keep_state = 0;  // of a step: hand the state out after it
  gaitway_tick tick{};
  std::uint32_t state_size = 0, state_version = 0;  // of restore_state
  gaitway_value parameter{};
  char parameter_name[128]{};
  char parameter_text[512]{};
};

struct ChildReport {
  std::uint32_t severity = 0;
  char text[164]{};
};

struct ChildReply {  // written by the child
  std::int32_t status = 0;
  std::uint32_t exhausted = 0;                      // 1: memory, 2: descriptors
  std::uint32_t state_size = 0, state_version = 0;  // version 0: none was saved
  std::uint32_t reports = 0;                        // may be more than there is room for; 0 again once taken
  char text[1024]{};
  ChildReport report[kExchangeReports]{};
};

struct LastWords {  // of a child that a signal ends
  std::uint32_t signal = 0;
  std::uint32_t in_library = 0;  // 1: the offset is one into the plug-in's library
  std::uint64_t address = 0;     // that it touched
  std::uint64_t offset = 0;
};

struct alignas(64) ExchangeHeader {
  std::uint64_t guard = kExchangeGuard;
  Doorbell call, answer;
  ChildRequest request;
  alignas(64) ChildReply reply;
  LastWords last_words;
  alignas(64) std::byte state[PluginState::kCapacity];
  std::uint64_t end_guard = kExchangeGuard;
};

struct alignas(64) PortArea {  // its value follows
  std::uint64_t guard = kExchangeGuard;
  std::uint64_t sequence = 0;  // of an input's value; 0: none yet
  std::int64_t stamp_ns = 0;
  std::uint32_t staged = 0;  // of an output
  std::uint32_t reserved = 0;
};

// Where the ports lie; both sides compute it from the sizes that they know.
struct ExchangeLayout {
  explicit ExchangeLayout(const std::vector<std::uint32_t>& port_sizes);
  std::vector<std::size_t> port_offset;
  std::size_t bytes = 0;
};

// A short look before sleeping, as long as looking has been worth it. Never on a single processor.
class Spin {
 public:
  Spin() noexcept;
  // Whether `bell` left `old` within about 20 µs.
  bool sees_change(const Doorbell& bell, std::uint32_t old) noexcept;

 private:
  bool several_processors_;
  std::uint32_t vain_ = 0;  // in a row
};

// The number and whatever was written before become visible to the side that waits; wakes it if it sleeps.
void ring(Doorbell& bell, std::uint32_t number) noexcept;
// Sleeps until the number is no longer `old`, `timeout_ns` have passed (negative: no limit), or for no
// reason.
void sleep_on(Doorbell& bell, std::uint32_t old, std::int64_t timeout_ns) noexcept;

}  // namespace gaitway::core
