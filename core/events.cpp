// Causes by name, and when they are told; a few events a tick, so that a flood of them costs no tick.
#include "gaitway/core/events.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <utility>

#include "gaitway/facts/facts.hpp"
#include "gaitway/input/text.hpp"
#include "gaitway/process/real_time.hpp"
#include "gaitway/process/wall_clock.hpp"

namespace gaitway::core {
namespace {

struct Cause {
  std::uint64_t NetworkHealth::*count;
  std::uint32_t incident;  // as in NetworkHealth::last_incident
  std::string_view text;
};

constexpr std::array<Cause, NetworkEvents::kCauses> kTold{{
    {&NetworkHealth::forged, 11,
     "frames of others that claim to come from the message controller: safe stop"},
    {&NetworkHealth::second_senders, 13, "time slots with two different feedback frames of one node"},
    {&NetworkHealth::bus_offs, 17, "times off the bus"},
    {&NetworkHealth::feedback_missing, 1, "nodes fell silent for two time slots"},
    {&NetworkHealth::nodes_restarted, 3, "nodes have restarted"},
    {&NetworkHealth::stops_repeated, 18, "emergency stops sent again, since a joint had not confirmed them"},
    {&NetworkHealth::unknown_identifiers, 6, "frames with an unknown identifier"},
    {&NetworkHealth::wrong_lengths, 7, "frames of a wrong length"},
    {&NetworkHealth::remote_frames, 8, "remote frames"},
    {&NetworkHealth::extended_frames, 9, "frames with an extended identifier"},
    {&NetworkHealth::undefined_values, 10, "frames with an undefined value"},
    {&NetworkHealth::expired, 14, "frames not sent before their transmit deadline"},
    {&NetworkHealth::flushed, 15, "frames dropped while the bus was off"},
    {&NetworkHealth::queue_full, 16, "frames for which the transmit queue had no room"},
    {&NetworkHealth::doubled, 12, "frames that came twice"},
}};

constexpr std::string_view kTopic = "events";

msgclient::Writer<gaitway::Event> claim(msgclient::Client& client) {
  const auto declared = client.find(kTopic);
  return client.write_stream<gaitway::Event>(kTopic, declared ? 0 : EventPublisher::kStreamCapacity);
}

template <std::size_t size>
void copy_to_field(std::string_view text, std::uint8_t (&field)[size]) noexcept {
  std::memcpy(field, text.data(), std::min(text.size(), size - 1));
}

gaitway::Event published_form(const Event& event) noexcept {
  gaitway::Event result{};
  result.stamp_ns = event.stamp_ns;
  result.kind = static_cast<std::uint32_t>(event.kind);
  copy_to_field(event.source(), result.source);
  copy_to_field(event.text(), result.text);
  return result;
}

// In quotes of JSON: what a terminal would obey, and what is not UTF-8 (a text that was cut off, say), is
// spelled out, since people look at these files, too.
void append_json_text(std::string& out, std::string_view text) {
  for (const char character : input::terminal_text(text)) {
    switch (character) {
      case '"':
      case '\\':
        out += '\\';
        out += character;
        break;
      case '\n':
        out += "\\n";
        break;
      case '\t':
        out += "\\t";
        break;
      default:
        out += character;
    }
  }
}

std::string line_for_people(const std::string& program, const std::string& time, const Event& event) {
  return fmt::format("{}: {}: {}: {}: {}\n", program, time, event_kind_name(event.kind),
                     input::terminal_text(event.source()), input::terminal_text(event.text()));
}

}  // namespace

std::size_t NetworkEvents::describe(std::size_t cause, const NetworkHealth& health,
                                    std::array<char, 160>& text) noexcept {
  const std::uint64_t count = health.*kTold[cause].count;
  if (count == 0 || count < next_[cause]) {
    return 0;
  }
  next_[cause] = 2 * count;
  const bool node_known = health.last_incident == kTold[cause].incident && health.last_incident_node != 0;
  return node_known ? format_into(text, "message network: {} {} (node {})", count, kTold[cause].text,
                                  health.last_incident_node)
                          .size()
                    : format_into(text, "message network: {} {}", count, kTold[cause].text).size();
}

std::size_t SilenceEvents::describe(const NetworkState& newest, std::int64_t now_ns,
                                    std::array<char, 200>& text) noexcept {
  const bool was_silent = is_silent();
  const std::int64_t before_ns = std::exchange(stamp_ns_, newest.stamp_ns);
  if (newest.stamp_ns != before_ns) {
    ticks_ = 0;
    return was_silent ? format_into(text, "message controller is back after {:.2f} s",
                                    static_cast<double>(now_ns - before_ns) * 1e-9)
                            .size()
                      : 0;
  }
  ticks_ = std::min(ticks_ + 1, kSilentTicks);
  if (was_silent || !is_silent()) return 0;
  const std::int64_t silence_ms = (now_ns - newest.stamp_ns) / facts::kMillisecond_ns;
  const std::string_view points = newest.tail_points == 1 ? "point" : "points";
  return format_into(text,
                     "message controller silent for {} ms: the joints play out their batch and {} {} of the "
                     "joints' tail, and hold",
                     silence_ms, newest.tail_points, points)
      .size();
}

EventPublisher::EventPublisher(msgclient::Client& client) : writer_(claim(client)) {}

void EventPublisher::step(const EventLog& events, std::int64_t now_ns) noexcept {
  if (next_ < events.first()) {
    missed_ += events.first() - next_;
    next_ = events.first();
  }
  for (std::uint32_t i = 0; i < kEventsAStep && next_ < events.total(); ++i, ++next_) {
    writer_.publish(published_form(events[next_]), now_ns);
  }
}

void append_event_line(std::string& out, const Event& event) {
  fmt::format_to(std::back_inserter(out), R"({{"time_s":{:.3f},"kind":"{}","source":")",
                 static_cast<double>(event.stamp_ns) * 1e-9, event_kind_name(event.kind));
  append_json_text(out, event.source());
  out += R"(","text":")";
  append_json_text(out, event.text());
  out += "\"}\n";
}

