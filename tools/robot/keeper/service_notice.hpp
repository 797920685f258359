// Tells the service manager how its service is, where it has asked for that: systemd's notify protocol.
#pragma once

#include <string>

namespace gaitway::tools {

class ServiceNotice {
 public:
  // Takes the socket's name out of the environment, so that no other program of this process's speaks for it.
  ServiceNotice();
  // "READY=1", "STATUS=…", "WATCHDOG=1", "STOPPING=1"; nothing where nobody has asked.
  void tell(const std::string& what) const;

 private:
  std::string socket_;  // empty: nobody has asked
};

}  // namespace gaitway::tools
