// The manager's side of a child's start, message by message: an explicit state machine that neither sends nor
// waits. Whatever the child says, and in whatever order, is taken or refused.
//
//   constructing --created--> attaching --attached--> attached
//
// While it is constructing, the child asks for topics, parameters and its period, and waits for each answer;
// it may report at any time. Everything else is refused, and the start has failed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "messages.hpp"
#include "plugin_declarations.hpp"

namespace gaitway::core {

class StartUp {
 public:
  // At most so many topics and parameters together.
  static constexpr std::size_t kMostDeclarations = 1024;
  enum class Next : std::uint8_t {
    wait,    // for the next message
    answer,  // send answer()
    attach,  // make the segment and hand it over
    failed,  // the constructor: text() says why
    done
  };

  // `declarations`: where the plug-in's go; what it refuses is the answer. Outlives this.
  explicit StartUp(PluginDeclarations& declarations) : declarations_(declarations) {}

  // Throws PluginError: the child said what no child says here, or its library cannot be used.
  Next take(std::span<const std::byte> message);
  [[nodiscard]] std::span<const std::byte> answer() const noexcept { return answer_.bytes(); }
  [[nodiscard]] const std::string& text() const noexcept { return text_; }
  // Of the library, once it is attaching.
  [[nodiscard]] const LibraryDescription& library() const noexcept { return library_; }

 private:
  enum class State : std::uint8_t { constructing, attaching, attached, failed };

  void require(State state, ChildMessage message) const;
  template <class Function>
  Next grant(const Function& function);
  void take_topic(PacketReader& packet);
  void take_parameter(PacketReader& packet);

  PluginDeclarations& declarations_;
  State state_ = State::constructing;
  std::size_t declared_ = 0;
  PacketWriter answer_{ChildMessage::granted};
  std::string text_;
  LibraryDescription library_;
};

}  // namespace gaitway::core
