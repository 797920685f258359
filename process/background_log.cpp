// One ring of bytes between two threads. The thread sleeps on an event while the ring is empty.
#include "gaitway/process/background_log.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <utility>
#include <vector>

#include "background_thread.hpp"
#include "gaitway/process/file_descriptor.hpp"
#include "gaitway/process/real_time.hpp"

namespace gaitway::process {
namespace {

constexpr std::int64_t kLastWait_ns = 500'000'000;
constexpr std::int64_t kBetweenSyncs_ns = 1'000'000'000;
// Without a loss for so long, losing is over.
constexpr std::int64_t kOver_ns = 1'000'000'000;

class Event {
 public:
  Event() : fd_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
    if (!fd_) throw std::runtime_error(std::string("no eventfd: ") + std::strerror(errno));
  }
  void give() noexcept {
    const std::uint64_t one = 1;
    static_cast<void>(!::write(fd_.get(), &one, sizeof one));
  }
  // Whether it was given within that time; negative: it waits without end.
  bool take(std::int64_t within_ns) noexcept {
    pollfd readable{fd_.get(), POLLIN, 0};
    ::poll(&readable, 1, within_ns < 0 ? -1 : static_cast<int>((within_ns + 999'999) / 1'000'000));
    std::uint64_t count = 0;
    return ::read(fd_.get(), &count, sizeof count) == sizeof count;
  }

 private:
  FileDescriptor fd_;
};

}  // namespace

std::function<void(const std::string&)> tell_on_stderr(std::string program) {
  return [program = std::move(program)](const std::string& news) {
    std::fprintf(stderr, "%s: %s\n", program.c_str(), news.c_str());
  };
}

// The ring: bytes [taken_, added_), modulo its size. The adder alone writes added_, the thread alone taken_;
// each is stored (release) after the bytes were copied, and loaded (acquire) by the other before it touches
// them: so the thread reads whole lines, and the adder writes over nothing that is still to be read.
//
// The wake-up: the thread says that it sleeps, and then looks at added_ once more; the adder stores added_,
// and then asks whether the thread sleeps. Both in one order for all (seq_cst), so at least one of them sees
// the other: no line waits while the thread sleeps.
class BackgroundLog::Desk {
 public:
  Desk(LogFile file, BackgroundLogOptions options)
      : file_(std::move(file)),
        options_(std::move(options)),
        ring_(std::bit_ceil(std::max<std::size_t>(options_.waiting_bytes, 4096))) {}

  bool add(std::string_view line) noexcept {
    const std::uint64_t added = added_.load(std::memory_order_relaxed);
    if (line.size() > ring_.size() - (added - taken_.load(std::memory_order_acquire))) {
      refused_.fetch_add(1, std::memory_order_relaxed);
      return false;
    }
    const std::size_t at = added & (ring_.size() - 1), first = std::min(line.size(), ring_.size() - at);
    std::copy_n(line.data(), first, ring_.data() + at);
    std::copy_n(line.data() + first, line.size() - first, ring_.data());
    handed_over_.fetch_add(1, std::memory_order_relaxed);
    added_.store(added + line.size(), std::memory_order_seq_cst);
    if (sleeps_.load(std::memory_order_seq_cst) && sleeps_.exchange(false, std::memory_order_seq_cst)) {
      due_.give();
    }
    return true;
  }
  LogCount close() noexcept {
    closing_.store(true, std::memory_order_seq_cst);
    due_.give();
    over_.take(kLastWait_ns);
    LogCount result = count();
    result.lost = refused_.load() + handed_over_.load() - result.lines;
    return result;
  }
  [[nodiscard]] LogCount count() const noexcept {
    return {written_.load(std::memory_order_relaxed),
            refused_.load(std::memory_order_relaxed) + lost_.load(std::memory_order_relaxed)};
  }

  void run() {
    while (work() || !closing_.load(std::memory_order_seq_cst)) {
      tell_losses(monotonic_ns());
      sync(monotonic_ns());
      sleeps_.store(true, std::memory_order_seq_cst);
      const bool waits = added_.load(std::memory_order_seq_cst) != taken_.load(std::memory_order_relaxed);
      if (!waits && !closing_.load(std::memory_order_seq_cst)) {
        due_.take(dirty_ ? kBetweenSyncs_ns : losing_ ? kOver_ns : -1);
      }
      sleeps_.store(false, std::memory_order_seq_cst);
    }
    tell_losses(monotonic_ns() + kOver_ns);
    file_.close();  // before others hear that it is over: they may open it at once
    over_.give();
  }

 private:
  // Writes what waits; false: nothing did.
  bool work() {
    const std::uint64_t taken = taken_.load(std::memory_order_relaxed);
    const std::uint64_t added = added_.load(std::memory_order_acquire);
    if (added == taken) return false;
    const auto size = static_cast<std::size_t>(added - taken);
    const std::size_t at = taken & (ring_.size() - 1), first = std::min(size, ring_.size() - at);
    block_.assign(ring_.data() + at, first);
    block_.append(ring_.data(), size - first);
    taken_.store(added, std::memory_order_release);
    write(block_);
    return true;
  }
  void write(std::string_view lines) {
    file_.append(lines);
    written_.store(file_.lines() - gap_lines_, std::memory_order_relaxed);
    lost_.store(file_.lost() - lost_gap_lines_, std::memory_order_relaxed);
    dirty_ = true;
  }
  void tell_losses(std::int64_t now_ns) {
    const std::uint64_t lost = count().lost;
    if (lost != seen_lost_) {
      seen_lost_ = lost;
      lost_at_ns_ = now_ns;
      const std::uint64_t on_disk = lost_.load(std::memory_order_relaxed);
      reason_ = on_disk != std::exchange(seen_on_disk_, on_disk) ? file_.error() : "the disk is too slow";
      if (!std::exchange(losing_, true)) {
        tell(file_.name() + ": lines are being lost: " + reason_);
      }
    } else if (losing_ && now_ns - lost_at_ns_ >= kOver_ns) {
      tell_end(lost);
    }
  }
  void tell_end(std::uint64_t lost) {
    const std::uint64_t missing = lost - told_lost_;
    if (options_.gap_line) {
      const std::uint64_t lines = file_.lines(), missed = file_.lost();
      file_.append(options_.gap_line(missing, reason_));
      gap_lines_ += file_.lines() - lines;
      lost_gap_lines_ += file_.lost() - missed;
      if (file_.lost() != missed) {  // it is not over
        lost_at_ns_ += kOver_ns;
        return;
      }
    }
    losing_ = false;
    told_lost_ = lost;
    tell(file_.name() + ": is written again; " + std::to_string(missing) + " lines were lost");
  }
  void tell(const std::string& news) const {
    if (options_.tell) options_.tell(news);
  }
  void sync(std::int64_t now_ns) {
    if (!dirty_ || now_ns - synced_ns_ < kBetweenSyncs_ns) return;
    file_.sync();
    dirty_ = false;
    synced_ns_ = now_ns;
  }

  // The thread's alone.
  LogFile file_;
  const BackgroundLogOptions options_;
  std::string block_, reason_;
  bool losing_ = false, dirty_ = false;
  std::uint64_t seen_lost_ = 0, seen_on_disk_ = 0, told_lost_ = 0, gap_lines_ = 0, lost_gap_lines_ = 0;
  std::int64_t lost_at_ns_ = 0, synced_ns_ = monotonic_ns();

  std::vector<char> ring_;
  std::atomic<std::uint64_t> added_{0}, taken_{0};                                 // bytes
  std::atomic<std::uint64_t> handed_over_{0}, refused_{0}, written_{0}, lost_{0};  // lines
  std::atomic<bool> sleeps_{false}, closing_{false};
  Event due_, over_;
};

BackgroundLog::BackgroundLog(LogFile file, BackgroundLogOptions options)
    : desk_(std::make_shared<Desk>(std::move(file), std::move(options))) {
  start_background_thread([desk = desk_] { desk->run(); });
}

BackgroundLog::~BackgroundLog() {
  close();
}

bool BackgroundLog::add(std::string_view line) noexcept {
  return desk_->add(line);
}

LogCount BackgroundLog::close() noexcept {
  if (!closed_) closed_ = desk_->close();
  return *closed_;
}

LogCount BackgroundLog::count() const noexcept {
  return desk_->count();
}

}  // namespace gaitway::process
