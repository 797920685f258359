// The smallest plug-in that class_loader loads.
#include <class_loader/register_macro.hpp>

#include "loading_peer.hpp"

namespace gaitway::bench {

class Relay final : public LoadingPeer {
 public:
  void step(double now_s) override { value_ = now_s; }

 private:
  double value_ = 0.0;
};

}  // namespace gaitway::bench

CLASS_LOADER_REGISTER_CLASS(gaitway::bench::Relay, gaitway::bench::LoadingPeer)
