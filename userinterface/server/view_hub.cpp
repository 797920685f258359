// A frame is made when its connection can take it, never before: there is nothing that could queue.
#include "gaitway/api/view_hub.hpp"

#include <algorithm>
#include <deque>
#include <optional>
#include <utility>

#include "gaitway/page/view_frame.hpp"

namespace gaitway::api {
namespace {

constexpr std::uint16_t kNotForTheView = 1008;
constexpr std::size_t kAcknowledgement_bytes = 4;

std::uint32_t little_endian(std::string_view bytes) noexcept {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    number |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i])) << (8 * i);
  }
  return number;
}

}  // namespace

class ViewSession final : public Session {
 public:
  ViewSession(ViewHub& hub, Connection& connection, bool authorised, std::int64_t wall_ns)
      : hub_(hub), connection_(connection), authorised_(authorised), opened_ns_(wall_ns) {
    hub_.sessions_.insert(this);
  }
  ViewSession(const ViewSession&) = delete;
  ViewSession& operator=(const ViewSession&) = delete;
  ~ViewSession() override { hub_.sessions_.erase(this); }

  void take(std::string_view message, bool binary, std::int64_t wall_ns) override {
    if (closing_) {
      return;
    }
    if (!authorised_) {
      authorise(message, binary);
    } else if (!binary || message.size() != kAcknowledgement_bytes ||
               !acknowledge(little_endian(message), wall_ns)) {
      close("the view takes nothing but acknowledgements of its frames");
    }
  }
  // Nothing that it takes is urgent, so nothing is overtaken.
  void take_overtaken(std::string_view message, bool binary, std::int64_t wall_ns) override {
    take(message, binary, wall_ns);
  }
  [[nodiscard]] Urgency urgency(std::string_view, bool) const noexcept override { return Urgency::none; }
  [[nodiscard]] bool may_give_orders() const noexcept override { return false; }
  std::optional<Frame> next_frame(std::int64_t wall_ns) override {
    if (!ready()) {
      return std::nullopt;
    }
    sent_ = hub_.state_.frame;
    in_flight_.push_back({sent_, wall_ns});
    page::ViewState state = hub_.state_;
    state.round_trip_s = round_trip_s_;
    return Frame{std::make_shared<const std::string>(page::encode_view(state)), true};
  }
  [[nodiscard]] bool authorised() const noexcept override { return authorised_; }

  void wake() {
    if (ready()) {
      connection_.wake();
    }
  }
  void step(std::int64_t wall_ns) {
    if (!authorised_ && wall_ns - opened_ns_ >= hub_.options_.authentication_ns) {
      close("not authorised in time");
    }
  }

 private:
  struct Sent {
    std::uint32_t frame;
    std::int64_t wall_ns;
  };

  [[nodiscard]] bool ready() const noexcept {
    return authorised_ && !closing_ && sent_ != hub_.state_.frame &&
           in_flight_.size() < ViewHub::kMostInFlight;
  }
  void authorise(std::string_view message, bool binary) {
    authorised_ = !binary && hub_.options_.is_token && hub_.options_.is_token(message);
    if (!authorised_) {
      connection_.shown_wrong_token();
      close("the token is wrong");
    }
  }
  // Of this frame and those before it. False: it was not sent, or has been acknowledged.
  bool acknowledge(std::uint32_t frame, std::int64_t wall_ns) {
    const auto sent = std::ranges::find(in_flight_, frame, &Sent::frame);
    if (sent == in_flight_.end()) {
      return false;
    }
    round_trip_s_ = static_cast<double>(wall_ns - sent->wall_ns) * 1e-9;
    in_flight_.erase(in_flight_.begin(), sent + 1);
    wake();
    return true;
  }
  void close(std::string_view reason) {
    if (!std::exchange(closing_, true)) {
      connection_.close(kNotForTheView, reason);
    }
  }

  ViewHub& hub_;
  Connection& connection_;
  bool authorised_;
  bool closing_ = false;
  std::int64_t opened_ns_;
  std::uint32_t sent_ = 0;
  double round_trip_s_ = page::kUnknown;
  std::deque<Sent> in_flight_;
};

std::unique_ptr<Session> ViewHub::open(Connection& connection, std::string, bool authorised,
                                       std::int64_t wall_ns) {
  return std::make_unique<ViewSession>(*this, connection, authorised, wall_ns);
}

void ViewHub::step(std::int64_t wall_ns) {
  for (ViewSession* const session : sessions_) {
    session->step(wall_ns);
  }
}

void ViewHub::show(const page::ViewState& state, std::int64_t wall_ns) {
  due_ns_ = std::max(due_ns_ + kPeriod_ns, wall_ns - wall_ns % kPeriod_ns + kPeriod_ns);
  const std::uint32_t frame = state_.frame + 1;
  state_ = state;
  state_.frame = frame;
  commander_ = state.commander;
  state_.commander = commander_;
  for (ViewSession* const session : sessions_) {
    session->wake();
  }
}

}  // namespace gaitway::api
