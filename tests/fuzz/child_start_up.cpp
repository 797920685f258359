// The manager's side of a child's start (core/isolation/child_start.hpp), told any messages in any order.
// Whatever the child says: it is taken or refused with PluginError, each question is answered, only what was
// checked is handed on and only before the plug-in is constructed, and there is no end but after the segment
// was asked for.
#include "core/isolation/child_start.hpp"

#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz_input.hpp"
#include "gaitway/msgclient/memory_block.hpp"

namespace gaitway::fuzz {
namespace {

using core::ChildMessage;
using core::PacketWriter;
using core::StartUp;

class Declarations final : public core::PluginDeclarations {
 public:
  bool refuses = false;
  bool constructed = false;
  std::size_t declared = 0;

  gaitway_port* open_topic(const gaitway_topic& topic, gaitway_access access) override {
    require(access <= GAITWAY_READ_PREVIOUS_OPTIONAL, "an access that there is");
    require(topic.size > 0 && topic.size <= msgclient::kMaxBlockBytes,
            "a value that a memory block can hold");
    std::size_t bytes = std::strlen(topic.name) + std::strlen(topic.type_name);
    for (std::uint32_t i = 0; i < topic.float_field_count; ++i) {
      bytes += std::strlen(topic.float_fields[i].name);
    }
    require(bytes <= 4096, "no text is longer than the message");
    count();
    return nullptr;
  }
  gaitway_value declare_parameter(const gaitway_parameter& parameter) override {
    require(parameter.name[0] != '\0', "a parameter has a name");
    require(parameter.fallback.kind != GAITWAY_TEXT || parameter.fallback.text != nullptr, "a text is there");
    count();
    return parameter.fallback;
  }
  void set_period(gaitway_period period) override {
    require(period <= GAITWAY_EVERY_BATCH, "a period that there is");
    count();
  }
  void report(gaitway_severity, std::string_view text) noexcept override {
    require(text.size() <= 160, "a report is cut off");
  }

 private:
  void count() {
    require(!constructed, "nothing is declared once the plug-in is constructed");
    require(++declared <= StartUp::kMostDeclarations, "declarations have an end");
    if (refuses) {
      throw core::PluginError("refused");
    }
  }
};

PacketWriter topic(Input& input) {
  PacketWriter packet(ChildMessage::open_topic);
  packet.text(input.take_text(20)).text("Type").number(std::uint64_t{1});
  packet.number(input.flag() ? 8U : input.take<std::uint32_t>()).number(input.take<std::uint8_t>() % 8U);
  const auto fields = static_cast<std::uint32_t>(input.choose(3));
  packet.number(input.choose(8) == 0 ? input.take<std::uint32_t>() : fields);
  for (std::uint32_t i = 0; i < fields; ++i) {
    packet.text("field").number(0U).number(1U).number(8U).number(1U).number(0.0).number(0.0);
  }
  return packet;
}

PacketWriter parameter(Input& input) {
  PacketWriter packet(ChildMessage::parameter);
  packet.text(input.take_text(20)).text("1").text("");
  packet.value({static_cast<gaitway_kind>(input.choose(6)), 0, 1.0, 1, "text"});
  return packet.number(0.0).number(2.0).number(0U);
}

PacketWriter message(Input& input) {
  switch (input.choose(6)) {
    case 0:
      return topic(input);
    case 1:
      return parameter(input);
    case 2:
      return PacketWriter(ChildMessage::set_period).number(static_cast<std::uint32_t>(input.choose(3)));
    case 3:
      return PacketWriter(ChildMessage::created).text("it").text("1").text("").text("/it.so");
    case 4: {
      PacketWriter packet(static_cast<ChildMessage>(input.choose(16)));
      return packet.text(input.take_text(300));
    }
    default: {
      PacketWriter packet(static_cast<ChildMessage>(input.take<std::uint32_t>()));
      for (const std::uint8_t byte : input.take_bytes(input.choose(40))) {
        packet.number(byte);
      }
      return packet;
    }
  }
}

}  // namespace

void child_start_up(std::span<const std::uint8_t> bytes) {
  Input input(bytes);
  Declarations declarations;
  StartUp start(declarations);
  bool done = false;
  try {
    while (!input.empty()) {
      declarations.refuses = input.choose(8) == 0;
      const std::size_t declared = declarations.declared;
      const PacketWriter packet = message(input);
      const StartUp::Next next = start.take(packet.bytes());
      require(!done || next == StartUp::Next::wait, "nothing but reports comes after the end");
      require(declared == declarations.declared || next == StartUp::Next::answer, "a question is answered");
      if (next == StartUp::Next::answer) {
        const auto kind = core::PacketReader(start.answer()).number<ChildMessage>();
        require(kind == ChildMessage::granted || kind == ChildMessage::refused, "by yes or no");
      }
      if (next == StartUp::Next::attach) {
        require(!declarations.constructed, "the segment is made once");
        declarations.constructed = true;
      }
      if (next == StartUp::Next::done) {
        require(declarations.constructed, "there is a segment before it is used");
        done = true;
      }
      if (next == StartUp::Next::failed) {
        return;
      }
    }
  } catch (const core::PluginError&) {
  }
}

}  // namespace gaitway::fuzz
