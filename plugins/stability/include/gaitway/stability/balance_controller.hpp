// The balance feedback of one tick: estimate and plan in, trims and batch corrections out.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/stability/balance_parameters.hpp"
#include "gaitway/stability/batch_feedback.hpp"
#include "gaitway/stability/fall_reaction.hpp"
#include "gaitway/stability/hip_strategy.hpp"
#include "gaitway/stability/plan_timeline.hpp"
#include "gaitway/stability/sole_alignment.hpp"
#include "gaitway/stability/trim_feedback.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::stability {

// What there is to know at a tick; null: nothing heard.
struct BalanceInputs {
  const Estimate* estimate = nullptr;
  const MotionPlan* plan = nullptr;  // the newest
  const NetworkState* network = nullptr;
};

// To be updated every 10 ms. Not thread-safe.
class BalanceController {
 public:
  // The parameters must outlive it: they may change between two updates. Throws std::invalid_argument (see
  // BalanceParameters::validate).
  BalanceController(const urdf::RobotModel& model, const BalanceParameters& parameters);
  BalanceController(const urdf::RobotModel& model, BalanceParameters&& parameters) = delete;

  // From the recognition of a fall on the joints go soft, see FallReaction. The support comes from the plan
  // that plays now; without a plan, from the estimate's contacts. Trims fade to zero while the estimate is
  // missing, too old or not finite, while the robot falls or lies, is in the air, on the ground by its
  // motion, or has neither plan nor contact. While a key-frame motion plays, the trunk is balanced about
  // where the motion has it, and the lean that was learned is kept; the message controller, which knows of no
  // moving reference, gets no gains for a tail through which the trunk is to lean. No allocation.
  void update(std::int64_t now_ns, const BalanceInputs& inputs, TrimCommand& trim,
              Correction& correction) noexcept;

  [[nodiscard]] const SoleAlignment& soles() const noexcept { return soles_; }
  [[nodiscard]] const HipStrategy& hips() const noexcept { return hips_; }

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.timeline_, self.trims_, self.heading_, self.speed_, self.lean_, self.fall_reaction_,
            self.soles_, self.centring_, self.hips_, self.without_contact_s_, self.without_batches_s_,
            self.held_lean_rad_);
  }

 private:
  // What there is now, and what follows from it for every feedback.
  struct Situation {
    std::optional<PlanMoment> moment;    // none: nothing is planned for now
    PlanMoment meant;                    // the same, and what the bow adds to it
    msgclient::Bow bow;                  // as it is meant to be now
    const Estimate* estimate = nullptr;  // only one that can be balanced by
    std::size_t support = kBothFeet;
    bool grounded = false;  // there is an estimate, and ground to press on
    bool stands = false;    // and the robot is to stand upon it
    bool sways = true;
    bool bows = false;
    bool obeys = true;  // the joints do what is planned: no emergency stop
  };

  void lean_as_held(const BalanceInputs& inputs, PlanMoment& meant) noexcept;
  [[nodiscard]] Situation assess(std::int64_t now_ns, const BalanceInputs& inputs) noexcept;
  void soften(const Estimate* estimate, const Situation& now, TrimCommand& trim) noexcept;
  void balance_trunk(const Situation& now, TrimCommand& trim) noexcept;
  void learn(const Situation& now) noexcept;
  void steer(const Situation& now, Correction& correction) noexcept;
  void bow(const Situation& now, const MotionPlan* plan, std::optional<std::uint32_t> accepted_sequence,
           Correction& correction) noexcept;

  [[nodiscard]] bool is_usable(const Estimate* estimate, const PlanMoment& meant,
                               std::int64_t now_ns) const noexcept;
  [[nodiscard]] static std::optional<std::size_t> support_of(const std::optional<PlanMoment>& moment,
                                                             const Estimate& estimate) noexcept;
  [[nodiscard]] bool is_airborne(const Estimate& estimate) noexcept;

  const BalanceParameters& parameters_;
  PlanTimeline timeline_;
  TrimFeedback trims_;
  HeadingFeedback heading_;
  SpeedFeedback speed_;
  LeanIntegrator lean_;
  FallReaction fall_reaction_;
  SoleAlignment soles_;
  ComCentring centring_;
  HipStrategy hips_;
  double without_contact_s_ = 0.0;
  double without_batches_s_ = 0.0;
  std::array<double, 2> held_lean_rad_{};  // roll, pitch: see lean_as_held()
};

}  // namespace gaitway::stability
