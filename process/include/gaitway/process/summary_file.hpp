// The summary of a process that runs for long: on the disk anew every second, so that a kill leaves the last
// one, and written by a thread of its own, so that nobody waits for a disk.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

namespace gaitway::process {

// The newest of what one thread offers and another one takes, in three places: the offerer's, the taker's,
// and the one that they exchange. Neither waits; what was not taken is offered over.
template <class Value>
class NewestValue {
  static_assert(std::is_trivially_copyable_v<Value>, "is copied as it is, without allocation");

 public:
  void offer(const Value& value) noexcept {
    places_[offerers_] = value;
    // Release: the taker sees the whole value; acquire: the place that comes back has been read.
    offerers_ = exchanged_.exchange(offerers_ | kNew, std::memory_order_acq_rel) & kPlace;
  }
  // Nothing: none has come since.
  [[nodiscard]] const Value* take() noexcept {
    if ((exchanged_.load(std::memory_order_relaxed) & kNew) == 0) return nullptr;
    takers_ = exchanged_.exchange(takers_, std::memory_order_acq_rel) & kPlace;
    return &places_[takers_];
  }

 private:
  static constexpr unsigned kNew = 4, kPlace = 3;
  std::array<Value, 3> places_{};
  unsigned offerers_ = 0, takers_ = 1;
  std::atomic<unsigned> exchanged_{2};
};

// The thread, whatever the summary is made of.
class SummaryThread {
 public:
  // `text`: a newer summary, or nothing new (false); called in the thread. `tell` hears, there, that the
  // file cannot be written, and when it can again; each once.
  SummaryThread(std::filesystem::path file, std::function<bool(std::string& text)> newer,
                std::function<void(const std::string& news)> tell);
  SummaryThread(const SummaryThread&) = delete;
  SummaryThread& operator=(const SummaryThread&) = delete;
  ~SummaryThread();

  // The last one, written by the thread as well: why it could not be, for people; empty: it was. A disk that
  // takes nothing for two seconds is left to itself.
  std::string end(std::string text);

 private:
  class Desk;
  std::shared_ptr<Desk> desk_;
};

// `Snapshot`: what a summary is made of, copied in real time. `text` makes JSON, say, of it, in the thread,
// and is called for nothing else.
template <class Snapshot>
class SummaryFile {
 public:
  SummaryFile(std::filesystem::path file, std::function<std::string(const Snapshot&)> text,
              std::function<void(const std::string& news)> tell)
      : newest_(std::make_shared<NewestValue<Snapshot>>()),
        thread_(
            std::move(file),
            [newest = newest_, text = std::move(text)](std::string& out) {
              const Snapshot* const taken = newest->take();
              if (taken != nullptr) out = text(*taken);
              return taken != nullptr;
            },
            std::move(tell)) {}

  // One thread, in real time: a copy, no system call. As often as it likes.
  void offer(const Snapshot& snapshot) noexcept { newest_->offer(snapshot); }
  // As of SummaryThread.
  std::string end(std::string text) { return thread_.end(std::move(text)); }

 private:
  std::shared_ptr<NewestValue<Snapshot>> newest_;
  SummaryThread thread_;
};

}  // namespace gaitway::process
