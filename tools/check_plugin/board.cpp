// Shared memory between a check's process and its starter.
#include "tools/check_plugin/board.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "tools/check_plugin/plugin_check.hpp"

namespace gaitway::plugin_check {

std::string_view call_name(Call call) noexcept {
  constexpr std::array<std::string_view, 11> kNames{"none",       "load",          "create",  "activate",
                                                    "step",       "deactivate",    "destroy", "set_parameter",
                                                    "save_state", "restore_state", "unload"};
  return kNames[static_cast<std::size_t>(call)];
}

Board::Board() : memory_(memfd_create("plugin_check", MFD_CLOEXEC)) {
  if (!memory_ || ftruncate(memory_.get(), sizeof(BoardPage)) != 0) {
    throw CheckError(fmt::format("no shared memory for a check's process: {}", std::strerror(errno)));
  }
  map();
}

Board::Board(int fd) : memory_(fd) {
  map();
}

void Board::map() {
  void* const page =
      mmap(nullptr, sizeof(BoardPage), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_POPULATE, memory_.get(), 0);
  if (page == MAP_FAILED) {
    throw CheckError(fmt::format("no shared memory for a check's process: {}", std::strerror(errno)));
  }
  page_ = static_cast<BoardPage*>(page);  // all of it zero at first, which is a valid page
}

Board::~Board() {
  munmap(page_, sizeof(BoardPage));
}

void Board::enter(Call call) noexcept {
  page_->call.store(call);
  page_->beat.fetch_add(1);
}

void Board::enter_tick(std::uint32_t tick) noexcept {
  page_->tick.store(tick);
  enter(Call::step);
}

void Board::add(const OutputDigest& digest) noexcept {
  const std::uint32_t count = page_->digest_count.load();
  if (count < BoardPage::kDigests) {
    page_->digests[count] = digest;
    page_->digest_count.store(count + 1);
  }
}

void Board::begin_case(std::uint32_t index, std::string_view name) noexcept {
  const std::size_t length = std::min(name.size(), page_->case_name.size() - 1);
  std::copy_n(name.data(), length, page_->case_name.begin());
  page_->case_name[length] = '\0';
  page_->case_index.store(index);
  page_->call.store(Call::none);
  page_->beat.fetch_add(1);
}

void Board::add_line(const nlohmann::ordered_json& line) {
  const std::string text = line.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
  const std::uint32_t size = page_->text_size.load();
  if (size + text.size() <= BoardPage::kTextBytes) {
    std::ranges::copy(text, page_->text.begin() + size);
    page_->text_size.store(static_cast<std::uint32_t>(size + text.size()));
  }
}

std::vector<nlohmann::ordered_json> Board::lines() const {
  std::vector<nlohmann::ordered_json> lines;
  std::string_view rest(page_->text.data(), std::min<std::size_t>(page_->text_size, BoardPage::kTextBytes));
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size() - 1);
    nlohmann::ordered_json line = nlohmann::ordered_json::parse(rest.substr(0, end), nullptr, false);
    if (line.is_object()) {
      lines.push_back(std::move(line));
    }
    rest.remove_prefix(end + 1);
  }
  return lines;
}

std::span<const OutputDigest> Board::digests() const noexcept {
  return std::span(page_->digests).first(std::min<std::size_t>(page_->digest_count, BoardPage::kDigests));
}

std::string Board::place() const {
  const Call call = page_->call;
  const std::string_view name(page_->case_name.data(), strnlen(page_->case_name.data(), 256));
  std::string text = name.empty() ? std::string() : fmt::format("{}: ", name);
  text += call == Call::none ? "outside of the plug-in" : fmt::format("in {}", call_name(call));
  return call == Call::step ? text + fmt::format(" at tick {}", page_->tick.load()) : text;
}

}  // namespace gaitway::plugin_check
