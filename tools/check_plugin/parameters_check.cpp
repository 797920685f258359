// Check `parameters`: whatever a configuration says, the plug-in takes it or refuses it with a text.
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "tools/check_plugin/check_run.hpp"
#include "tools/check_plugin/topic_rules.hpp"

namespace gaitway::plugin_check {
namespace {

constexpr std::uint64_t kStepsPerValue = 32;  // four batches
constexpr int kMixtures = 24;
constexpr int kFullMixtures = 1000;
constexpr int kLiveChanges = 8;  // of each live parameter
constexpr const char* kRemedy =
    "give the parameter its range (ParameterLimits), or refuse the value in the constructor with a text";

struct Fuzzed {
  std::string parameter;
  std::string text;
};

std::string number_text(double number) {
  return fmt::format("{}", number);
}

std::vector<std::string> texts_of(const core::Parameter& parameter) {
  std::vector<std::string> texts{parameter.fallback, "", "nan", "1 parsec"};
  const bool integer = parameter.kind == core::ParameterKind::integer;
  if (parameter.kind == core::ParameterKind::flag) {
    return {"true", "false", "maybe", ""};
  }
  if (parameter.kind == core::ParameterKind::text) {
    return {parameter.fallback, "", "no such thing", std::string(5000, 'x'), "%s%n", "../../etc"};
  }
  for (const double bound : {parameter.lowest, parameter.highest}) {
    if (!std::isfinite(bound)) {
      continue;
    }
    const double outside = bound == parameter.lowest ? -1.0 : 1.0;
    const double beside =
        integer ? bound + outside : bound + outside * std::max(1e-9, 1e-9 * std::abs(bound));
    texts.push_back(integer ? fmt::format("{:.0f}", bound) : number_text(bound));
    texts.push_back(integer ? fmt::format("{:.0f}", beside) : number_text(beside));
  }
  if (integer) {
    for (const std::int64_t value :
         {std::int64_t{0}, std::int64_t{-1}, std::numeric_limits<std::int64_t>::min(),
          std::numeric_limits<std::int64_t>::max()}) {
      texts.push_back(fmt::format("{}", value));
    }
  } else {
    for (const char* const text : {"0", "-1", "1e300", "-1e300", "1e-300", "1e9"}) {
      texts.emplace_back(text);
    }
  }
  return texts;
}

class Fuzzer {
 public:
  Fuzzer(CheckRun& run, const SpecimenLibrary& library)
      : run_(run), library_(library), rules_(urdf::load_robot(run.job().robot)) {
    Specimen specimen(library, run.job(), &run.record());
    specimen.create();
    specimen.activate();
    const auto& declared = specimen.host().parameters().declared();
    parameters_.assign(declared.begin(), declared.end());
    finite_ = !first_non_finite(specimen, 0);
    specimen.abandon();
  }

  [[nodiscard]] const std::vector<core::Parameter>& parameters() const noexcept { return parameters_; }

  void try_job(const Job& job) {
    Specimen specimen(library_, job, &run_.record());
    if (!specimen.create()) {
      if (specimen.error().empty()) {
        run_.finding("is refused without a text", "", "write the reason into the error text");
      }
      ++refused_;
      return;
    }
    ++taken_;
    if (!specimen.activate()) {
      return;  // refused, only later
    }
    if (const auto number = first_non_finite(specimen, 0); number && finite_) {
      run_.finding(fmt::format("is taken, but then {}", *number), "", kRemedy);
    }
    specimen.deactivate();
  }

