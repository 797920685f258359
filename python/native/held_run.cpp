// Who may use a run, and threads that take the next one from a list.
#include "held_run.hpp"

#include <unistd.h>

#include <system_error>
#include <utility>

namespace gaitway::python {

OwnProcess::OwnProcess() : id_(getpid()) {}

bool OwnProcess::is_here() const noexcept {
  return getpid() == id_;
}

void OwnProcess::require_here(const char* what) const {
  if (is_here()) return;
  throw ForkError(std::string(what) +
                  " belongs to the process that this one was forked from: its threads and shared memory are "
                  "not copied. Make a new one here, or start processes with the method 'spawn'");
}

HeldRun::HeldRun(std::shared_ptr<const RobotSetup> setup, std::uint64_t seed)
    : run_(std::make_unique<RobotRun>(setup, seed)), setup_(std::move(setup)) {}

HeldRun::~HeldRun() {
  if (!process_.is_here()) static_cast<void>(run_.release());
}

RobotRun& HeldRun::get() {
  process_.require_here("this robot");
  if (!run_) throw ClosedError("this robot is closed. Make a new one");
  if (busy_) throw BusyError("this robot runs in another thread. A robot is for one thread at a time");
  if (!run_->is_whole()) throw ClosedError("this robot could not be begun anew. Make a new one");
  return *run_;
}

void HeldRun::close() {
  if (!process_.is_here()) {
    static_cast<void>(run_.release());
    return;
  }
  if (busy_) throw BusyError("this robot runs in another thread, and cannot be closed meanwhile");
  run_.reset();
}

RobotRun& HeldRun::begin_use() {
  RobotRun& run = get();
  busy_ = true;
  return run;
}

Use::Use(std::span<HeldRun* const> runs) {
  try {
    for (HeldRun* const run : runs) {
      if (run == nullptr) throw std::invalid_argument("None where a robot is wanted");
      runs_.push_back(&run->begin_use());
      held_.push_back(run);
    }
  } catch (...) {
    for (HeldRun* const run : held_) run->end_use();
    throw;
  }
}

Use::~Use() {
  for (HeldRun* const run : held_) run->end_use();
}

struct RunPool::Shared {
  std::mutex lock;
  std::condition_variable begins, ended;
  const std::function<void(std::size_t)>* work = nullptr;
  std::size_t next = 0, count = 0, at_work = 0;
  std::uint64_t round = 0;
  std::size_t first_failure = 0;
  std::exception_ptr failure;
  bool ends = false;

  // Holds the lock, but while it works.
  void take_part(std::unique_lock<std::mutex>& held) {
    while (next < count) {
      const std::size_t mine = next++;
      ++at_work;
      held.unlock();
      std::exception_ptr thrown;
      try {
        (*work)(mine);
      } catch (...) {
        thrown = std::current_exception();
      }
      held.lock();
      if (thrown && (!failure || mine < first_failure)) {
        failure = thrown;
        first_failure = mine;
      }
      --at_work;
    }
    if (at_work == 0) ended.notify_all();
  }
};

RunPool::RunPool(int threads) : threads_(threads), shared_(std::make_unique<Shared>()) {
  constexpr int kMostThreads = 1024;
  if (threads < 1 || threads > kMostThreads) {
    throw std::invalid_argument("threads = " + std::to_string(threads) + ": must be 1..1024");
  }
  try {
    for (int i = 1; i < threads; ++i) helpers_.emplace_back([this] { help(*shared_); });
  } catch (const std::system_error& error) {
    end_helpers();
    throw std::runtime_error("threads = " + std::to_string(threads) +
                             ": the system has not so many: " + error.what());
  }
}

RunPool::~RunPool() {
  if (!process_.is_here()) {  // the threads are not
    for (std::thread& helper : helpers_) helper.detach();
    static_cast<void>(shared_.release());
    return;
  }
  end_helpers();
}

void RunPool::end_helpers() {
  {
    const std::scoped_lock lock(shared_->lock);
    shared_->ends = true;
  }
  shared_->begins.notify_all();
  for (std::thread& helper : helpers_) helper.join();
}

void RunPool::help(Shared& shared) {
  std::unique_lock held(shared.lock);
  for (std::uint64_t seen = 0;;) {
    shared.begins.wait(held, [&] { return shared.ends || shared.round != seen; });
    if (shared.ends) return;
    seen = shared.round;
    shared.take_part(held);
  }
}

void RunPool::each(std::size_t count, const std::function<void(std::size_t)>& work) {
  process_.require_here("this pool of threads");
  if (busy_.exchange(true)) throw BusyError("these threads are at work for another one");
  const std::unique_ptr<std::atomic<bool>, void (*)(std::atomic<bool>*)> at_work(
      &busy_, [](std::atomic<bool>* busy) { *busy = false; });
  std::unique_lock held(shared_->lock);
  shared_->work = &work;
  shared_->next = 0;
  shared_->count = count;
  shared_->failure = nullptr;
  ++shared_->round;
  shared_->begins.notify_all();
  shared_->take_part(held);
  shared_->ended.wait(held, [this] { return shared_->at_work == 0; });
  if (shared_->failure) std::rethrow_exception(std::exchange(shared_->failure, nullptr));
}

}  // namespace gaitway::python
