// Angles into the trim frame's signed bytes.
#include "gaitway/msgcontroller/trim_sender.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "gaitway/facts/facts.hpp"

namespace gaitway::msgcontroller {
namespace {

// No trim from the main controller by then: the message controller makes its own. Once the main controller
// has been silent for two slots, it does so as soon as the feedback is in, since every millisecond costs
// stability.
constexpr std::int64_t kOwnTrimInSlot_ns = 7 * facts::kMillisecond_ns;
constexpr std::uint32_t kSlotsWithoutTrims = 2;

}  // namespace

void TrimSender::take(const msgclient::TrimUpdate& update) noexcept {
  const std::span<const float> given = std::span(update.angle).first(update.channel_count);
  if (!std::ranges::all_of(given, [](float angle) { return std::isfinite(angle); }) ||
      !std::isfinite(update.softness)) {
    return;
  }
  softness_ = static_cast<std::uint8_t>(
      std::lround(std::clamp(update.softness, 0.0F, 1.0F) * static_cast<float>(can::kMostSoftness)));
  std::array<double, kTrimChannels> angle{};
  std::ranges::copy(given, angle.begin());
  send(angle);
  last_taken_slot_ = link_.slots_since_start;
}

void TrimSender::stand_in(std::int64_t in_slot_ns, bool heard, const FeedbackCollector& feedback,
                          std::uint8_t support) noexcept {
  const bool silent = link_.slots_since_start - last_taken_slot_ > kSlotsWithoutTrims;
  const bool due = silent ? heard : in_slot_ns == kOwnTrimInSlot_ns;
  if (sent_in_this_slot_ || !due || gains_.channel_count == 0 || link_.mode() == Mode::emergency_stop) {
    return;
  }
  const msgclient::TrunkMotion motion{.roll = feedback.tilt_rad().x(),
                                      .pitch = feedback.tilt_rad().y(),
                                      .roll_rate = feedback.imu().angular_velocity[0],
                                      .pitch_rate = feedback.imu().angular_velocity[1]};
  send(msgclient::trim_angles(gains_, support, motion, settings_.limit_rad));
}

void TrimSender::send(std::span<const double> angle_rad) noexcept {
  if (!link_.profile.has(can::MessageKind::trim)) {
    return;
  }
  can::Trim trim;
  for (std::size_t channel = 0; channel < trim.count.size(); ++channel) {
    const double limited = std::clamp(angle_rad[channel], -settings_.limit_rad, settings_.limit_rad);
    trim.count[channel] =
        static_cast<std::int8_t>(std::clamp(std::lround(limited / settings_.count_rad), -127L, 127L));
  }
  link_.send(can::encode(link_.profile, trim), link_.slot_start_ns + 2 * facts::kSlot_ns);
  sent_in_this_slot_ = true;
}

}  // namespace gaitway::msgcontroller
