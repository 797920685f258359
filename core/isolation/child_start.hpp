// A child from its first moment until its plug-in is constructed and its memory is shared.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "child.hpp"
#include "gaitway/instance/loaded_plugin.hpp"
#include "gaitway/isolation/settings.hpp"
#include "messages.hpp"

namespace gaitway::core {

// The manager's side, message by message: an explicit state machine that neither sends nor waits. Whatever
// the child says, and in whatever order, is taken or refused.
//
//   constructing --created--> attaching --attached--> attached
//
// While it is constructing, the child asks for topics, parameters and its period, and waits for each answer;
// it may report at any time. Everything else is refused, and the start has failed.
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

// What each child of one plug-in is started with.
struct ChildPlan {
  // `entry` and `source` are copied. Makes the folder that it may write to. Throws PluginError.
  ChildPlan(const PluginEntry& entry, const PluginSource& source, const IsolationOptions& options);

  std::filesystem::path binary;
  ChildBounds bounds;
  std::int64_t start_limit_ns;
  std::string library;  // as the configuration names it
  PacketWriter create{ChildMessage::create};
};

// What StartUp decides is carried out here.
class ChildStart {
 public:
  enum class Progress : std::uint8_t { waits, constructed, failed, attached };

  // Starts it. All outlive this. Throws PluginError.
  ChildStart(const ChildPlan& plan, PluginDeclarations& declarations);

  // Answers what it asks, for at most so long; for longer only if one message follows the other. Constructed:
  // now child() is to be attached; failed: the constructor, text() says why. Throws PluginError when it ends,
  // hangs or cannot be understood.
  Progress attend(std::int64_t wait_ns);
  [[nodiscard]] bool is_overdue() const noexcept;
  [[nodiscard]] const std::string& text() const noexcept { return start_up_.text(); }
  [[nodiscard]] Child& child() noexcept { return *child_; }
  [[nodiscard]] std::unique_ptr<Child> take_child() noexcept { return std::move(child_); }
  [[nodiscard]] const LibraryDescription& library() const noexcept { return start_up_.library(); }

 private:
  const ChildPlan& plan_;
  StartUp start_up_;
  std::unique_ptr<Child> child_;
  std::int64_t began_ns_;
  std::int64_t hung_up_ns_ = 0;  // 0: it has not
};

}  // namespace gaitway::core
