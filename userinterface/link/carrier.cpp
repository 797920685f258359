// From carrier to end, and back.
#include "gaitway/link/carrier.hpp"

#include <array>

namespace gaitway::link {

void pump(LinkEnd& end, Carrier& carrier, std::int64_t now_ns, int most_reads) noexcept {
  std::array<std::uint8_t, kReadBytes> arrived;
  for (int reads = 0; reads < most_reads; ++reads) {
    const std::size_t count = carrier.read(arrived);
    if (count == 0) {
      break;
    }
    end.on_bytes(Bytes(arrived).first(count), now_ns);
  }
  if (!carrier.connected()) {
    end.cut(now_ns);
    return;
  }
  end.step(now_ns);
  for (Bytes bytes = end.pending(now_ns); !bytes.empty(); bytes = end.pending(now_ns)) {
    const std::size_t count = carrier.write(bytes);
    end.taken(count);
    if (count < bytes.size()) {
      break;
    }
  }
}

}  // namespace gaitway::link
