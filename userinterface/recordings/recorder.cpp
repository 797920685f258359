// Jobs for the folder, in their order, from the recorder to its thread.
#include "gaitway/api/recorder.hpp"

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <stdexcept>
#include <vector>

namespace gaitway::api {
namespace {

constexpr std::int64_t kFlushPeriod_ns = 1'000'000'000;
constexpr std::chrono::milliseconds kLastWait{500};   // half of what the plug-in's process has to end
constexpr std::size_t kMostOrders = 64;               // that wait
constexpr std::size_t kHandedOver_bytes = 256 << 10;  // the thread is woken for so many
constexpr std::size_t kJob_bytes = 128;               // of a message's job, with what allocation adds

}  // namespace

// Between the two threads. The lock is held for moments, never while the folder works.
class Recorder::Desk {
 public:
  using Order = std::function<void(RecordingFolder& folder, OrderResult& result)>;

  Desk(std::filesystem::path folder, RecorderOptions options)
      : folder_(std::move(folder), options.limits, std::move(options.disk)),
        most_bytes_(options.waiting_bytes) {}

  // --- The recorder's thread.

  [[nodiscard]] bool recording() const noexcept { return recording_; }
  void order(std::uint32_t number, Order work) {
    const std::scoped_lock lock(mutex_);
    put_order(number, std::move(work));
  }
  // A start, and what is written first.
  void start(std::uint32_t number, std::string name) {
    const std::scoped_lock lock(mutex_);
    if (bytes() > most_bytes_ / 2) {
      throw std::runtime_error(
          fmt::format("the disk is too slow: {} bytes of the recording before wait for it", bytes()));
    }
    put_order(number, [this, name](RecordingFolder& folder, OrderResult& result) {
      const StartsOnce once(*this);
      result.text = folder.start(name);
    });
    ++starts_;
    if (!recording_.exchange(true)) name_ = std::move(name);
  }
  void stop(std::uint32_t number) {
    const std::scoped_lock lock(mutex_);
    put_order(number, [](RecordingFolder& folder, OrderResult& result) { result.text = folder.stop(); });
    recording_ = false;
  }
  void write(Topic topic, std::string data, std::int64_t robot_ns) {
    const std::scoped_lock lock(mutex_);
    const std::size_t job_bytes = data.size() + kJob_bytes;
    if (bytes() + job_bytes > most_bytes_) {
      return end_for_slow_disk();
    }
    put([topic, data = std::move(data), robot_ns](RecordingFolder& folder) {
      folder.write(topic, data, robot_ns);
    });
    waiting_bytes_ += job_bytes;
    if (waiting_bytes_ >= kHandedOver_bytes) hand_over();
  }
  void flush() {
    const std::scoped_lock lock(mutex_);
    if (std::exchange(flush_waits_, true)) return;
    put([this](RecordingFolder& folder) {
      folder.flush();
      const std::scoped_lock done(mutex_);
      flush_waits_ = false;
    });
    hand_over();
  }
  [[nodiscard]] std::optional<OrderResult> take_result() {
    const std::scoped_lock lock(mutex_);
    if (results_.empty()) return std::nullopt;
    OrderResult result = std::move(results_.front());
    results_.pop_front();
    return result;
  }
  [[nodiscard]] std::optional<std::string> take_report() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(report_, std::nullopt);
  }
  // Whether all is done, and the folder let go of.
  [[nodiscard]] bool close() {
    std::unique_lock lock(mutex_);
    closing_ = true;
    hand_over();
    return over_.wait_for(lock, kLastWait, [this] { return is_over_; });
  }

  // --- The thread that works off.

  void run() {
    std::vector<Job> jobs;
    for (bool last = false; !last;) {
      last = take(jobs);
      for (const Job& job : jobs) job(folder_);
      jobs.clear();
      note(folder_.take_report());
    }
    folder_.end("the recorder has ended");
    const std::scoped_lock lock(mutex_);
    is_over_ = true;
    over_.notify_all();
  }

 private:
  using Job = std::function<void(RecordingFolder& folder)>;

  // A start that has been done, or refused, is waited for no more.
  class StartsOnce {
   public:
    explicit StartsOnce(Desk& desk) : desk_(desk) {}
    StartsOnce(const StartsOnce&) = delete;
    StartsOnce& operator=(const StartsOnce&) = delete;
    ~StartsOnce() {
      const std::scoped_lock lock(desk_.mutex_);
      --desk_.starts_;
    }

