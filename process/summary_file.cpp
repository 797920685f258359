// A thread that looks for something newer every second, and writes it in the place of the one before.
#include "gaitway/process/summary_file.hpp"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>

#include "background_thread.hpp"
#include "gaitway/process/spare_room.hpp"
#include "gaitway/process/text_file.hpp"

namespace gaitway::process {
namespace {

constexpr std::chrono::milliseconds kFirst{100}, kPeriod{1000}, kLastWait{2000};
constexpr std::uint64_t kSpare_bytes = std::uint64_t{64} << 10;

}  // namespace

class SummaryThread::Desk {
 public:
  Desk(std::filesystem::path file, std::function<bool(std::string&)> newer,
       std::function<void(const std::string&)> tell)
      : file_(std::move(file)),
        room_(file_.parent_path(), kSpare_bytes),
        newer_(std::move(newer)),
        tell_(std::move(tell)) {}

  void run() {
    std::chrono::milliseconds wait = kFirst;
    for (bool last = false; !last; wait = kPeriod) {
      std::string text;
      {
        std::unique_lock lock(mutex_);
        due_.wait_for(lock, wait, [this] { return last_.has_value(); });
        last = last_.has_value();
        if (last) text = std::move(*last_);
      }
      if (last ? !text.empty() : newer_(text)) write(text, last);
    }
    const std::scoped_lock lock(mutex_);
    is_over_ = true;
    over_.notify_all();
  }
  std::string end(std::string text) {
    std::unique_lock lock(mutex_);
    if (!last_) last_ = std::move(text);
    due_.notify_all();
    if (!over_.wait_for(lock, kLastWait, [this] { return is_over_; })) {
      return file_.string() + ": is not written yet: the disk is too slow";
    }
    return error_;
  }

 private:
  void write(const std::string& text, bool last) {
    std::string error;
    room_.give_back();
    try {
      replace_text_file(file_, text);
    } catch (const std::exception& problem) {
      error = problem.what();
    }
    if (!last) room_.take();
    std::unique_lock lock(mutex_);
    const bool is_news = error.empty() != error_.empty();
    error_ = error;
    lock.unlock();  // a terminal may take its time
    if (tell_ && !last && is_news) {
      tell_(error.empty() ? file_.string() + ": is written again" : error);
    }
  }

  const std::filesystem::path file_;
  SpareRoom room_;
  const std::function<bool(std::string&)> newer_;
  const std::function<void(const std::string&)> tell_;
  std::mutex mutex_;  // of all below
  std::condition_variable due_, over_;
  std::optional<std::string> last_;
  std::string error_;
  bool is_over_ = false;
};

SummaryThread::SummaryThread(std::filesystem::path file, std::function<bool(std::string&)> newer,
                             std::function<void(const std::string&)> tell)
    : desk_(std::make_shared<Desk>(std::move(file), std::move(newer), std::move(tell))) {
  start_background_thread([desk = desk_] { desk->run(); });
}

SummaryThread::~SummaryThread() {
  static_cast<void>(desk_->end({}));  // nothing more, unless there was a last one
}

std::string SummaryThread::end(std::string text) {
  return desk_->end(std::move(text));
}

}  // namespace gaitway::process
