// The page that a check's process shares with the one that started it: what it is doing at the moment, so
// that a crash or a hang has a place, and what it found so far, so that none of it is lost.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::plugin_check {

enum class Call : std::uint32_t {
  none,
  load,
  create,
  activate,
  step,
  deactivate,
  destroy,
  set_parameter,
  save_state,
  restore_state,
  unload
};
std::string_view call_name(Call call) noexcept;

// What one output was in one step; two runs are compared by these.
struct OutputDigest {
  std::uint32_t tick = 0;
  std::uint32_t port = 0;
  std::uint64_t digest = 0;
  friend bool operator==(const OutputDigest&, const OutputDigest&) = default;
};

struct BoardPage {
  static constexpr std::size_t kTextBytes = std::size_t{1} << 20;
  static constexpr std::size_t kDigests = std::size_t{1} << 16;

  std::atomic<std::uint32_t> beat;  // grows with every call into the plug-in
  std::atomic<std::uint32_t> case_index;
  std::atomic<Call> call;
  std::atomic<std::uint32_t> tick;
  std::array<char, 256> case_name;
  std::array<char, 768> crash;  // of a signal handler: what happened, and where in the plug-in
  std::atomic<std::uint32_t> text_size;
  std::atomic<std::uint32_t> digest_count;
  std::array<OutputDigest, kDigests> digests;
  std::array<char, kTextBytes> text;  // one JSON object a line
};

class Board {
 public:
  Board();                 // makes the memory
  explicit Board(int fd);  // maps the memory that another process made
  ~Board();
  Board(const Board&) = delete;
  Board& operator=(const Board&) = delete;

  [[nodiscard]] int fd() const noexcept { return memory_.get(); }
  [[nodiscard]] BoardPage& page() noexcept { return *page_; }
  [[nodiscard]] const BoardPage& page() const noexcept { return *page_; }

  // For the cycle.
  void enter(Call call) noexcept;
  void enter_tick(std::uint32_t tick) noexcept;
  void add(const OutputDigest& digest) noexcept;

  void begin_case(std::uint32_t index, std::string_view name) noexcept;
  void add_line(const nlohmann::ordered_json& line);
  // All whole lines so far.
  [[nodiscard]] std::vector<nlohmann::ordered_json> lines() const;
  [[nodiscard]] std::span<const OutputDigest> digests() const noexcept;
  // "case 'x', in step at tick 12"
  [[nodiscard]] std::string place() const;

 private:
  void map();

  process::FileDescriptor memory_;
  BoardPage* page_ = nullptr;
};

}  // namespace gaitway::plugin_check
