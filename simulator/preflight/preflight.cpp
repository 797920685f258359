// Many robots, over all processors.
#include "gaitway/preflight/preflight.hpp"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>

#include "flight_run.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/process/working_copy.hpp"
#include "gaitway/simulator/camera.hpp"

namespace gaitway::preflight {
namespace {

using nlohmann::json;

constexpr int kPictures = 8, kPictureWidth_px = 320, kPictureHeight_px = 360;

json to_json(const Trial& trial) {
  return {{"seed", trial.seed},
          {"fell", trial.fell},
          {"ended_s", trial.ended_s},
          {"largest_tilt_rad", trial.largest_tilt_rad},
          {"body_contacts", trial.body_contacts},
          {"first_contact", trial.first_contact},
          {"refused_batches", trial.refused_batches},
          {"refusal", trial.refusal}};
}

Trial trial_from(const json& told) {
  return {.seed = told.at("seed").get<std::uint64_t>(),
          .fell = told.at("fell").get<bool>(),
          .ended_s = told.at("ended_s").get<double>(),
          .largest_tilt_rad = told.at("largest_tilt_rad").get<double>(),
          .body_contacts = told.at("body_contacts").get<std::uint64_t>(),
          .first_contact = told.at("first_contact").get<std::string>(),
          .refused_batches = told.at("refused_batches").get<std::uint64_t>(),
          .refusal = told.at("refusal").get<std::string>()};
}

Trial fly_one(const urdf::RobotModel& robot, const Flight& flight, const PreflightOptions& options,
              std::uint64_t seed) {
  FlightRun run(robot, flight, options.robot, seed);
  while (run.goes_on()) run.advance_millisecond();
  return run.trial();
}

void check(const Flight& flight, const PreflightOptions& options) {
  if (options.robots < 1) throw std::invalid_argument("a pre-flight needs a robot: at least 1");
  if (!(flight.seconds > 0.0)) throw std::invalid_argument("a flight of no length: its seconds must be > 0");
}

// Which trial is worse: one that fell before one that did not, earlier before later.
bool is_worse(const Trial& a, const Trial& b) {
  if (a.fell != b.fell) return a.fell;
  if (a.fell) return a.ended_s < b.ended_s;
  if (a.refusal.empty() != b.refusal.empty()) return !a.refusal.empty();
  return a.largest_tilt_rad > b.largest_tilt_rad;
}

}  // namespace

int Verdict::passed() const noexcept {
  return static_cast<int>(std::ranges::count_if(trials, &Trial::passed));
}

const Trial& Verdict::worst() const {
  return *std::ranges::min_element(trials, is_worse);
}

Verdict fly(const urdf::RobotModel& robot, const Flight& flight, const PreflightOptions& options,
            const Progress& progress) {
  check(flight, options);
  const auto began = std::chrono::steady_clock::now();
  const int processors = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const int processes = std::min(options.processes > 0 ? options.processes : processors, options.robots);
  std::vector<process::WorkingCopy> copies;
  for (int i = 0; i < processes; ++i) {
    copies.emplace_back([&, i](const process::WorkingCopy::Tell& tell) {
      for (int seed = i + 1; seed <= options.robots; seed += processes) {
        tell(to_json(fly_one(robot, flight, options, static_cast<std::uint64_t>(seed))).dump());
      }
    });
  }
  Verdict verdict;
  while (std::ranges::any_of(copies, [](const auto& copy) { return !copy.done(); })) {
    std::vector<pollfd> wakes;
    for (const process::WorkingCopy& copy : copies) {
      wakes.push_back({copy.done() ? -1 : copy.descriptor(), POLLIN, 0});
    }
    poll(wakes.data(), wakes.size(), -1);
    for (std::size_t i = 0; i < copies.size(); ++i) {
      if (wakes[i].revents == 0) continue;
      for (const std::string& line : copies[i].listen())
        verdict.trials.push_back(trial_from(json::parse(line)));
      if (progress) progress(verdict.trials.size(), static_cast<std::size_t>(options.robots));
    }
  }
  std::ranges::sort(verdict.trials, {}, &Trial::seed);
  verdict.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return verdict;
}

void draw_trial(const std::filesystem::path& file, const urdf::RobotModel& robot, const Flight& flight,
                const PreflightOptions& options, const Trial& trial) {
  FlightRun run(robot, flight, options.robot, trial.seed);
  simulator::Camera camera(run.run().plant(), kPictureWidth_px, kPictureHeight_px);
  std::vector<simulator::Image> images;
  // Near a fall the last second is what one wants to see.
  const double from_s = trial.fell ? std::max(0.0, trial.ended_s - 1.4) : 0.0;
  const double every_s = (trial.ended_s - from_s) / (kPictures - 1);
  while (run.goes_on() && static_cast<int>(images.size()) < kPictures) {
    run.advance_millisecond();
    const double due_s = from_s + every_s * static_cast<double>(images.size());
    if (run.run().plant().time_s() >= due_s - 1e-9)
      images.push_back(camera.render(run.run().plant().positions()));
  }
  simulator::write_film_strip(file.string(), images, kPictures);
}

nlohmann::ordered_json verdict_json(const Verdict& verdict) {
  auto trials = nlohmann::json::array();
  for (const Trial& trial : verdict.trials) trials.push_back(to_json(trial));
  return {{"passed", verdict.passed()},
          {"robots", verdict.trials.size()},
          {"worst_seed", verdict.worst().seed},
          {"wall_s", verdict.wall_s},
          {"trials", trials}};
}

std::string verdict_text(const Verdict& verdict) {
  const Trial& worst = verdict.worst();
  std::string text = fmt::format("  {}  {} of {} simulated robots stayed up and did it ({:.1f} s)\n",
                                 verdict.all_passed() ? "passed    " : "NOT passed", verdict.passed(),
                                 verdict.trials.size(), verdict.wall_s);
  if (worst.fell) {
    text += fmt::format("  worst       robot {} fell after {:.2f} s\n", worst.seed, worst.ended_s);
  } else {
    text += fmt::format("  worst       robot {} leaned by {:.1f} deg at most\n", worst.seed,
                        worst.largest_tilt_rad / facts::kRadPerDegree);
  }
  for (const Trial& trial : verdict.trials) {
    if (trial.refusal.empty()) continue;
    text += fmt::format("  refused     robot {}: {}\n", trial.seed, trial.refusal);
    break;
  }
  const auto touched =
      std::ranges::count_if(verdict.trials, [](const Trial& one) { return one.body_contacts > 0; });
  if (touched > 0) {
    const auto first =
        std::ranges::find_if(verdict.trials, [](const Trial& one) { return one.body_contacts > 0; });
    text += fmt::format("  contacts    {} of them touched something, robot {} first of all: {}\n", touched,
                        first->seed, first->first_contact);
  }
  return text;
}

}  // namespace gaitway::preflight
