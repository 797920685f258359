// The station on a CAN interface: one frame at a time is in the kernel's hands; echoes, error frames and
// errors of the socket move it on.
#include "gaitway/can/socketcan_port.hpp"

#include <linux/can/error.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "can_socket.hpp"
#include "gaitway/can/frame.hpp"

namespace gaitway::can {
namespace {

constexpr int kBatchesACall = 64;  // bounds the time that one call takes, however much comes

Frame frame_of(const canfd_frame& message) noexcept {
  Frame frame;
  frame.extended = (message.can_id & CAN_EFF_FLAG) != 0;
  frame.remote = (message.can_id & CAN_RTR_FLAG) != 0;
  frame.id = message.can_id & (frame.extended ? CAN_EFF_MASK : CAN_SFF_MASK);
  frame.size = std::min<std::uint8_t>(message.len, 8);
  if (!frame.remote) {
    std::copy_n(message.data, frame.size, frame.data.begin());
  }
  return frame;
}

// As the kernel gives it back: the bytes behind the frame's end are not part of it.
Frame without_padding(Frame frame) noexcept {
  std::fill(frame.data.begin() + (frame.remote ? 0 : frame.size), frame.data.end(), std::uint8_t{0});
  return frame;
}

bool is_virtual_kind(std::string_view kind) noexcept {
  return kind == "vcan" || kind == "vxcan";
}

}  // namespace

SocketCanPort::SocketCanPort(const std::string& interface, const SocketCanOptions& options)
    : interface_(interface),
      options_(options),
      socket_(std::make_unique<Socket>(interface, options.filters)) {
  options_.transmit_buffers = std::clamp<std::size_t>(options_.transmit_buffers, 1, FrameHeap::kCapacity);
  if (const auto link = read_link(socket_->index())) {
    bit_time_ns_ = link->bitrate_per_s > 0 ? 1'000'000'000 / std::int64_t{link->bitrate_per_s} : bit_time_ns_;
    virtual_ = is_virtual_kind(link->kind);
    counters_ = link->counters;
    enter(link->state.value_or(BusState::error_active));
  }
}

SocketCanPort::~SocketCanPort() = default;

int SocketCanPort::wake_fd() const noexcept {
  return socket_->fd();
}

std::size_t SocketCanPort::free_buffers() const noexcept {
  return usable() ? options_.transmit_buffers - waiting_.size() - (in_flight_ ? 1U : 0U) : 0;
}

bool SocketCanPort::transmit(const Frame& frame, std::int64_t now_ns) {
  now_ns_ = now_ns;
  if (!is_valid(frame)) {
    ++statistics_.refused_invalid;
    return false;
  }
  if (!usable()) {
    ++statistics_.refused_unusable;
    return false;
  }
  if (free_buffers() == 0) {
    ++statistics_.refused_full;
    return false;
  }
  ++statistics_.accepted;
  waiting_.push(without_padding(frame));
  return true;
}

std::optional<TimedFrame> SocketCanPort::receive() {
  if (received_count_ == 0 && !std::exchange(emptied_, false)) {
    emptied_ = drain();
  }
  if (received_count_ == 0) {
    emptied_ = false;
    return std::nullopt;
  }
  const TimedFrame& frame = received_[received_first_];
  received_first_ = (received_first_ + 1) % received_.size();
  --received_count_;
  return frame;
}

void SocketCanPort::flush(std::int64_t now_ns) {
  now_ns_ = now_ns;
  kernel_full_ = false;
  if (in_flight_ && now_ns_ >= in_flight_until_ns_) {
    drain();  // its echo may be there already
    if (in_flight_ && now_ns_ >= in_flight_until_ns_) {
      in_flight_.reset();
      ++statistics_.lost;
    }
  }
  write_next();
  if (in_flight_ || !usable()) {
    drain();
  }
  supervise();
}

// Reads until nothing is left, and writes the next frame at each echo. Where the echo comes at once, as on a
// virtual interface, everything that waits goes out. True: the socket is empty.
bool SocketCanPort::drain() noexcept {
  for (int batch = 0; batch < kBatchesACall && received_.size() - received_count_ >= Socket::kBatch;
       ++batch) {
    const std::uint64_t echoes = statistics_.sent;
    const int count = socket_->read();
    if (count < 0) {
      take_socket_error(-count);
      if (count == -EAGAIN || count == -EWOULDBLOCK) {
        return true;
      }
      continue;
    }
    for (int message = 0; message < count; ++message) {
      take(message);
    }
    statistics_.dropped_by_kernel = socket_->dropped();
    if (count < Socket::kBatch && (statistics_.sent == echoes || !in_flight_)) {
      return true;  // nothing was written meanwhile that could have come back
    }
  }
  return false;
}

void SocketCanPort::take(int message) noexcept {
  const canfd_frame& data = socket_->frame(message);
  if (socket_->is_fd(message)) {
    ++statistics_.fd_ignored;
    return;
  }
  if ((data.can_id & CAN_ERR_FLAG) != 0) {
    std::array<std::uint8_t, 8> bytes{};
    std::copy_n(data.data, bytes.size(), bytes.begin());
    take_error(data.can_id & CAN_ERR_MASK, bytes, socket_->arrival(message).end_ns);
    return;
  }
  const TimedFrame frame = timed(frame_of(data), message);
  if (socket_->is_echo(message)) {
    take_echo(frame);
    return;
  }
  ++statistics_.received;
  received_[(received_first_ + received_count_++) % received_.size()] = frame;
  if (state_ == BusState::bus_off && !socket_->is_local(message)) {
    enter(BusState::error_active);  // it came over the wire: the news of the restart was lost
  }
}

TimedFrame SocketCanPort::timed(const Frame& frame, int message) noexcept {
  const Socket::Arrival arrival = socket_->arrival(message);
  statistics_.without_stamp += arrival.stamped ? 0U : 1U;
  statistics_.hardware_stamps += arrival.hardware ? 1U : 0U;
  last_end_ns_ = std::max(last_end_ns_, arrival.end_ns);  // the kernel keeps the order of the bus
  return {frame, last_end_ns_ - frame_bits(frame) * bit_time_ns_, last_end_ns_};
}

void SocketCanPort::take_echo(const TimedFrame& frame) noexcept {
  notices_.push({BusNotice::Kind::sent, frame});
  if (options_.sent_log != nullptr) {
    options_.sent_log->write(frame.end_ns, frame.frame);
  }
  if (!in_flight_ || *in_flight_ != frame.frame) {
    ++statistics_.late_echoes;
    return;
  }
  in_flight_.reset();
  ++statistics_.sent;
  write_next();
}

void SocketCanPort::take_error(std::uint32_t error_class, const std::array<std::uint8_t, 8>& data,
                               std::int64_t at_ns) noexcept {
  const ErrorReport report = read_error_frame(error_class, data);
  ++statistics_.error_frames;
  statistics_.no_acknowledge += report.no_acknowledge ? 1U : 0U;
  statistics_.arbitration_lost += report.lost_arbitration ? 1U : 0U;
  statistics_.protocol_violations += report.protocol_violation ? 1U : 0U;
  statistics_.transceiver_faults += report.transceiver_fault ? 1U : 0U;
  statistics_.transmit_timeouts += report.transmit_timeout ? 1U : 0U;
  statistics_.controller_overflows += report.receive_overflow || report.transmit_overflow ? 1U : 0U;
  if (report.protocol_violation || report.no_acknowledge) {
    notices_.push({BusNotice::Kind::error, {{}, at_ns, at_ns}});
  }
  if (report.restarted) {
    counters_ = {};
  }
  counters_ = report.counters.value_or(counters_);
  if (report.state) {
    enter(*report.state);
  }
}

void SocketCanPort::take_socket_error(int error) noexcept {
  switch (error) {
    case EAGAIN:
    case EINTR:
      return;
    case ENODEV:
    case ENXIO:
      socket_->forget_interface();
      enter(BusState::down);
      return;
    case ENETDOWN:  // told once
      enter(BusState::down);
      return;
    default:
      ++statistics_.receive_failed;
  }
}

void SocketCanPort::write_next() noexcept {
  while (usable() && !in_flight_ && !kernel_full_ && !waiting_.empty()) {
    const Frame& frame = waiting_.top();
    if (const int error = socket_->write(frame); error != 0) {
      write_failed(error);
      continue;
    }
    if (socket_->passes(frame)) {
      in_flight_ = frame;
      in_flight_until_ns_ = now_ns_ + options_.echo_deadline_ns;
    } else {
      ++statistics_.unconfirmed;
      if (options_.sent_log != nullptr) {
        options_.sent_log->write(now_ns_, frame);
      }
    }
    waiting_.pop();
  }
}

void SocketCanPort::write_failed(int error) noexcept {
  switch (error) {
    case ENOBUFS:  // the interface's queue is full
    case EAGAIN:   // the socket's buffer is full
      kernel_full_ = true;
      ++statistics_.kernel_buffer_full;
      return;
    case EINTR:
      return;
    case ENETDOWN:
    case ENODEV:
    case ENXIO:
      take_socket_error(error);
      return;
    default:
      waiting_.pop();
      ++statistics_.failed;
  }
}

void SocketCanPort::enter(BusState state) noexcept {
  const BusState before = std::exchange(state_, state);
  if (before == state) {
    return;
  }
  next_look_ns_ = now_ns_ + options_.interface_poll_ns;
  switch (state) {
    case BusState::error_active:
      statistics_.recovered += before == BusState::bus_off ? 1U : 0U;
      break;
    case BusState::error_passive:
      ++statistics_.error_passive;
      break;
    case BusState::bus_off:
      ++statistics_.bus_off;
      next_look_ns_ = now_ns_ + options_.restart_delay_ns;
      drop_waiting();
      break;
    case BusState::down:
      ++statistics_.interface_down;
      counters_ = {};
      drop_waiting();
      break;
  }
}

void SocketCanPort::drop_waiting() noexcept {
  statistics_.flushed += waiting_.clear();
  statistics_.lost += in_flight_ ? 1U : 0U;
  in_flight_.reset();
}

void SocketCanPort::supervise() noexcept {
  if (usable() || now_ns_ < next_look_ns_) {
    return;
  }
  if (state_ == BusState::down) {
    next_look_ns_ = now_ns_ + options_.interface_poll_ns;
    look_for_interface();
  } else if (options_.restart_delay_ns > 0) {
    next_look_ns_ = now_ns_ + options_.restart_delay_ns;
    ask_for_restart();
  }
}

void SocketCanPort::look_for_interface() noexcept {
  const int index = socket_->find_interface();
  if (index == 0 || !socket_->interface_up()) {
    return;
  }
  if (index != socket_->index()) {
    const auto link = read_link(index);
    const bool is_virtual = link && is_virtual_kind(link->kind);
    if (virtual_ && !is_virtual) {
      return;  // others have been told that there is no hardware on it: that wants a new program
    }
    if (!socket_->bind_to(index)) {
      return;
    }
    virtual_ = is_virtual;
    ++statistics_.rebound;
  }
  ++statistics_.interface_up;
  enter(BusState::error_active);
}

void SocketCanPort::ask_for_restart() noexcept {
  const int error = restart_link(socket_->index());
  if (error == 0) {
    ++statistics_.restarts_requested;
    restart_error_ = 0;
  } else if (error != EINVAL && error != EBUSY) {  // those say that the kernel sees to it, or has done
    ++statistics_.restarts_refused;
    restart_error_ = error;
  }
}

std::string SocketCanPort::restart_problem() const {
  if (restart_error_ == 0) {
    return {};
  }
  std::string remedy = "; by hand: ip link set " + interface_ + " down && ip link set " + interface_ + " up";
  if (restart_error_ == EPERM) {
    remedy = "; this program needs CAP_NET_ADMIN for it, or let the kernel do it: ip link set " + interface_ +
             " type can restart-ms 100";
  }
  return "CAN interface '" + interface_ + "': it is bus-off and cannot be restarted (" +
         std::strerror(restart_error_) + ")" + remedy;
}

}  // namespace gaitway::can
