// The built-in fallbacks: which one writes the topics of which kind.
#include "estimate_fallback.hpp"
#include "gaitway/manager/fallback.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "trim_fallback.hpp"

namespace gaitway::core {
namespace {

// In place of whoever commands the walk: finish the step and stand.
class StopFallback final : public Fallback {
 public:
  void follow(const Tick&) noexcept override {}
  bool act(const Tick& tick, ManagedPlugin& through) noexcept override {
    WalkCommand stop{};
    stop.stamp_ns = tick.now_ns;
    return through.publish_in_place("walk_command", stop, tick.now_ns);
  }
};

}  // namespace

std::unique_ptr<Fallback> make_fallback(FallbackKind kind, const FallbackSource& source) {
  switch (kind) {
    case FallbackKind::estimate:
      return std::make_unique<EstimateFallback>(source);
    case FallbackKind::trims_from_gains:
    case FallbackKind::trims_to_zero:
      return std::make_unique<TrimFallback>(source.client, kind == FallbackKind::trims_from_gains);
    case FallbackKind::stop:
      return std::make_unique<StopFallback>();
    default:
      return nullptr;
  }
}

}  // namespace gaitway::core
