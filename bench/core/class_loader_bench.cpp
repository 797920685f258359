// Loading, creating, destroying and unloading a plug-in, beside the same with ROS's class_loader.
#include <benchmark/benchmark.h>

#ifdef GAITWAY_CLASS_LOADER_PEER
#include <console_bridge/console.h>
#include <dlfcn.h>
#include <class_loader/class_loader.hpp>

#include <filesystem>
#include <string>

#include "direct_host.hpp"
#include "gaitway/instance/plugin_library.hpp"
#include "loading_peer.hpp"
#include "rivals.hpp"
#endif

namespace gaitway::core {
namespace {

#ifdef GAITWAY_CLASS_LOADER_PEER
constexpr const char* kPeerClass = "gaitway::bench::Relay";

// Nobody else may open the peer's library: class_loader would never close it again.
bool is_unloaded(benchmark::State& state) {
  if (void* const left = dlopen(GAITWAY_CLASS_LOADER_PEER, RTLD_LAZY | RTLD_NOLOAD)) {
    dlclose(left);
    state.SkipWithError("class_loader has left its library loaded: there is nothing to compare");
    return false;
  }
  return true;
}

void load_and_create(benchmark::State& state) {
  enum : std::size_t { kOurs, kPeer, kCopy, kWays };
  console_bridge::setLogLevel(console_bridge::CONSOLE_BRIDGE_LOG_NONE);
  const std::filesystem::path path(GAITWAY_LOADING_PLUGIN);
  const std::string name = path.filename().string();
  const SearchPath folders{path.parent_path()};
  Rivals rivals(kWays);
  for (auto iteration : state) {
    const std::int64_t begin_ns = steady_clock_ns();
    {
      const PluginLibrary library(name, {}, folders);
      DirectTopics topics;
      const DirectPlugin plugin(library.entry(), topics, "");
    }
    const std::int64_t ours_ns = steady_clock_ns() - begin_ns;
    rivals.add(kOurs, ours_ns);
    state.SetIterationTime(static_cast<double>(ours_ns) * 1e-9);
    rivals.time(kPeer, [] {
      class_loader::ClassLoader loader(GAITWAY_CLASS_LOADER_PEER);
      loader.createUniqueInstance<bench::LoadingPeer>(kPeerClass).reset();
      loader.unloadLibrary();
    });
    rivals.time(kCopy, [&path] { const LibraryCopy once(path); });
    if (!is_unloaded(state)) {
      break;
    }
  }
  const double ours = rivals.percentile_us(kOurs), peer = rivals.percentile_us(kPeer);
  const double copy = rivals.percentile_us(kCopy);
  state.counters["p50_us"] = ours;
  state.counters["copy_us"] = copy;
  state.counters["class_loader_us"] = peer;
  state.counters["ratio"] = (ours - copy) / peer;
  state.counters["ratio_with_copy"] = ours / peer;
  judge(state, ours - copy < peer, "without the copy faster than class_loader");
}

// From a library that stays loaded; many at once, since the clock is as slow as one.
void create_instance(benchmark::State& state) {
  enum : std::size_t { kOurs, kPeer, kWays };
  constexpr int kTogether = 50;
  console_bridge::setLogLevel(console_bridge::CONSOLE_BRIDGE_LOG_NONE);
  const PluginLibrary library(GAITWAY_LOADING_PLUGIN, {}, {});
  class_loader::ClassLoader loader(GAITWAY_CLASS_LOADER_PEER);
  DirectTopics topics;
  Rivals rivals(kWays);
  for (auto iteration : state) {
    const std::int64_t begin_ns = steady_clock_ns();
    for (int i = 0; i < kTogether; ++i) {
      const DirectPlugin plugin(library.entry(), topics, "");
    }
    const std::int64_t ours_ns = steady_clock_ns() - begin_ns;
    rivals.add(kOurs, ours_ns);
    state.SetIterationTime(static_cast<double>(ours_ns) * 1e-9);
    rivals.time(kPeer, [&loader] {
      for (int i = 0; i < kTogether; ++i) {
        loader.createUniqueInstance<bench::LoadingPeer>(kPeerClass).reset();
      }
    });
  }
  const double ours = rivals.percentile_us(kOurs) / kTogether, peer = rivals.percentile_us(kPeer) / kTogether;
  state.counters["p50_us"] = ours;
  state.counters["class_loader_us"] = peer;
  state.counters["ratio"] = ours / peer;
  judge(state, ours < peer, "faster than class_loader");
}
#else
void load_and_create(benchmark::State& state) {
  state.SkipWithError("class_loader was not there at configuration: apt-get install libclass-loader-dev");
}
void create_instance(benchmark::State& state) {
  load_and_create(state);
}
#endif
BENCHMARK(load_and_create)->UseManualTime()->Unit(benchmark::kMicrosecond);
BENCHMARK(create_instance)->UseManualTime()->Unit(benchmark::kMicrosecond)->Iterations(500);

}  // namespace
}  // namespace gaitway::core
