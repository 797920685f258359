// What can be seen of a running robot from beside it, in the memory block that its message controller gives
// out: signs of work of its parts, and whether it may be commanded. Reads alone, and waits for nobody for
// long.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace gaitway::tools {

class RobotView {
 public:
  explicit RobotView(std::filesystem::path memory_socket);
  ~RobotView();
  RobotView(const RobotView&) = delete;
  RobotView& operator=(const RobotView&) = delete;

  // True: there is a memory block; asks for one where there was none.
  bool look();
  // The message controller has ended: its memory block is no longer looked into.
  void forget();

  // Why something in the block cannot be read; told once. Empty: all can.
  [[nodiscard]] std::string take_complaint();

  // Numbers that grow with the work of a part; nothing: it cannot be seen now.
  [[nodiscard]] std::optional<std::uint64_t> message_controller_beats() const;
  [[nodiscard]] std::optional<std::uint64_t> main_controller_reports();
  [[nodiscard]] std::optional<std::uint64_t> joint_feedback();
  // Its joints answer and carry out the batches of its main controller: whoever commands it now is obeyed.
  [[nodiscard]] bool may_be_commanded(std::int64_t now_ns) { return why_not_commanded(now_ns).empty(); }
  // Why not, for people; empty: it may be.
  [[nodiscard]] std::string why_not_commanded(std::int64_t now_ns);
  // Who commands it, since when and why, for people; empty: it does not say.
  [[nodiscard]] std::string who_commands(std::int64_t now_ns);
  // It stands by itself and waits for batches, or an emergency stop holds it.
  [[nodiscard]] bool holds(std::int64_t now_ns);

 private:
  struct Block;
  [[nodiscard]] std::string why_no_feedback(std::int64_t now_ns);

  std::filesystem::path socket_;
  std::unique_ptr<Block> block_;
};

}  // namespace gaitway::tools
