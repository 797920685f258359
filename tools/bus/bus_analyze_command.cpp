// `gaitway bus analyze`: how long each message of a bus takes in the worst case, and how much more it could
// carry.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "gaitway/can/analysis/network_messages.hpp"
#include "gaitway/can/analysis/response_time.hpp"
#include "gaitway/can/frame.hpp"
#include "gaitway/msgcontroller/network_profile.hpp"
#include "gaitway/process/installation.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "tools/bus/bus_options.hpp"

namespace gaitway::tools {
namespace {

constexpr int kExitMisses = 3;  // a message may miss its deadline

struct BusAnalyzeOptions {
  std::filesystem::path robot = process::default_robot_directory();  // folder with robot.urdf and robot.yaml
  std::optional<std::filesystem::path> messages;  // instead of a robot: see read_message_list()
  std::string profile;                            // instead of what the robot's network file says
  std::optional<double> jitter_ms;  // of every message of the robot; as `gaitway run` asks for when left out
  // They add up. When both are left out: of a robot, what `gaitway run` asks for, and none of messages.
  std::vector<std::string> errors;    // see parse_errors()
  std::optional<double> jam_ms;       // one jam at the worst instant
  std::int64_t bit_rate = 1'000'000;  // bit/s
  bool priorities = false;            // print the best order even if it is not needed
  bool json = false;
};

constexpr double kLongest_ms = 1e6;
constexpr std::int64_t kSlowest_bit_per_s = 1000, kFastest_bit_per_s = 1'000'000;

// What is analysed.
struct Subject {
  std::string title;
  std::vector<can::AnalysedMessage> messages;
  std::optional<can::Profile> profile = std::nullopt;  // none: the messages are the user's
};

std::int64_t time_ns(const char* option, double time_ms) {
  if (!(time_ms >= 0.0 && time_ms <= kLongest_ms)) {
    throw std::invalid_argument(
        fmt::format("{} {}: must lie between 0 and {:.0f} ms", option, time_ms, kLongest_ms));
  }
  return std::llround(time_ms * 1e6);
}

can::ErrorModel errors_of(const BusAnalyzeOptions& options) {
  if (!options.messages && options.errors.empty() && !options.jam_ms) {
    return can::jam(msgcontroller::kJam_ns);
  }
  can::ErrorModel errors;
  for (const std::string& text : options.errors) {
    errors.push_back(parse_errors(text));
  }
  if (const std::int64_t jam_ns = time_ns("--jam-ms", options.jam_ms.value_or(0.0)); jam_ns > 0) {
    errors.push_back(can::jam(jam_ns).front());
  }
  return errors;
}

can::ProofAssumptions assumptions_of(const BusAnalyzeOptions& options) {
  if (options.bit_rate < kSlowest_bit_per_s || options.bit_rate > kFastest_bit_per_s) {
    throw std::invalid_argument(fmt::format("--bit-rate {}: must lie between {} and {} bit/s",
                                            options.bit_rate, kSlowest_bit_per_s, kFastest_bit_per_s));
  }
  return {.jitter_ns = options.jitter_ms ? time_ns("--jitter-ms", *options.jitter_ms)
                                         : msgcontroller::kReleaseJitter_ns,
          .errors = errors_of(options),
          .bit_time_ns = (1'000'000'000 + options.bit_rate - 1) / options.bit_rate};
}

Subject subject_of(const BusAnalyzeOptions& options, const can::ProofAssumptions& assumptions) {
  if (options.messages) {
    return {options.messages->string(), read_message_list(*options.messages)};
  }
  const urdf::RobotModel robot = msgcontroller::load_robot(options.robot, options.profile);
  const can::Profile profile = msgcontroller::network_profile(robot);
  const std::vector<can::NodeId> nodes = msgcontroller::nodes_on_bus(profile, robot);
  return {fmt::format("robot {}, profile {}, {} joints", robot.name, profile.name, nodes.size()),
          can::message_set(profile, nodes, assumptions.jitter_ns), profile};
}

// For people: what the bounds count on.
std::string describe(const can::ErrorModel& errors) {
  const auto ms = [](std::int64_t time_ns) {
    return fmt::format("{} ms", static_cast<double>(time_ns) * 1e-6);
  };
  std::string text;
  for (const can::ErrorSource& source : errors) {
    text += text.empty() ? "" : "; ";
    text += source.duration_ns > 0
                ? fmt::format("{} of {}", source.burst == 1 ? "a jam" : "jams", ms(source.duration_ns))
                : std::string(source.burst == 1 ? "an error" : "errors");
    text += source.burst == 1 ? "" : fmt::format(", {} at once", source.burst);
    text += source.interval_ns > 0 ? fmt::format(", another every {}", ms(source.interval_ns)) : "";
  }
  return text.empty() ? "no errors" : text;
}

double in_us(std::int64_t time_ns) {
  return static_cast<double>(time_ns) * 1e-3;
}

std::string in_ms(std::optional<std::int64_t> time_ns) {
  return time_ns ? fmt::format("{:.3f}", static_cast<double>(*time_ns) * 1e-6) : "no bound";
}

void print_json(const Subject& subject, const std::vector<can::MessageResponse>& responses) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < responses.size(); ++i) {
    const can::MessageResponse& response = responses[i];
    nlohmann::ordered_json worst_us;
    if (response.worst_response_ns) {
      worst_us = in_us(*response.worst_response_ns);
    }
    list.push_back({{"name", subject.messages[i].name},
                    {"id", subject.messages[i].id},
                    {"length_bits", response.length_bits},
                    {"blocking_us", in_us(response.blocking_ns)},
                    {"worst_response_us", worst_us},
                    {"deadline_us", in_us(response.deadline_ns)},
                    {"schedulable", response.schedulable()}});
  }
  fmt::print("{}\n", list.dump(2));
}

// The most urgent first.
void print_table(const Subject& subject, const std::vector<can::MessageResponse>& responses) {
  std::size_t width = 4;
  std::vector<std::size_t> order(responses.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&subject](std::size_t i) {
    const can::AnalysedMessage& message = subject.messages[i];
    return can::arbitration_key({.id = message.id, .extended = message.extended});
  };
  std::ranges::sort(order, [&key](std::size_t a, std::size_t b) { return key(a) < key(b); });
  for (const can::AnalysedMessage& message : subject.messages) {
    width = std::max(width, message.name.size());
  }
  fmt::print("{:<{}} {:>10} {:>10} {:>8} {:>6} {:>8} {:>10} {:>10} {:>10}\n", "message", width, "id",
             "period", "jitter", "bits", "blocked", "worst", "deadline", "slack");
  fmt::print("{:<{}} {:>10} {:>10} {:>8} {:>6} {:>8} {:>10} {:>10} {:>10}\n", "", width, "", "ms", "ms", "",
             "ms", "ms", "ms", "ms");
  for (const std::size_t i : order) {
    const can::AnalysedMessage& message = subject.messages[i];
    const can::MessageResponse& response = responses[i];
    fmt::print("{:<{}} {:>10} {:>10} {:>8} {:>6} {:>8} {:>10} {:>10} {:>10}{}\n", message.name, width,
               message.extended ? fmt::format("{:#010x}", message.id) : fmt::format("{:#05x}", message.id),
               in_ms(message.period_ns), in_ms(message.jitter_ns), response.length_bits,
               in_ms(response.blocking_ns), in_ms(response.worst_response_ns), in_ms(response.deadline_ns),
               response.slack_ns() ? in_ms(response.slack_ns()) : "",
               response.schedulable() ? "" : "  misses");
  }
}

void print_order(const Subject& subject, const can::AnalysisOptions& analysis) {
  const auto order = can::best_priority_order(subject.messages, analysis);
  if (!order) {
    fmt::print("best order       none: whatever the priorities, a message may miss its deadline\n");
    return;
  }
  fmt::print("best order       with these priorities, the most urgent first, every deadline is met:\n");
  for (std::size_t place = 0; place < order->size(); ++place) {
    fmt::print("  {:>4}  {}\n", place + 1, subject.messages[(*order)[place]].name);
  }
}

void print_capacity(const Subject& subject, const can::AnalysisOptions& analysis,
                    const can::ProofAssumptions& assumptions) {
  fmt::print("\nload             {:.1f} %\n", 100.0 * can::bus_load(subject.messages, analysis.bit_time_ns));
  if (const auto limit = can::breakdown(subject.messages, analysis)) {
    fmt::print("breakdown load   {:.1f} %, on a bus of {:.1f} kbit/s\n", 100.0 * limit->load,
               1e6 / static_cast<double>(limit->bit_time_ns));
  } else {
    fmt::print("breakdown load   none: no bus is fast enough\n");
  }
  if (subject.profile) {
    fmt::print("joints that fit  {} (the profile has identifiers for {})\n",
               can::most_joints(subject.profile->with_tail_parts(0), assumptions),
               subject.profile->largest_node);
    if (subject.profile->has(can::MessageKind::tail)) {
      fmt::print("with tails       {}, of {} frames each\n", can::most_joints(*subject.profile, assumptions),
                 subject.profile->tail_parts);
    }
  }
}

int analyze_bus(const BusAnalyzeOptions& options) {
  const can::ProofAssumptions assumptions = assumptions_of(options);
  const Subject subject = subject_of(options, assumptions);
  const can::AnalysisOptions analysis{.bit_time_ns = assumptions.bit_time_ns, .errors = assumptions.errors};
  const std::vector<can::MessageResponse> responses = can::response_times(subject.messages, analysis);
  const auto misses = std::ranges::count_if(
      responses, [](const can::MessageResponse& response) { return !response.schedulable(); });
  if (options.json) {
    print_json(subject, responses);
    return misses == 0 ? 0 : kExitMisses;
  }
  fmt::print("{}, {:.1f} kbit/s, {}\n\n", subject.title, 1e6 / static_cast<double>(analysis.bit_time_ns),
             describe(analysis.errors));
  print_table(subject, responses);
  print_capacity(subject, analysis, assumptions);
  fmt::print("deadlines        {}\n", misses == 0
                                          ? "every message meets its own"
                                          : fmt::format("{} of {} may be missed", misses, responses.size()));
  if (misses > 0 || options.priorities) {
    print_order(subject, analysis);
  }
  return misses == 0 ? 0 : kExitMisses;
}

}  // namespace

void add_bus_analyze(const CommandLine& bus) {
  const CommandLine command = bus.subcommand(
      "analyze", "Worst response of every message against its deadline, and what else would fit");
  BusAnalyzeOptions& options = command.runs(analyze_bus);
  const Option robot = command.option("--robot", options.robot, "Folder with robot.urdf and robot.yaml");
  const Option profile =
      command.option("--profile", options.profile,
                     "Messages of the robot's bus: full or paper. Without it, what its network file says");
  const Option jitter = command.option("--jitter-ms", options.jitter_ms,
                                       "Every message may come this much later than it should (default 1)");
  command
      .option("--messages", options.messages,
              "Any messages instead of a robot's: JSON list of {name, id, bytes, period_us, jitter_us, "
              "deadline_us}, and if need be extended (true: 29-bit id) and fifo (name of a shared "
              "transmit queue)")
      .excludes(robot)
      .excludes(profile)
      .excludes(jitter);
  command.repeated("--errors", options.errors,
                   "Disturbance: burst:N, interval:TIME, jam:TIME, between commas; may be given again, and "
                   "adds up. N errors (or jams) come at once at the worst instant, then one every interval");
  command.option(
      "--jam-ms", options.jam_ms,
      "One jam of this length, short for --errors jam:... (default, of a robot without --errors: 2)");
  command.option("--bit-rate", options.bit_rate, "Of the bus, in bit/s");
  command.option("--priorities", options.priorities, "Print the best order of priorities in any case");
  command.option("--json", options.json,
                 "For programs: a list of {name, id, length_bits, blocking_us, worst_response_us, "
                 "deadline_us, schedulable}; worst_response_us is null where there is no bound");
  command.footer(
      "Examples:\n"
      "  gaitway bus analyze\n"
      "  gaitway bus analyze --jitter-ms 0 --jam-ms 0\n"
      "  gaitway bus analyze --profile paper --errors burst:4,interval:10ms\n"
      "  gaitway bus analyze --errors jam:2ms,interval:500ms --errors interval:5ms --priorities\n"
      "  gaitway bus analyze --messages car.json --bit-rate 125000 --json\n"
      "Exit code: 0 every message meets its deadline, 3 one may miss it, 1 the input was bad.");
}

}  // namespace gaitway::tools