bool EventPrinter::print(const EventLog& events) {
  constexpr std::uint64_t kEventsAPrint = 20;
  if (next_ < events.first()) {
    fmt::print(stderr, "{}: {} events are left out\n", program_, events.first() - next_);
    next_ = events.first();
  }
  for (std::uint64_t printed = 0; next_ < events.total() && printed < kEventsAPrint; ++printed, ++next_) {
    const Event& event = events[next_];
    const std::string time = fmt::format("{:.3f} s", static_cast<double>(event.stamp_ns) * 1e-9);
    fmt::print(stderr, "{}", line_for_people(program_, time, event));
  }
  return next_ < events.total();
}

namespace {

constexpr std::uint64_t kEventsFile_bytes = std::uint64_t{16} << 20;  // and the one before it

Event event_of_log(std::string_view source, std::string_view text) {
  Event event;
  event.stamp_ns = process::monotonic_ns();
  event.kind = EventKind::info;
  copy_text(source, event.source_text);
  copy_text(text, event.message_text);
  return event;
}

std::string json_line(const Event& event) {
  std::string line;
  append_event_line(line, event);
  return line;
}

}  // namespace

EventLines::EventLines(const std::string& program, const std::filesystem::path& file, bool on_terminal)
    : program_(program) {
  if (on_terminal) {
    terminal_ = std::make_unique<process::BackgroundLog>(
        process::LogFile(STDERR_FILENO, "stderr"),
        process::BackgroundLogOptions{.gap_line = [program](std::uint64_t lost, const auto&) {
          return fmt::format("{}: {} events are left out\n", program, lost);
        }});
  }
  if (!file.empty()) {
    file_ = std::make_unique<process::BackgroundLog>(
        process::LogFile(file, {.start = process::LogOptions::Start::go_on, .most_bytes = kEventsFile_bytes}),
        process::BackgroundLogOptions{
            .gap_line =
                [program](std::uint64_t lost, const std::string& reason) {
                  return json_line(
                      event_of_log(program, fmt::format("{} events are missing here: {}", lost, reason)));
                },
            .tell = process::tell_on_stderr(program)});
    const auto now = std::chrono::system_clock::now();
    file_->add(json_line(event_of_log(
        program, fmt::format("begins as process {} at {:%Y-%m-%dT%H:%M:%SZ}", getpid(), fmt::gmtime(now)))));
  }
}

bool EventLines::step(const EventLog& events) {
  constexpr std::uint64_t kEventsAStep = 20;
  if (next_ < events.first()) {
    missed_ += events.first() - next_;
    next_ = events.first();
  }
  for (std::uint64_t told = 0; next_ < events.total() && told < kEventsAStep; ++told, ++next_) {
    if (terminal_) {
      const std::string time = process::date_and_time_of(events[next_].stamp_ns);
      terminal_->add(line_for_people(program_, time, events[next_]));
    }
    if (file_) file_->add(json_line(events[next_]));
  }
  return next_ < events.total();
}

process::LogCount EventLines::end(const EventLog& events) {
  while (step(events)) {
  }
  if (terminal_) terminal_->close();
  process::LogCount count = file_ ? file_->close() : process::LogCount{};
  count.lost += missed_;
  return count;
}

}  // namespace gaitway::core
