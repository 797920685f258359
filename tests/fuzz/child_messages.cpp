// Messages between the manager and a child (core/isolation/messages.hpp), written and read through a socket
// pair. Whatever the bytes and whatever is expected in them: they are read or refused with PluginError, no
// text is longer than the packet, what was written is what is read, and no descriptor that comes along stays
// open.
#include "core/isolation/messages.hpp"

#include <sys/socket.h>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "fuzz_input.hpp"
#include "sent_descriptors.hpp"

namespace gaitway::fuzz {
namespace {

using process::FileDescriptor;

struct SocketPair {
  SocketPair() {
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0) {
      throw std::runtime_error("no socket pair can be made");
    }
    one = FileDescriptor(ends[0]);
    other = FileDescriptor(ends[1]);
  }
  FileDescriptor one, other;
};

// A peer that sends more descriptors along than there is use for.
void check_descriptors(std::size_t count) {
  const std::ptrdiff_t before = open_descriptors();
  {
    const SocketPair pair;
    std::array<std::byte, 8> packet{};
    const std::array<int, kMostDescriptors> descriptors{pair.one.get(), pair.one.get(), pair.other.get()};
    send_with_descriptors(pair.one.get(), packet, std::span(descriptors).first(count));
    std::vector<std::byte> received;
    FileDescriptor descriptor;
    try {
      (void)core::receive_packet(pair.other, received, core::Wait::no, &descriptor);
    } catch (const core::PluginError&) {
    }
  }
  require(open_descriptors() == before, "no descriptor is left open");
}

std::vector<std::byte> through_a_socket(std::span<const std::byte> packet) {
  const SocketPair pair;
  require(core::send_packet(pair.one, packet, core::Wait::no) == core::Sent::whole,
          "a packet of this size can be sent");
  std::vector<std::byte> received;
  FileDescriptor descriptor;
  require(core::receive_packet(pair.other, received, core::Wait::no, &descriptor) == core::Receipt::packet,
          "what was sent arrives");
  require(!descriptor, "no descriptor comes where none was sent");
  return received;
}

// Reads whatever the fuzzer expects next, to the packet's end.
void read_as_told(Input expected, std::span<const std::byte> packet) {
  core::PacketReader reader(packet);
  std::size_t left = packet.size();
  const auto take = [&left](std::size_t size) {
    require(size <= left, "nothing is read past the end");
    left -= size;
  };
  try {
    while (!expected.empty()) {
      std::string kept;
      switch (expected.choose(4)) {
        case 0:
          reader.number<std::uint32_t>();
          take(4);
          break;
        case 1:
          reader.number<double>();
          take(8);
          break;
        case 2:
          take(4 + reader.text().size());
          break;
        default: {
          const gaitway_value value = reader.value(kept);
          take(4 + 8 + 8 + 4 + kept.size());
          require((value.text != nullptr) == (value.kind == GAITWAY_TEXT), "only texts have a text");
        }
      }
    }
  } catch (const core::PluginError&) {
  }
}

void check_round_trip(Input input) {
  const auto number = input.take<std::uint32_t>();
  gaitway_value value{};
  value.kind = input.take<std::uint32_t>();
  value.integer = input.take<std::int64_t>();
  const std::string text(input.take_text(200)), value_text(input.rest_as_text());
  value.text = value_text.c_str();
  core::PacketWriter writer(core::ChildMessage::parameter);
  writer.number(number).text(std::string_view(text)).value(value);
  const std::vector<std::byte> packet = through_a_socket(writer.bytes());
  core::PacketReader reader(packet);
  require(reader.number<core::ChildMessage>() == core::ChildMessage::parameter, "the kind comes back");
  require(reader.number<std::uint32_t>() == number, "the number comes back");
  require(reader.text() == text, "the text comes back");
  std::string kept;
  const gaitway_value again = reader.value(kept);
  require(again.kind == value.kind && again.integer == value.integer && kept == value.text,
          "the value comes back");
}

}  // namespace

void child_messages(std::span<const std::uint8_t> bytes) {
  Input input(bytes);
  check_descriptors(input.choose(kMostDescriptors + 1));
  check_round_trip(input);
  const std::span<const std::uint8_t> expected = input.take_bytes(16);
  if (!input.empty()) {
    const auto packet = through_a_socket(std::as_bytes(input.take_bytes(input.size())));
    read_as_told(Input(expected), packet);
  }
}

}  // namespace gaitway::fuzz