  // Changes of live parameters between steps, as the host would make them: within their ranges.
  void try_live(const core::Parameter& parameter, std::mt19937_64& random) {
    Specimen specimen(library_, run_.job(), &run_.record());
    specimen.create();
    specimen.activate();
    for (int change = 0; change < kLiveChanges; ++change) {
      const gaitway_value value = live_value(parameter, change, random);
      if (!specimen.set_parameter(parameter.name.c_str(), value)) {
        run_.finding(
            fmt::format("refuses a change to {} although it is declared live: {}",
                        value.kind == GAITWAY_NUMBER ? value.number : static_cast<double>(value.integer),
                        specimen.error()),
            "", "take every value in the declared range");
        break;
      }
      const auto number = first_non_finite(specimen, static_cast<std::uint64_t>(change + 1) * kStepsPerValue);
      if (number && finite_) {
        run_.finding(
            fmt::format("after a change to {}, {}",
                        value.kind == GAITWAY_NUMBER ? value.number : static_cast<double>(value.integer),
                        *number),
            "", kRemedy);
        break;
      }
    }
    specimen.deactivate();
  }
  [[nodiscard]] int taken() const noexcept { return taken_; }
  [[nodiscard]] int refused() const noexcept { return refused_; }

 private:
  std::optional<std::string> first_non_finite(Specimen& specimen, std::uint64_t from) {
    std::optional<std::string> found;
    for (std::uint64_t n = from; n < from + kStepsPerValue && !found; ++n) {
      specimen.step(run_.record(), n);
      for (const Port& port : specimen.host().ports()) {
        if (port.is_output() && port.published && !found) {
          found = rules_.non_finite(port);
        }
      }
    }
    return found;
  }

  static gaitway_value live_value(const core::Parameter& parameter, int change, std::mt19937_64& random) {
    const double lowest = std::isfinite(parameter.lowest) ? parameter.lowest : -1e6;
    const double highest = std::isfinite(parameter.highest) ? parameter.highest : 1e6;
    const double share = change == 0   ? 0.0
                         : change == 1 ? 1.0
                                       : static_cast<double>(random() >> 11U) * 0x1.0p-53;
    const double number = lowest + share * (highest - lowest);
    if (parameter.kind == core::ParameterKind::number) {
      return {GAITWAY_NUMBER, 0, number, 0, nullptr};
    }
    if (parameter.kind == core::ParameterKind::integer) {
      return {GAITWAY_INTEGER, 0, 0.0, static_cast<std::int64_t>(number), nullptr};
    }
    return {GAITWAY_FLAG, 0, 0.0, change % 2, nullptr};
  }

  CheckRun& run_;
  const SpecimenLibrary& library_;
  OutputRules rules_;
  std::vector<core::Parameter> parameters_;
  bool finite_ = true;  // with the given parameters
  int taken_ = 0;
  int refused_ = 0;
};

std::string short_text(const std::string& text) {
  return text.size() > 40 ? text.substr(0, 40) + "..." : text;
}

void try_mixtures(CheckRun& run, Fuzzer& fuzzer, std::mt19937_64& random) {
  const int count = fuzzer.parameters().empty() ? 0 : run.job().full ? kFullMixtures : kMixtures;
  for (int i = 0; i < count; ++i) {
    Job job = run.job();
    std::string name = "mixture";
    for (int changed = 0; changed < 3; ++changed) {
      const core::Parameter& parameter = fuzzer.parameters()[random() % fuzzer.parameters().size()];
      const std::vector<std::string> texts = texts_of(parameter);
      const std::string& text = texts[random() % texts.size()];
      job = with_parameter(job, parameter.name, text);
      name += fmt::format(" {}='{}'", parameter.name, short_text(text));
    }
    if (run.begin(name)) {
      fuzzer.try_job(job);
    }
  }
}

}  // namespace

void check_parameters(CheckRun& run) {
  const SpecimenLibrary library(run.job().plugin, run.board());
  Fuzzer fuzzer(run, library);
  std::mt19937_64 random(run.job().seed);
  for (const core::Parameter& parameter : fuzzer.parameters()) {
    for (const std::string& text : texts_of(parameter)) {
      if (run.begin(fmt::format("{} = '{}'", parameter.name, short_text(text)))) {
        fuzzer.try_job(with_parameter(run.job(), parameter.name, text));
      }
    }
    if (parameter.live && run.begin(fmt::format("live changes of {}", parameter.name))) {
      fuzzer.try_live(parameter, random);
    }
  }
  try_mixtures(run, fuzzer, random);
  run.remark(fmt::format("{} values taken, {} refused", fuzzer.taken(), fuzzer.refused()));
}

}  // namespace gaitway::plugin_check
