// A server's answers as clients of the memory block read them (msgclient/block_protocol.hpp), with up to
// three descriptors that come along. Whatever is sent: it is taken as a packet only if it is as long as an
// answer, bears the magic and as many descriptors as it says; descriptors that come in vain are closed;
// memory that is not sealed and of the announced size is refused with TopicError or std::system_error.
#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "fuzz_input.hpp"
#include "gaitway/msgclient/topic.hpp"
#include "memory_file.hpp"
#include "msgclient/block_protocol.hpp"
#include "sent_descriptors.hpp"

namespace gaitway::fuzz {
namespace {

using namespace msgclient;
using process::FileDescriptor;

void map_memory(protocol::ReceivedAnswer& received) {
  for (std::size_t i = 0; i < received.answer.fd_count; ++i) {
    try {
      const std::uint64_t announced = received.answer.segment_bytes[i];
      const int seals = fcntl(received.fds[i].get(), F_GET_SEALS);
      const auto segment = Segment::map(std::move(received.fds[i]), announced, Access::read_only);
      require(segment.size() == announced, "memory has the announced size");
      require((seals & F_SEAL_SHRINK) != 0, "memory cannot shrink");
    } catch (const TopicError&) {
    } catch (const std::system_error&) {
    }
  }
}

void check(Input& input) {
  std::array<int, 2> ends{};
  require(socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC | SOCK_NONBLOCK, 0, ends.data()) == 0,
          "a socket pair can be made");
  const FileDescriptor server(ends[0]), client(ends[1]);
  protocol::Answer answer;
  answer.fd_count = static_cast<std::uint32_t>(input.choose(4));
  answer.magic = input.choose(8) == 0 ? input.take<std::uint32_t>() : protocol::kMagic;
  answer.segment_bytes = {std::uint64_t{4096} * input.choose(3), input.take<std::uint64_t>()};
  const Segment sealed = Segment::create("gaitway_fuzz", 4096);
  const MemoryFile bare("not sealed");
  const FileDescriptor bare_again(open(bare.path().c_str(), O_RDONLY | O_CLOEXEC));
  const std::array<int, kMostDescriptors> descriptors{input.flag() ? sealed.fd() : bare_again.get(),
                                                      server.get(), sealed.fd()};
  const std::size_t count = input.choose(kMostDescriptors + 1);
  std::vector<std::byte> packet(sizeof answer);
  std::memcpy(packet.data(), &answer, sizeof answer);
  const std::size_t length = input.flag() ? input.take<std::uint16_t>() : packet.size();
  const auto overlay = input.take_bytes(input.size());
  constexpr std::size_t kHeader_bytes = sizeof answer.magic + 5 * sizeof(std::uint32_t);
  const std::size_t overlaid = std::min(overlay.size(), packet.size() - kHeader_bytes);
  std::transform(overlay.begin(), overlay.begin() + static_cast<std::ptrdiff_t>(overlaid),
                 packet.begin() + kHeader_bytes, [](auto byte) { return static_cast<std::byte>(byte); });
  packet.resize(std::max<std::size_t>(length, 1));
  send_with_descriptors(server.get(), packet, std::span(descriptors).first(count));

  protocol::ReceivedAnswer received;
  if (protocol::receive_answer(client.get(), received) == protocol::Received::packet) {
    require(packet.size() == sizeof answer, "only a packet of an answer's length is one");
    require(received.answer.magic == protocol::kMagic, "only a packet with the magic is an answer");
    require(received.answer.fd_count == count && count <= protocol::kMaxFds,
            "as many descriptors as announced");
    map_memory(received);
  }
}

}  // namespace

void block_answers(std::span<const std::uint8_t> bytes) {
  Input input(bytes);
  const std::ptrdiff_t before = open_descriptors();
  check(input);
  require(open_descriptors() == before, "no descriptor is left open");
}

}  // namespace gaitway::fuzz