   private:
    Desk& desk_;
  };

  // With the lock:
  [[nodiscard]] std::size_t bytes() const { return waiting_bytes_ + taken_bytes_; }
  void put(Job job) { jobs_.push_back(std::move(job)); }
  void hand_over() {
    handed_over_ = true;
    due_.notify_one();
  }
  void put_order(std::uint32_t number, Order work) {
    if (orders_ >= kMostOrders) {
      throw std::runtime_error("the disk is too slow: too many orders wait for it; try again");
    }
    ++orders_;
    put([this, number, work = std::move(work)](RecordingFolder& folder) {
      OrderResult result{number, true, {}};
      try {
        work(folder, result);
      } catch (const std::exception& error) {
        result.done = false;
        result.text = error.what();
      }
      const std::scoped_lock lock(mutex_);
      results_.push_back(std::move(result));
      --orders_;
    });
    hand_over();
  }
  // What waits is still written, whenever the disk takes it.
  void end_for_slow_disk() {
    const std::string reason =
        fmt::format("its disk is too slow: more than {} bytes wait for it", most_bytes_);
    put([reason](RecordingFolder& folder) { folder.end(reason); });
    recording_ = false;
    report_ = fmt::format("the recording '{}' takes nothing more: {}", name_, reason);
    hand_over();
  }

  // Without it: true: there will be no more.
  bool take(std::vector<Job>& jobs) {
    std::unique_lock lock(mutex_);
    taken_bytes_ = 0;
    due_.wait(lock, [this] { return handed_over_; });
    handed_over_ = false;
    jobs.swap(jobs_);
    taken_bytes_ = std::exchange(waiting_bytes_, 0);
    return closing_;
  }
  void note(std::optional<std::string> report) {
    const std::scoped_lock lock(mutex_);
    if (report) report_ = std::move(report);
    recording_ = recording_ && (folder_.recording() || starts_ != 0);
  }

  RecordingFolder folder_;  // the thread's alone
  const std::size_t most_bytes_;
  std::atomic<bool> recording_{false};  // whether messages are wanted; written with the lock
  std::mutex mutex_;                    // of all below
  std::condition_variable due_, over_;
  std::vector<Job> jobs_;
  std::string name_;                                 // of the newest recording
  std::size_t waiting_bytes_ = 0, taken_bytes_ = 0;  // of messages; taken: being written
  std::size_t orders_ = 0, starts_ = 0;              // that are not done yet
  bool flush_waits_ = false, handed_over_ = false, closing_ = false, is_over_ = false;
  std::deque<OrderResult> results_;
  std::optional<std::string> report_;
};

Recorder::Recorder(std::filesystem::path folder, RecorderOptions options)
    : desk_(std::make_shared<Desk>(std::move(folder), std::move(options))),
      thread_([desk = desk_] { desk->run(); }) {}

Recorder::~Recorder() {
  if (desk_->close()) {
    thread_.join();
  } else {
    thread_.detach();
  }
}

void Recorder::start(std::uint32_t number, std::string name, std::int64_t robot_ns) {
  const bool first = !recording();
  desk_->start(number, std::move(name));
  for (const TopicRow& topic : kTopics) {
    const std::string& last = latched_[static_cast<std::size_t>(topic.topic)];
    if (first && !last.empty()) write(topic.topic, last, robot_ns);
  }
}

void Recorder::stop(std::uint32_t number) {
  desk_->stop(number);
}

void Recorder::list(std::uint32_t number, std::size_t most) {
  desk_->order(number, [most](RecordingFolder& folder, OrderResult& result) {
    result.recordings = folder.list(most);
  });
}

std::optional<OrderResult> Recorder::take_result() {
  return desk_->take_result();
}

void Recorder::step(std::int64_t wall_ns) {
  if (!recording()) {
    flushed_wall_ns_.reset();
    return;
  }
  if (!flushed_wall_ns_) flushed_wall_ns_ = wall_ns;
  if (wall_ns - *flushed_wall_ns_ < kFlushPeriod_ns) return;
  flushed_wall_ns_ = wall_ns;
  desk_->flush();
}

std::optional<std::string> Recorder::take_report() {
  return desk_->take_report();
}

bool Recorder::recording() const noexcept {
  return desk_->recording();
}

void Recorder::write(Topic topic, std::string data, std::int64_t robot_ns) {
  desk_->write(topic, std::move(data), robot_ns);
}

}  // namespace gaitway::api
