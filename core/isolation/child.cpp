// A socket pair, a process, a sealed segment. What lies in the segment may change at any time: it is read
// once, and no length in it is believed.
#include "child.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <string.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <new>
#include <system_error>
#include <utility>

#include "gaitway/process/real_time.hpp"

namespace gaitway::core {
namespace {

constexpr std::int64_t kLook_ns = 500'000;  // between two looks whether it still lives

template <std::size_t size>
std::string_view text_up_to_nul(const char (&text)[size]) noexcept {
  return {text, strnlen(text, size - 1)};
}

}  // namespace

Child::Child(const std::filesystem::path& binary, const ChildBounds& bounds, const std::string& library)
    : library_(library) {
  int ends[2] = {-1, -1};
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0) {
    throw PluginError(fmt::format("no socket pair for its process: {}", strerror(errno)));
  }
  socket_ = process::FileDescriptor(ends[0]);
  const process::FileDescriptor theirs(ends[1]);
  process_ = ChildProcess(binary, theirs, bounds);
}

void Child::send(std::span<const std::byte> packet, int descriptor) {
  if (send_packet(socket_, packet, Wait::no, descriptor) == Sent::full) {
    throw PluginError("its process does not read what it is answered");
  }
}

void Child::wait_for_message(int timeout_ms, bool hung_up) const noexcept {
  pollfd watched[]{{hung_up ? -1 : socket_.get(), POLLIN, 0}, {process_.fd(), POLLIN, 0}};
  poll(watched, 2, timeout_ms);
}

void Child::attach(const Ports& ports) {
  std::vector<std::uint32_t> sizes;
  for (const TopicPort& port : ports) {
    sizes.push_back(port.use().size);
  }
  samples_.assign(ports.size(), {});
  layout_ = std::make_unique<ExchangeLayout>(sizes);
  try {
    segment_ = std::make_unique<msgclient::Segment>(
        msgclient::Segment::create("gaitway plug-in exchange", layout_->bytes));
  } catch (const std::system_error& error) {
    throw PluginError(error.what());
  }
  new (segment_->data()) ExchangeHeader;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    new (&port(i)) PortArea;
  }
  send(PacketWriter(ChildMessage::attach).bytes(), segment_->fd());
}

void Child::copy_in(Ports& ports) noexcept {
  std::size_t i = 0;
  for (TopicPort& from : ports) {
    if (from.use().access != Access::write) {
      const std::uint64_t before = samples_[i].sequence;
      from.read(value(i), samples_[i]);
      if (samples_[i].sequence != before) {
        port(i).sequence = samples_[i].sequence;
        port(i).stamp_ns = samples_[i].stamp_ns;
      }
    }
    ++i;
  }
}

void Child::copy_out(Ports& ports) const noexcept {
  std::size_t i = 0;
  for (TopicPort& to : ports) {
    if (to.use().access == Access::write && port(i).staged != 0) {
      to.stage(value(i));
    }
    ++i;
  }
}

void Child::begin(ChildCall call) noexcept {
  request().call = calling_ = call;
  ring(exchange().call, ++called_);
}

bool Child::wait(std::int64_t limit_ns) noexcept {
  Doorbell& bell = exchange().answer;
  const std::uint32_t before = called_ - 1;
  const std::int64_t end_ns = process::monotonic_ns() + limit_ns;
  while (!spin_.sees_change(bell, before)) {
    const std::int64_t remaining_ns = end_ns - process::monotonic_ns();
    if (remaining_ns > 0) {
      sleep_on(bell, before, std::min(remaining_ns, kLook_ns));
    }
    if (!has_answered() && process_.has_ended()) {
      return true;
    }
    if (remaining_ns <= 0) {
      return has_answered();
    }
  }
  return true;
}

Child::Result Child::finish(std::int64_t limit_ns, PluginDeclarations& reports) noexcept {
  if (!wait(limit_ns)) {
    format_into(text_, "did not answer within {:g} ms", static_cast<double>(limit_ns) * 1e-6);
    return Result::pending;
  }
  if (!has_answered()) {
    describe_end(calling(), reports);
    return Result::lost;
  }
  if (exchange().answer.number.load() != called_ || !is_whole()) {
    format_into(text_, "wrote over the memory that it shares with the manager");
    return Result::lost;
  }
  take_reports(reports);
  if (exchange().reply.status == GAITWAY_OK) {
    text_[0] = '\0';
    return Result::done;
  }
  format_into(text_, "{}", text_up_to_nul(exchange().reply.text));
  return Result::failed;
}

bool Child::is_whole() const noexcept {
  bool whole = exchange().guard == kExchangeGuard && exchange().end_guard == kExchangeGuard;
  for (std::size_t i = 0; i < layout_->port_offset.size(); ++i) {
    whole = whole && port(i).guard == kExchangeGuard;
  }
  return whole;
}

void Child::take_reports(PluginDeclarations& to) const noexcept {
  ChildReply& reply = exchange().reply;
  const std::size_t count = std::min<std::size_t>(std::exchange(reply.reports, 0U), kExchangeReports);
  for (std::size_t i = 0; i < count; ++i) {
    to.report(reply.report[i].severity, text_up_to_nul(reply.report[i].text).substr(0, kLongestReport));
  }
}

std::string_view Child::exhausted() const noexcept {
  constexpr std::array<std::string_view, 3> kNames{"", "memory", "file descriptors"};
  const std::uint32_t what = exchange().reply.exhausted;
  return what < kNames.size() ? kNames[what] : std::string_view();
}

bool Child::take_state(PluginState& state) const noexcept {
  const std::uint32_t size = exchange().reply.state_size, version = exchange().reply.state_version;
  const bool fits = size <= PluginState::kCapacity;
  state.version = fits ? version : 0;
  state.size = state.version != 0 ? size : 0;
  std::copy_n(exchange().state, state.size, state.bytes.begin());
  return fits;
}

void Child::put_state(const PluginState& state) noexcept {
  std::copy_n(state.bytes.begin(), state.size, exchange().state);
  request().state_size = state.size;
  request().state_version = state.version;
}

bool Child::put_parameter(const char* name, const gaitway_value& value) noexcept {
  const std::string_view text = value.text == nullptr ? "" : value.text;
  ChildRequest& to = request();
  if (strlen(name) >= sizeof to.parameter_name || text.size() >= sizeof to.parameter_text) {
    return false;
  }
  to.parameter = value;
  to.parameter.text = nullptr;
  std::copy_n(name, strlen(name) + 1, to.parameter_name);
  *std::copy(text.begin(), text.end(), to.parameter_text) = '\0';
  return true;
}

std::string_view Child::calling() const noexcept {
  constexpr std::array<std::string_view, 7> kNames{
      "its step", "activation", "deactivation", "save_state", "restore_state", "set_parameter", "its end"};
  return kNames[static_cast<std::size_t>(calling_)];
}

void Child::describe_end(std::string_view during, PluginDeclarations& reports) noexcept {
  take_reports(reports);
  const LastWords words = exchange().last_words;
  std::array<char, 160> where{};
  if (words.signal != 0 && words.signal < NSIG && words.in_library == 1) {
    format_into(where, " (at {:#x}, from {}+{:#x})", words.address, std::string_view(library_).substr(0, 80),
                words.offset);
  } else if (words.signal != 0 && words.signal < NSIG) {
    format_into(where, " (at {:#x}, outside of its own library)", words.address);
  }
  format_into(text_, "its process {} in {}{}", process_.end(), during, std::string_view(where.data()));
}

}  // namespace gaitway::core
