// `gaitway wireless`: two programs and a bad wireless link between them.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>
#include <tuple>
#include <utility>

#include "gaitway/input/number.hpp"
#include "gaitway/process/text_file.hpp"
#include "tools/command_line.hpp"
#include "tools/wireless/link_side.hpp"
#include "tools/wireless/wireless_session.hpp"

namespace gaitway::tools {
namespace {

constexpr int kExitNoIsolation = 77;  // what test drivers take for skipped
constexpr std::int64_t kLongest_ns = 86'400'000'000'000;
constexpr std::array<input::Unit, 4> kRateUnits_bit_s{
    {{"bit", 1.0}, {"kbit", 1e3}, {"Mbit", 1e6}, {"Gbit", 1e9}}};
constexpr std::array<input::Unit, 3> kByteUnits{{{"B", 1.0}, {"KiB", 1024.0}, {"MiB", 1024.0 * 1024.0}}};

// What stands behind "--": the client's program and its arguments, which are nobody else's options.
std::vector<std::string>& client_words() {
  static std::vector<std::string> words;
  return words;
}

struct DirectionOptions {
  std::optional<std::string> rate, queue, delay, jitter, loss, fade, reorder, reorder_by, duplicate;
  std::optional<double> burst;
};

struct WirelessOptions {
  DirectionOptions both, to_robot, to_client;
  bool outages_hold = false;
  std::uint64_t seed = 1;
  std::optional<std::string> outage, up;
  int outages = 0;
  std::vector<std::string> outages_at;
  std::optional<std::string> robot, robot_ready, client;
  std::string ready_within = "30s";
  std::optional<std::filesystem::path> control, outage_log, json;
  bool quiet = false;
};

// What `read` makes of the text of that option.
template <class Read>
auto option_value(const std::string& option, const std::string& text, const Read& read) {
  try {
    return read(text);
  } catch (const std::exception& error) {
    throw std::invalid_argument(fmt::format("{} {}: {}", option, text, error.what()));
  }
}

std::int64_t duration_ns(const std::string& option, const std::string& text) {
  return option_value(option, text, [](const std::string& one) {
    return input::number_with_unit(one, input::kTimeUnits_ns, 0, kLongest_ns);
  });
}

double share(const std::string& option, const std::string& text) {
  return option_value(option, text, [](const std::string& one) {
    const auto written = input::split_number<double>(one);
    if (written.unit != "%" || written.number < 0.0 || written.number > 100.0) {
      throw std::invalid_argument("must be 0% to 100%. Write it like '3%'");
    }
    return written.number / 100.0;
  });
}

// "0.3s..10s", or one length for both.
std::pair<std::int64_t, std::int64_t> durations_ns(const std::string& option, const std::string& text) {
  const std::size_t dots = text.find("..");
  if (dots == std::string::npos) {
    const std::int64_t only_ns = duration_ns(option, text);
    return {only_ns, only_ns};
  }
  return {duration_ns(option, text.substr(0, dots)), duration_ns(option, text.substr(dots + 2))};
}

void apply(const DirectionOptions& options, DirectionSettings& settings) {
  if (options.rate) {
    settings.rate_bit_s = option_value("--rate", *options.rate, [](const std::string& text) {
      return static_cast<double>(input::number_with_unit(text, kRateUnits_bit_s, 1000, 1'000'000'000'000));
    });
  }
  if (options.queue) {
    settings.queue_bytes = option_value("--queue", *options.queue, [](const std::string& text) {
      return static_cast<std::size_t>(input::number_with_unit(text, kByteUnits, 2000, std::int64_t{1} << 30));
    });
  }
  if (options.delay) settings.delay_ns = duration_ns("--delay", *options.delay);
  if (options.jitter) settings.jitter_ns = duration_ns("--jitter", *options.jitter);
  if (options.loss) settings.loss = share("--loss", *options.loss);
  if (options.burst || options.fade) {  // one direction's in place of both directions'
    settings.mean_burst = options.burst;
    settings.mean_fade_ns = options.fade ? std::optional(duration_ns("--fade", *options.fade)) : std::nullopt;
  }
  if (options.reorder) settings.reordered = share("--reorder", *options.reorder);
  if (options.reorder_by) settings.held_back_ns = duration_ns("--reorder-by", *options.reorder_by);
  if (options.duplicate) settings.duplicated = share("--duplicate", *options.duplicate);
}

std::vector<Outage> planned_outages(const WirelessOptions& options) {
  std::vector<Outage> outages;
  if ((options.outages > 0) != options.outage.has_value()) {
    throw std::invalid_argument("--outages, --outage: one says how many, the other how long. Give both");
  }
  if (options.outage) {
    RandomOutages wanted{.count = static_cast<std::size_t>(options.outages)};
    std::tie(wanted.shortest_ns, wanted.longest_ns) = durations_ns("--outage", *options.outage);
    std::tie(wanted.shortest_up_ns, wanted.longest_up_ns) =
        durations_ns("--up", options.up.value_or("1s..5s"));
    outages = draw_outages(wanted, options.seed, 0);
  }
  for (const std::string& text : options.outages_at) {
    const std::size_t plus = text.find('+');
    if (plus == std::string::npos) {
      throw std::invalid_argument(
          fmt::format("--outage-at {}: must be instant and length, like 2s+0.5s", text));
    }
    const std::int64_t begin_ns = duration_ns("--outage-at", text.substr(0, plus));
    outages.push_back({begin_ns, begin_ns + duration_ns("--outage-at", text.substr(plus + 1))});
  }
  return outages;
}

WirelessSettings settings_of(const WirelessOptions& options) {
  WirelessSettings settings;
  const auto direction = [&](LinkEnd from, const DirectionOptions& own) {
    DirectionSettings& of_it = settings.link.from[static_cast<std::size_t>(from)];
    apply(options.both, of_it);
    apply(own, of_it);
  };
  direction(LinkEnd::client, options.to_robot);
  direction(LinkEnd::robot, options.to_client);
  settings.link.outages_hold = options.outages_hold;
  settings.seed = options.seed;
  settings.outages = planned_outages(options);
  if (options.robot) settings.robot = {"/bin/sh", "-c", *options.robot};
  if (options.client.has_value() == !client_words().empty()) {
    throw std::invalid_argument(
        "the client's program: give either --client 'COMMAND' or -- COMMAND, and not both");
  }
  settings.client =
      options.client ? std::vector<std::string>{"/bin/sh", "-c", *options.client} : client_words();
  settings.robot_ready = options.robot_ready;
  settings.robot_ready_within_ns = duration_ns("--robot-ready-within", options.ready_within);
  settings.control = options.control;
  settings.outage_log = options.outage_log;
  return settings;
}

nlohmann::ordered_json direction_json(const DirectionStatistics& count, std::size_t under_way) {
  return {{"sent", count.sent},
          {"sent_bytes", count.sent_bytes},
          {"delivered", count.delivered},
          {"delivered_bytes", count.delivered_bytes},
          {"lost_on_air", count.lost_on_air},
          {"lost_in_queue", count.lost_in_queue},
          {"lost_in_outages", count.lost_in_outages},
          {"duplicated", count.duplicated},
          {"held_back", count.held_back},
          {"under_way", under_way},
          {"queue_delay_p50_ms", count.queue_delay.percentile_ns(0.5) * 1e-6},
          {"queue_delay_p99_ms", count.queue_delay.percentile_ns(0.99) * 1e-6}};
}

nlohmann::ordered_json to_json(const WirelessResult& result, std::uint64_t seed) {
  nlohmann::ordered_json outages = nlohmann::ordered_json::array();
  for (const Outage& each : result.outages) {
    outages.push_back({{"began_ns", each.begin_ns}, {"ended_ns", each.end_ns}});
  }
  const auto late = result.lateness.summary();
  return {{"seed", seed},
          {"client_code", result.client_code},
          {"robot_code", result.robot_code ? nlohmann::ordered_json(*result.robot_code) : nullptr},
          {"client_started_ns", result.client_started_ns},
          {"client_ended_ns", result.client_ended_ns},
          {"to_robot", direction_json(result.from[1], result.under_way[1])},
          {"to_client", direction_json(result.from[0], result.under_way[0])},
          {"release_lateness_us", {{"p50", late.p50}, {"p99", late.p99}, {"max", late.max}}},
          {"outages", outages}};
}

void print_table(const WirelessResult& result) {
  fmt::print(stderr, "{:12}{:>9}{:>12}{:>11}{:>9}{:>9}{:>9}{:>7}{:>19}\n", "", "sent", "bytes", "delivered",
             "on air", "queue", "outage", "twice", "queue p50/p99 ms");
  for (const LinkEnd from : {LinkEnd::client, LinkEnd::robot}) {
    const DirectionStatistics& count = result.from[static_cast<std::size_t>(from)];
    fmt::print(stderr, "{:12}{:9}{:12}{:11}{:9}{:9}{:9}{:7}{:>19}\n",
               from == LinkEnd::client ? "to robot" : "to client", count.sent, count.sent_bytes,
               count.delivered, count.lost_on_air, count.lost_in_queue, count.lost_in_outages,
               count.duplicated,
               fmt::format("{:.1f}/{:.1f}", count.queue_delay.percentile_ns(0.5) * 1e-6,
                           count.queue_delay.percentile_ns(0.99) * 1e-6));
  }
  const auto late = result.lateness.summary();
  fmt::print(stderr,
             "outages: {}; packets behind their instant: p50 {:.0f} us, p99 {:.0f} us, at most {:.0f} us\n",
             result.outages.size(), late.p50, late.p99, late.max);
  if (result.robot_code)
    fmt::print(stderr, "the robot's program had ended before, with {}\n", *result.robot_code);
}

int run_wireless_command(const WirelessOptions& options) {
  const WirelessSettings settings = settings_of(options);
  try {
    const WirelessResult result = run_wireless(settings);
    if (options.json) process::write_text_file(*options.json, to_json(result, options.seed).dump(2) + "\n");
    if (!options.quiet) print_table(result);
    return result.client_code;
  } catch (const NoIsolation& error) {
    fmt::print(stderr, "gaitway: {}\n", error.what());
    return kExitNoIsolation;
  }
}

void add_direction(const CommandLine& command, const std::string& prefix, DirectionOptions& options) {
  command.option(prefix + "rate", options.rate, "Rate, like 5Mbit; without it unlimited");
  command.option(prefix + "queue", options.queue, "Bytes that wait for it, like 64KiB (the default)");
  command.option(prefix + "delay", options.delay, "One way, like 10ms");
  command.option(prefix + "jitter", options.jitter, "The delay differs by up to so much either way");
  command.option(prefix + "loss", options.loss, "Share of lost packets, like 3%");
  command
      .option(prefix + "burst", options.burst, "Mean number of packets lost in a row; without it independent")
      .between(1.0, 1e6);
  command.option(prefix + "fade", options.fade,
                 "Mean time in which all is lost, like 40ms, in place of a burst");
  command.option(prefix + "reorder", options.reorder, "Share of packets that later ones overtake");
  command.option(prefix + "reorder-by", options.reorder_by, "They come so much later (default 10ms)");
  command.option(prefix + "duplicate", options.duplicate, "Share of packets that are sent twice");
}

void declare_wireless(const CommandLine& program) {
  const CommandLine command = add_command(program, "wireless");
  WirelessOptions& options = command.runs(run_wireless_command);
  add_direction(command.group("The link, either way"), "--", options.both);
  add_direction(command.group("To the robot alone"), "--to-robot-", options.to_robot);
  add_direction(command.group("To the client alone"), "--to-client-", options.to_client);
  const CommandLine outages = command.group("Outages");
  outages.option("--outages", options.outages, "So many, drawn from the seed").between(0, 1e6);
  outages.option("--outage", options.outage, "So long each, like 0.3s..10s");
  outages.option("--up", options.up, "Time before and between them (default 1s..5s)");
  outages.repeated("--outage-at", options.outages_at, "One at an instant after the client's start: 2s+0.5s");
  outages.option("--outages-hold", options.outages_hold,
                 "Packets wait for an outage's end, instead of being lost");
  outages.option("--control", options.control, "FIFO to which others write lines like 'outage 0.5s'");
  outages.option("--outage-log", options.outage_log, "File for each beginning and end (CLOCK_MONOTONIC)");
  command.option("--seed", options.seed, "Seed of everything that is drawn");
  command.option("--robot", options.robot, "The robot's program, at 10.77.0.1, as a shell takes it");
  command.option("--robot-ready", options.robot_ready, "The client starts at a line of it that matches this");
  command.option("--robot-ready-within", options.ready_within, "And that must come in this time");
  command.option("--client", options.client,
                 "The client's program, at 10.77.0.2; or behind --, word by word");
  command.option("--json", options.json, "File for the statistics");
  command.option("--quiet", options.quiet, "No table at the end");
  command.footer(
      "Examples:\n"
      "  gaitway wireless --rate 5Mbit --delay 10ms --loss 3% --burst 8 \\\n"
      "    --robot 'python3 -m http.server' --client 'curl -sO http://10.77.0.1:8000/file'\n"
      "  gaitway wireless --outages 200 --outage 0.3s..10s --seed 1 --robot './robot' --robot-ready serves "
      "-- "
      "./client --fast\n"
      "Exit code: the client's; 77: no TUN or no namespaces here; 3: the robot did not become ready; 1: bad "
      "input.");
}

}  // namespace
}  // namespace gaitway::tools

int main(int argc, char** argv) {
  char** const dashes = std::find(argv, argv + argc, std::string_view("--"));
  if (dashes != argv + argc) gaitway::tools::client_words().assign(dashes + 1, argv + argc);
  *dashes = nullptr;
  return gaitway::tools::run_program(static_cast<int>(dashes - argv), argv, gaitway::tools::declare_wireless);
}
