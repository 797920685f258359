// What loading a plug-in costs, and its share over the loader's own work, dlopen and dlsym.
#include <benchmark/benchmark.h>
#include <dlfcn.h>

#include <filesystem>
#include <stdexcept>
#include <string>

#include "gaitway/instance/plugin_library.hpp"
#include "rivals.hpp"

namespace gaitway::core {
namespace {

constexpr double kMostOfBare = 1.5;

void load_bare(const char* file) {
  void* const handle = dlopen(file, RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    throw std::runtime_error(dlerror());
  }
  benchmark::DoNotOptimize(dlsym(handle, "gaitway_plugin_entry"));
  dlclose(handle);
}

// Each turn loads and unloads the same file in every way; the time that is shown is that of the first.
void load_library(benchmark::State& state, const char* file) {
  enum : std::size_t { kWhole, kCopy, kBare, kBareOfCopy, kWays };
  const std::filesystem::path path(file);
  const SearchPath folders{path.parent_path()};
  const std::string name = path.filename().string();
  const LibraryCopy kept(path);
  const std::string copy = kept.path();
  Rivals rivals(kWays);
  std::size_t first = 0;
  for (auto iteration : state) {
    const std::int64_t begin_ns = steady_clock_ns();
    { const PluginLibrary library(name, {}, folders); }
    const std::int64_t whole_ns = steady_clock_ns() - begin_ns;
    rivals.add(kWhole, whole_ns);
    state.SetIterationTime(static_cast<double>(whole_ns) * 1e-9);
    for (std::size_t i = 0; i < 3; ++i) {
      switch (kCopy + (first + i) % 3) {
        case kCopy:
          rivals.time(kCopy, [&] { const LibraryCopy once(path); });
          break;
        case kBare:
          rivals.time(kBare, [&] { load_bare(file); });
          break;
        default:
          rivals.time(kBareOfCopy, [&] { load_bare(copy.c_str()); });
      }
    }
    ++first;
  }
  const double whole = rivals.percentile_us(kWhole), bare = rivals.percentile_us(kBare);
  const double ratio = (whole - rivals.percentile_us(kCopy)) / bare;
  state.counters["p50_us"] = whole;
  state.counters["copy_us"] = rivals.percentile_us(kCopy);
  state.counters["bare_us"] = bare;
  state.counters["bare_of_copy_us"] = rivals.percentile_us(kBareOfCopy);
  state.counters["ratio"] = ratio;
  state.counters["ratio_with_copy"] = whole / bare;
  judge(state, ratio <= kMostOfBare, "without the copy at most 1.5 x dlopen and dlsym of the same file");
}
BENCHMARK_CAPTURE(load_library, relay, GAITWAY_RELAY)->UseManualTime()->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(load_library, stability, GAITWAY_STABILITY)->UseManualTime()->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace gaitway::core
