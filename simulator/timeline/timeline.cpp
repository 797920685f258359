// Copies at instants, and the events between them.
#include "gaitway/timeline/timeline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace gaitway::timeline {
namespace {

constexpr std::size_t kEventsAPacket = 20;  // of 4,000 bytes each at most

// What it answers to "advance".
std::uint64_t digest_told_by(const CopyHandle& copy) {
  auto done = copy.receive(CopyChannel::kForEver);
  while (!done) done = copy.receive(CopyChannel::kForEver);
  return done->message.at("digest").get<std::uint64_t>();
}

}  // namespace

Timeline::Timeline(CopyHandle start, std::size_t most_copies) : most_copies_(most_copies) {
  copies_.emplace(0, std::move(start));
}

// The first one last: what is left of the others comes to it.
Timeline::~Timeline() {
  on_the_way_.reset();
  while (!copies_.empty()) copies_.erase(std::prev(copies_.end()));
}

void Timeline::extend(std::int64_t until_ns, std::span<const TimedEvent> events) {
  events_.insert(events_.end(), events.begin(), events.end());
  recorded_ns_ = std::max(recorded_ns_, until_ns);
}

void Timeline::note_digest(std::int64_t at_ns, std::uint64_t digest) {
  digests_.insert_or_assign(at_ns, digest);
}

void Timeline::forget_after(std::int64_t at_ns) {
  std::erase_if(events_, [at_ns](const TimedEvent& event) { return event.at_ns > at_ns; });
  std::erase_if(copies_, [at_ns](const auto& copy) { return copy.first > std::max<std::int64_t>(at_ns, 0); });
  std::erase_if(digests_, [at_ns](const auto& digest) { return digest.first > at_ns; });
  if (on_the_way_ && on_the_way_->to_ns > at_ns) on_the_way_.reset();
  if (bar_ && bar_->first >= at_ns) bar_.reset();
  recorded_ns_ = std::min(recorded_ns_, at_ns);
}

void Timeline::bar(std::int64_t at_ns, std::string why) {
  if (!bar_ || at_ns < bar_->first) bar_.emplace(at_ns, std::move(why));
}

void Timeline::send_events(const CopyChannel& channel, std::int64_t from_ns, std::int64_t to_ns) const {
  const auto first = std::ranges::lower_bound(events_, from_ns, {}, &TimedEvent::at_ns);
  const auto last = std::ranges::lower_bound(events_, to_ns, {}, &TimedEvent::at_ns);
  for (auto begin = first; begin < last;) {
    const auto end = begin + std::min<std::ptrdiff_t>(last - begin, kEventsAPacket);
    channel.send({{"do", "events"}, {"events", to_json(std::span(begin, end))}});
    begin = end;
  }
}

CopyHandle Timeline::at(std::int64_t at_ns) {
  if (bar_ && at_ns > bar_->first) {
    throw std::invalid_argument(fmt::format(
        "{:.3f} s cannot be reached: {} at {:.3f} s, which no replay does. "
        "Choose an instant before that",
        static_cast<double>(at_ns) * 1e-9, bar_->second, static_cast<double>(bar_->first) * 1e-9));
  }
  while (true) {
    const auto before = std::prev(copies_.upper_bound(at_ns));
    try {
      return replay(before->second.copy(), before->first, at_ns);
    } catch (const ChannelEnded&) {
      lose(before);
    }
  }
}

// Up to that instant, and what was done at it.
CopyHandle Timeline::replay(CopyHandle copy, std::int64_t from_ns, std::int64_t at_ns) {
  send_events(copy.channel(), from_ns, at_ns + 1);
  copy.channel().send({{"do", "advance"}, {"to_ns", at_ns}, {"what_is_due", true}});
  compare(at_ns, digest_told_by(copy));
  return copy;
}

// Its process has been ended by somebody: the one before it serves, too.
void Timeline::lose(std::map<std::int64_t, CopyHandle>::iterator copy) {
  if (copy == copies_.begin()) {
    throw std::runtime_error(
        "the time line is lost: the process at its start has been ended. Start the simulator anew");
  }
  copies_.erase(copy);
}

CopyHandle Timeline::begin_anew() {
  CopyHandle start = copies_.begin()->second.copy();
  forget_after(-1);
  recorded_ns_ = 0;
  differences_ = 0;
  return start;
}

std::uint64_t Timeline::digest_at(std::int64_t at_ns) {
  const CopyHandle copy = at(at_ns);
  copy.channel().send({{"do", "advance"}, {"to_ns", at_ns}});
  return digest_told_by(copy);
}

void Timeline::keep_up() {
  try {
    if (on_the_way_ && !finish_one()) return;
    begin_next();
  } catch (const ChannelEnded&) {
    on_the_way_.reset();  // somebody has ended its process: the next call begins it again
  } catch (const std::exception& error) {
    on_the_way_.reset();
    bar(copies_.rbegin()->first, fmt::format("a replay failed ({})", error.what()));
  }
}

// False: it is still on its way.
bool Timeline::finish_one() {
  const auto done = on_the_way_->handle.receive(0);
  if (!done) return false;
  compare(on_the_way_->to_ns, done->message.at("digest").get<std::uint64_t>());
  copies_.insert_or_assign(on_the_way_->to_ns, std::move(on_the_way_->handle));
  on_the_way_.reset();
  thin_out();
  return true;
}

void Timeline::begin_next() {
  const auto last = std::prev(copies_.end());
  const std::int64_t next_ns = last->first + kSpacing_ns;
  if (next_ns > recorded_ns_ || (bar_ && next_ns > bar_->first)) return;
  try {
    on_the_way_.emplace(last->second.copy(), next_ns);
  } catch (const ChannelEnded&) {
    return lose(last);
  }
  send_events(on_the_way_->handle.channel(), last->first, next_ns);
  on_the_way_->handle.channel().send({{"do", "advance"}, {"to_ns", next_ns}});
}

void Timeline::compare(std::int64_t at_ns, std::uint64_t digest) {
  const auto known = digests_.find(at_ns);
  if (known != digests_.end() && known->second != digest) ++differences_;
}

// Of the older ones, that whose neighbours are closest to each other goes.
void Timeline::thin_out() {
  if (copies_.size() <= most_copies_) return;
  auto closest = copies_.end();
  std::int64_t gap_ns = 0;
  const auto end = std::prev(copies_.end(), kNewestKept);
  for (auto copy = std::next(copies_.begin()); copy != end; ++copy) {
    const std::int64_t between_ns = std::next(copy)->first - std::prev(copy)->first;
    if (closest == copies_.end() || between_ns < gap_ns) {
      closest = copy;
      gap_ns = between_ns;
    }
  }
  copies_.erase(closest);
}

}  // namespace gaitway::timeline
