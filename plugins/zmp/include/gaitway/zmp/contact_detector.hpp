// Which feet bear load, and which of them is the support foot.
#pragma once

#include <array>

#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::zmp {

struct ContactThresholds {
  double on_N = 0.0;   // a foot is in contact from here
  double off_N = 0.0;  // and out of contact below
  double support_margin =
      0.0;  // the support changes when the other foot bears 0.5 + margin of the whole load
};

class ContactDetector {
 public:
  explicit ContactDetector(const ContactThresholds& thresholds) noexcept : thresholds_(thresholds) {}

  // force_N: measured, [Side]. A foot that alone is in contact is the support foot; in the air the last one
  // stays it.
  void update(const std::array<double, 2>& force_N) noexcept;

  [[nodiscard]] bool in_contact(urdf::Side side) const noexcept {
    return contact_[static_cast<std::size_t>(side)];
  }
  [[nodiscard]] urdf::Side support() const noexcept { return support_; }

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.contact_, self.support_);
  }

 private:
  ContactThresholds thresholds_;
  std::array<bool, 2> contact_{};
  urdf::Side support_ = urdf::Side::left;
};

}  // namespace gaitway::zmp
