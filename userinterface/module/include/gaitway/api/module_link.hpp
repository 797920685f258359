// The module's end of the narrow link, with all that goes over it: orders with their expiry, stops, and the
// robot's mirrored state.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/api/robot_port.hpp"
#include "gaitway/api/state_mirror.hpp"
#include "gaitway/contract/order_table.hpp"
#include "gaitway/link/carrier.hpp"
#include "gaitway/link/module_end.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::api {

struct ModuleLinkOptions {
  std::uint64_t boot = 0;               // random and not 0
  std::string name = "user_interface";  // for people at the other end
  link::LinkSettings link = settings();
  // An order's place is kept for as long as a client may wait for its answer.
  [[nodiscard]] static link::LinkSettings settings() noexcept {
    link::LinkSettings result;
    result.answer_limit_ns = 10 * facts::kSecond_ns;
    return result;
  }
};

// Passive: told the time. From any threads: each call has it for some microseconds.
class ModuleLink {
 public:
  // Throws urdf::RobotError when the robot's description cannot be read.
  ModuleLink(const urdf::RobotModel& robot, const ModuleLinkOptions& options);
  ModuleLink(const ModuleLink&) = delete;
  ModuleLink& operator=(const ModuleLink&) = delete;

  // The mirrored topics, for set-up.
  [[nodiscard]] msgclient::Client topics(const std::string& name) { return mirror_.client(name); }
  // Called when there is something to send at once, to have pump() called soon.
  void on_urgent(std::function<void()> wake) { wake_ = std::move(wake); }

  // Brings the end and its carrier together, and what came to where it is read. Null: there is none.
  void pump(link::Carrier* carrier, std::int64_t now_ns);

  // Time passes, and nothing comes or goes.
  void step(std::int64_t now_ns);

  [[nodiscard]] bool open() const;
  // Which session there is; 0: none. Another number than before: the robot's side was lost meanwhile.
  [[nodiscard]] std::uint32_t session() const;
  // Why there is no session, for people.
  [[nodiscard]] std::string description() const;
  [[nodiscard]] link::SessionEnd why() const;
  // Whether the robot was calibrated with what this module's folder holds. Of a session.
  [[nodiscard]] bool same_calibration() const;

  // An order. `age_ns`: so long ago, at most, it was given; what is older than its kind may be is refused by
  // the robot's side by its own clock. The number under which take_result() tells what became of it.
  template <class Request>
  std::uint32_t order(contract::OrderKind kind, const Request& request, std::int64_t age_ns,
                      std::int64_t now_ns) {
    return order_untyped(kind, &request, age_ns, now_ns);
  }
  // Always taken. The number, as of an order; it is told when the robot has obeyed.
  std::uint32_t stop(link::StopKind kind);
  // The same for who gives no orders. Until those who do are told of it, and see_stops() says so, what they
  // order is not carried out.
  void stop_unseen(link::StopKind kind);
  void see_stops(std::uint32_t count);
  [[nodiscard]] std::optional<OrderResult> take_result(std::int64_t now_ns);
  // An order of this kind has no answer yet.
  [[nodiscard]] bool awaits(contract::OrderKind kind) const;
  [[nodiscard]] std::uint32_t next_number();
  // How many stops of each kind were asked for, and obeyed.
  [[nodiscard]] link::StopCounts stops_asked() const;
  [[nodiscard]] link::StopCounts stops_obeyed() const;
  [[nodiscard]] link::LinkStatistics statistics() const;

 private:
  struct Given {
    link::OrderId id;
    std::uint32_t number = 0;
    contract::OrderKind kind = contract::OrderKind::walk;
  };
  struct AwaitedStop {
    std::uint32_t number = 0;
    std::uint32_t link::StopCounts::*kind = nullptr;
    std::uint32_t count = 0;
  };
  // A velocity that waits since others are under way: the newest alone.
  struct WaitingVelocity {
    std::uint32_t number = 0;
    std::int64_t expiry_ns = 0;
    std::vector<std::uint8_t> payload;
  };

  std::uint32_t order_untyped(contract::OrderKind kind, const void* request, std::int64_t age_ns,
                              std::int64_t now_ns);
  void ask_stop(link::StopKind kind);
  void submit(contract::OrderKind kind, link::Bytes payload, std::int64_t expiry_ns, std::uint32_t number,
              std::int64_t now_ns);
  void submit_waiting(std::int64_t now_ns);
  void collect(std::int64_t now_ns);
  void refuse(std::uint32_t number, std::string text) {
    results_.push_back({number, false, std::move(text)});
  }
  [[nodiscard]] OrderResult result_of(const Given& given, const link::Outcome& outcome) const;
  [[nodiscard]] OrderResult answer_of(const Given& given, link::Bytes payload) const;

  contract::TopicCodec codec_, orders_;  // of state, of orders and answers
  StateMirror mirror_;
  std::string robot_;
  std::filesystem::path robot_directory_;
  std::uint16_t calibration_hash_;
  link::ModuleEnd end_;
  mutable std::mutex mutex_;
  std::function<void()> wake_;
  std::uint32_t last_number_;
  std::uint32_t stops_seen_ = 0;  // of all kinds, by those who give orders
  std::vector<Given> given_;
  std::size_t velocities_under_way_ = 0;
  std::optional<WaitingVelocity> waiting_;
  std::deque<AwaitedStop> stops_;
  std::deque<OrderResult> results_;
};

}  // namespace gaitway::api
