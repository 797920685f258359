// The soft limit goes up as far as it must; the hard one is the system's.
#include "gaitway/api/descriptor_bound.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <stdexcept>

namespace gaitway::api {

void provide_descriptors(const Limits& limits) {
  const rlim_t most = most_descriptors(limits);
  rlimit bound{};
  getrlimit(RLIMIT_NOFILE, &bound);
  if (bound.rlim_max < most) {
    throw std::runtime_error(
        fmt::format("limits: connections = {}: {} descriptors are needed for them, but the system gives this "
                    "process {}: raise "
                    "that (LimitNOFILE= of systemd, `ulimit -Hn`), or allow fewer connections",
                    limits.connections, most, bound.rlim_max));
  }
  bound.rlim_cur = std::max(bound.rlim_cur, most);
  setrlimit(RLIMIT_NOFILE, &bound);
}

}  // namespace gaitway::api
