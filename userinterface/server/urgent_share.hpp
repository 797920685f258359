// Which of a client's urgent messages need not wait for their turn, so that no client's urgency delays
// another's.
#pragma once

#include "gaitway/api/session.hpp"

namespace gaitway::api {

// From one sweep to the next so many of each client, whatever the others do, and more while all have sent no
// more than so many beyond. Who sends still more must wait for his turn. Emergencies have a number of their
// own: they wait for no urgent ones of their own sender.
class UrgentShare {
 public:
  // `beyond`: what all clients have taken beyond their own.
  [[nodiscard]] bool may_overtake(Urgency urgency, unsigned& beyond) noexcept {
    if (urgency == Urgency::none) {
      return false;
    }
    return take_from(urgent_, kUrgentAtOnce) || take_from(beyond, kUrgentOfAll) ||
           (urgency == Urgency::emergency && take_from(emergencies_, kEmergenciesAtOnce));
  }
  void begin_anew() noexcept { urgent_ = emergencies_ = 0; }

 private:
  static constexpr unsigned kUrgentAtOnce = 4, kUrgentOfAll = 64, kEmergenciesAtOnce = 2;

  static bool take_from(unsigned& taken, unsigned most) noexcept { return taken < most && ++taken > 0; }

  unsigned urgent_ = 0, emergencies_ = 0;
};

}  // namespace gaitway::api
