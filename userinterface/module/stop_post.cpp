// A stop goes to the link first; its answer and the news of it come after.
#include "gaitway/api/stop_post.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include "gaitway/process/real_time.hpp"

namespace gaitway::api {
namespace {

constexpr int kLook_ms = 1000;              // for refusals that are due
constexpr int kDatagramsAtOnce = 64;        // before it looks for the wish to end
constexpr std::size_t kRefusalsKept = 100;  // while the server's thread takes none

}  // namespace

std::string text_of(const PostedStops& stops) {
  static constexpr std::array kNames{"stop", "emergency stop that holds", "emergency stop that lets go"};
  std::string text = std::string(kNames[static_cast<std::size_t>(stops.kind)]) + " by datagram from " +
                     stopgram::text_of(stops.from);
  if (stops.count > 1) {
    text += ", the newest of " + std::to_string(stops.count);
  }
  return text;
}

StopPost::StopPost(ModuleLink& link, stopgram::StopSocket socket, stopgram::StopKey key)
    : link_(link),
      socket_(std::move(socket)),
      desk_(std::move(key), stopgram::random_identity()),
      wake_(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {
  if (!wake_) {
    throw std::system_error(errno, std::generic_category(), "no descriptor to wake the thread of stops");
  }
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

StopPost::~StopPost() {
  thread_.request_stop();
  eventfd_write(wake_.get(), 1);
  thread_.join();
}

std::optional<PostedStops> StopPost::take_stops() {
  const std::scoped_lock lock(mutex_);
  if (stops_.count == 0) {
    return std::nullopt;
  }
  return std::exchange(stops_, {});
}

std::vector<std::string> StopPost::take_refusals() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(refusals_, {});
}

void StopPost::run(const std::stop_token& stop) {
  std::array<pollfd, 2> wakes{pollfd{socket_.wake_fd(), POLLIN, 0}, pollfd{wake_.get(), POLLIN, 0}};
  while (!stop.stop_requested()) {
    poll(wakes.data(), wakes.size(), kLook_ms);
    take_datagrams();
    note_refusals();
  }
}

void StopPost::take_datagrams() {
  desk_.obeyed(link_.stops_obeyed());
  for (int i = 0; i < kDatagramsAtOnce; ++i) {
    const auto received = socket_.receive();
    if (!received) {
      return;
    }
    const link::Bytes answer = desk_.on_datagram(received->datagram, received->from, process::monotonic_ns());
    while (const auto stop = desk_.next_stop(link_.stops_asked())) {
      link_.stop_unseen(stop->kind);
      const std::scoped_lock lock(mutex_);
      stops_ = {.count = stops_.count + 1, .kind = stop->kind, .from = received->from};
    }
    if (!answer.empty()) {
      socket_.send(answer, received->from);
    }
  }
}

void StopPost::note_refusals() {
  while (auto line = desk_.take_refusal(process::monotonic_ns())) {
    const std::scoped_lock lock(mutex_);
    if (refusals_.size() < kRefusalsKept) {
      refusals_.push_back(std::move(*line));
    }
  }
}

}  // namespace gaitway::api
