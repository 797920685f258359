// What one socketcand client has asked for: modes and jobs after Linux's broadcast manager, which the
// protocol exposes.
#include "gaitway/can/simulated/socketcand_session.hpp"

#include <algorithm>
#include <utility>

namespace gaitway::can {
namespace {

using socketcand::Command;
using socketcand::Verb;

bool same_identifier(const Frame& a, const Frame& b) noexcept {
  return a.id == b.id && a.extended == b.extended;
}

// In the bits that the mask has; bytes that a frame does not have count as zero.
bool same_content(const Frame& mask, const Frame& a, const Frame& b) noexcept {
  for (std::size_t i = 0; i < mask.data.size(); ++i) {
    if (((a.data[i] ^ b.data[i]) & mask.data[i]) != 0) {
      return false;
    }
  }
  return true;
}

std::string identifier_text(const Frame& frame) {
  std::string text;  // "< frame 123 0.000000  >"
  socketcand::append_frame(text, {.id = frame.id, .extended = frame.extended}, 0);
  const std::size_t begin = std::string_view("< frame ").size();
  return text.substr(begin, text.find(' ', begin) - begin);
}

template <class List>
auto find(List& list, const Frame& frame, Frame List::value_type::*member) {
  return std::ranges::find_if(list, [&](const auto& one) { return same_identifier(one.*member, frame); });
}

}  // namespace

SocketcandSession::SocketcandSession(std::string_view bus_name) : bus_name_(bus_name) {
  answer("< hi >");
}

void SocketcandSession::take(std::string_view& input, std::int64_t now_ns) {
  socketcand::ElementReader::Element element;
  while (!ended_ && !overrun_ && queue_.size() < kQueuedFrames && reader_.next(input, element)) {
    if (element.too_long) {
      reject("a command has at most " + std::to_string(socketcand::kLongestElement) + " characters");
      continue;
    }
    const auto parsed = socketcand::parse_element(element.text);
    if (const auto* const rejection = std::get_if<socketcand::Rejection>(&parsed)) {
      reject(rejection->reason);
    } else {
      handle(std::get<Command>(parsed), now_ns);
    }
  }
}

void SocketcandSession::handle(const Command& command, std::int64_t now_ns) {
  if (mode_ == Mode::no_bus) {
    handle_without_bus(command);
  } else if (command.verb == Verb::echo) {
    answer("< echo >");
  } else if (!switch_mode(command.verb, now_ns)) {
    handle_on_bus(command, now_ns);
  }
}

void SocketcandSession::handle_without_bus(const Command& command) {
  if (command.verb == Verb::open) {
    if (command.bus == bus_name_) {
      mode_ = Mode::bcm;
      answer("< ok >");
      return;
    }
    reject("there is no bus '" + command.bus + "'; the robot's bus is '" + bus_name_ + "'");
    ended_ = true;
  } else if (command.verb == Verb::configure) {
    reject("the simulated bus has a fixed bit rate of 1 Mb/s and no control modes");
  } else {
    reject("no bus is open; begin with open " + bus_name_);
  }
}

bool SocketcandSession::switch_mode(Verb verb, std::int64_t now_ns) {
  switch (verb) {
    case Verb::bcmmode:
      mode_ = Mode::bcm;
      break;
    case Verb::rawmode:
      silent_until_ns_ = now_ns + kAnswerAlone_ns;
      mode_ = Mode::raw;
      break;
    case Verb::controlmode:
      mode_ = Mode::control;
      break;
    default:
      return false;
  }
  // They belong to the mode that was left.
  jobs_.clear();
  subscriptions_.clear();
  statistics_interval_ns_ = 0;
  answer("< ok >");
  return true;
}

void SocketcandSession::handle_on_bus(const Command& command, std::int64_t now_ns) {
  switch (command.verb) {
    case Verb::isotpmode:
    case Verb::muxfilter:
      reject("ISO-TP and multiplex filters are not served here");
      return;
    case Verb::open:
    case Verb::configure:
      reject("the bus '" + bus_name_ + "' is open already");
      return;
    case Verb::statistics:
      if (mode_ != Mode::control) {
        reject("statistics are told in control mode only; switch with controlmode");
        return;
      }
      statistics_interval_ns_ = command.interval_ns;
      statistics_due_ns_ = now_ns + command.interval_ns;
      return;
    case Verb::send:
      if (mode_ == Mode::control) {
        reject("nothing is sent in control mode; switch with rawmode or bcmmode");
        return;
      }
      queue_.push_back({command.frame, now_ns});
      return;
    default:
      break;
  }
  if (mode_ != Mode::bcm) {
    reject("jobs and subscriptions are of BCM mode only; switch with bcmmode");
  } else if (command.verb == Verb::add || command.verb == Verb::update || command.verb == Verb::erase) {
    handle_job(command, now_ns);
  } else {
    handle_subscription(command);
  }
}

void SocketcandSession::handle_job(const Command& command, std::int64_t now_ns) {
  const auto job = find(jobs_, command.frame, &Job::frame);
  if (command.verb == Verb::add) {
    const Job added{command.frame, command.interval_ns, now_ns};
    if (job != jobs_.end()) {
      *job = added;
    } else if (jobs_.size() < kJobs) {
      jobs_.push_back(added);
    } else {
      reject("a client has at most " + std::to_string(kJobs) + " send jobs; delete one first");
    }
  } else if (job == jobs_.end()) {
    reject("there is no send job with the identifier " + identifier_text(command.frame));
  } else if (command.verb == Verb::update) {
    job->frame = command.frame;
  } else {
    jobs_.erase(job);
  }
}

void SocketcandSession::handle_subscription(const Command& command) {
  const auto known = find(subscriptions_, command.frame, &Subscription::mask);
  if (command.verb == Verb::unsubscribe) {
    if (known == subscriptions_.end()) {
      reject("there is no subscription to the identifier " + identifier_text(command.frame));
    } else {
      subscriptions_.erase(known);
    }
    return;
  }
  Subscription wanted;
  wanted.mask = command.frame;
  wanted.filters = command.verb == Verb::filter;
  wanted.interval_ns = command.interval_ns;
  if (known != subscriptions_.end()) {
    *known = wanted;
  } else if (subscriptions_.size() < kSubscriptions) {
    subscriptions_.push_back(wanted);
  } else {
    reject("a client has at most " + std::to_string(kSubscriptions) +
           " subscriptions; unsubscribe from one first, or switch to rawmode");
  }
}

void SocketcandSession::on_frame(const TimedFrame& frame, bool own) {
  if (mode_ == Mode::no_bus) {
    return;
  }
  const std::size_t bytes = frame.frame.payload().size();
  if (own) {
    ++traffic_.transmitted_frames;
    traffic_.transmitted_bytes += bytes;
    return;
  }
  ++traffic_.received_frames;
  traffic_.received_bytes += bytes;
  if (mode_ == Mode::raw && frame.end_ns >= silent_until_ns_) {
    tell(frame);
  } else if (mode_ == Mode::bcm) {
    const auto wanted = find(subscriptions_, frame.frame, &Subscription::mask);
    if (wanted != subscriptions_.end()) {
      notify(*wanted, frame);
    }
  }
}

void SocketcandSession::notify(Subscription& subscription, const TimedFrame& frame) {
  if (subscription.filters && subscription.last &&
      same_content(subscription.mask, subscription.last->frame, frame.frame)) {
    return;
  }
  subscription.last = frame;
  if (subscription.told_ns && frame.end_ns < *subscription.told_ns + subscription.interval_ns) {
    subscription.withheld = frame;
    return;
  }
  subscription.told_ns = frame.end_ns;
  tell(frame);
}

void SocketcandSession::step(std::int64_t now_ns) {
  for (Subscription& subscription : subscriptions_) {
    if (subscription.withheld && now_ns >= *subscription.told_ns + subscription.interval_ns) {
      subscription.told_ns = now_ns;
      tell(*std::exchange(subscription.withheld, std::nullopt));
    }
  }
  if (statistics_interval_ns_ > 0 && now_ns >= statistics_due_ns_) {
    const std::int64_t missed = (now_ns - statistics_due_ns_) / statistics_interval_ns_;
    statistics_due_ns_ += (missed + 1) * statistics_interval_ns_;
    std::string text;
    socketcand::append_statistics(text, traffic_);
    answer(text);
  }
}

std::optional<SocketcandSession::Release> SocketcandSession::next_frame(std::int64_t now_ns,
                                                                        std::int64_t until_ns) {
  const auto due = [](const Job& job) { return job.due_ns; };
  const auto first = std::ranges::min_element(jobs_, [&](const Job& a, const Job& b) {
    return due(a).value_or(until_ns) < due(b).value_or(until_ns);
  });
  const std::int64_t first_ns = first == jobs_.end() ? until_ns : due(*first).value_or(until_ns);
  if (!queue_.empty() && queue_.front().since_ns <= std::min(first_ns, until_ns)) {
    const Release release = queue_.front();
    queue_.pop_front();
    return release;
  }
  if (first_ns >= until_ns) {
    return std::nullopt;
  }
  Release release{first->frame, first_ns};
  if (first->interval_ns == 0) {
    first->due_ns.reset();
    return release;
  }
  if (first_ns < now_ns) {
    release.since_ns += (now_ns - first_ns) / first->interval_ns * first->interval_ns;
  }
  first->due_ns = release.since_ns + first->interval_ns;
  return release;
}

void SocketcandSession::tell(const TimedFrame& frame) {
  if (frame.frame.remote) {
    ++untold_remote_frames_;
    return;
  }
  std::string text;
  socketcand::append_frame(text, frame.frame, frame.end_ns);
  answer(text);
}

void SocketcandSession::answer(std::string_view text) {
  overrun_ = overrun_ || output_.size() + text.size() > kLongestBacklog_bytes;
  if (!overrun_) {
    output_ += text;
  }
}

void SocketcandSession::reject(std::string_view reason) {
  ++rejected_;
  std::string text;
  socketcand::append_error(text, reason);
  answer(text);
}

}  // namespace gaitway::can
