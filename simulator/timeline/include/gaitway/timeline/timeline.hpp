// The time line of a simulation: what has happened on it, and copies of the simulation that wait at some of
// its instants, so that any of them is reached by a short replay.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gaitway/timeline/simulation_copy.hpp"
#include "gaitway/timeline/timed_event.hpp"

namespace gaitway::timeline {

// Passive: keep_up() does what is to be done beside the simulation that runs, and waits for nobody.
class Timeline {
 public:
  static constexpr std::int64_t kSpacing_ns = 10'000'000'000;  // of the copies, at the line's newer end
  static constexpr std::size_t kMostCopies = 40;               // then older ones are thinned out
  static constexpr std::size_t kNewestKept = 12;

  // `start`: the simulation at 0. `most_copies`: more than kNewestKept.
  explicit Timeline(CopyHandle start, std::size_t most_copies = kMostCopies);
  ~Timeline();
  Timeline(const Timeline&) = delete;
  Timeline& operator=(const Timeline&) = delete;

  // The simulation that runs has come to `until_ns`; `events` happened since the last call. `digests`: its
  // own, at instants of kSpacing_ns.
  void extend(std::int64_t until_ns, std::span<const TimedEvent> events);
  void note_digest(std::int64_t at_ns, std::uint64_t digest);
  // What happened behind that instant is forgotten.
  void forget_after(std::int64_t at_ns);
  // Everything; a copy of the start, where nothing has happened.
  [[nodiscard]] CopyHandle begin_anew();
  // From there on nothing can be replayed, for this reason.
  void bar(std::int64_t at_ns, std::string why);

  // A copy of the simulation as it was at that instant, 0 to recorded_ns(): with all that was done to it
  // before the millisecond that begins then. Takes as long as the replay from the copy before it. Throws
  // std::invalid_argument: beyond a bar; ChannelEnded, std::runtime_error: it failed.
  [[nodiscard]] CopyHandle at(std::int64_t at_ns);

  // Of all that was done up to there; throws as at() does.
  [[nodiscard]] std::uint64_t digest_at(std::int64_t at_ns);

  // Makes copies while the simulation goes on. What fails bars the line.
  void keep_up();
  // Readable when keep_up() has something to do; -1: nothing is awaited.
  [[nodiscard]] int wake_fd() const noexcept {
    return on_the_way_ ? on_the_way_->handle.channel().descriptor() : -1;
  }

  [[nodiscard]] std::int64_t recorded_ns() const noexcept { return recorded_ns_; }
  [[nodiscard]] std::span<const TimedEvent> events() const noexcept { return events_; }
  [[nodiscard]] std::size_t copies() const noexcept { return copies_.size(); }
  // Replays that ended elsewhere than the simulation that ran: none, or something in it is not deterministic.
  [[nodiscard]] std::uint64_t differences() const noexcept { return differences_; }

 private:
  struct OnTheWay {
    CopyHandle handle;
    std::int64_t to_ns = 0;
  };
  void send_events(const CopyChannel& channel, std::int64_t from_ns, std::int64_t to_ns) const;
  [[nodiscard]] CopyHandle replay(CopyHandle copy, std::int64_t from_ns, std::int64_t at_ns);
  void lose(std::map<std::int64_t, CopyHandle>::iterator copy);
  [[nodiscard]] bool finish_one();
  void begin_next();
  void compare(std::int64_t at_ns, std::uint64_t digest);
  void thin_out();

  std::size_t most_copies_;
  std::map<std::int64_t, CopyHandle> copies_;  // by their instant; 0 is always there
  std::optional<OnTheWay> on_the_way_;
  std::vector<TimedEvent> events_;  // in order of time
  std::map<std::int64_t, std::uint64_t> digests_;
  std::int64_t recorded_ns_ = 0;
  std::optional<std::pair<std::int64_t, std::string>> bar_;
  std::uint64_t differences_ = 0;
};

}  // namespace gaitway::timeline
