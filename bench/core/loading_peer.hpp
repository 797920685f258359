// What ROS's class_loader needs of a plug-in: a base class that both sides know.
#pragma once

namespace gaitway::bench {

class LoadingPeer {
 public:
  virtual ~LoadingPeer() = default;
  virtual void step(double now_s) = 0;
};

}  // namespace gaitway::bench
