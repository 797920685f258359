// One part after the other; from the start again when the world has changed between two of them.
#include "simulation_geometry.hpp"

#include <exception>
#include <iterator>
#include <string>
#include <utility>

namespace gaitway::api {

void SimulationGeometry::want(const SimulationCall& call, const Version& version, Then then) {
  if (version_ == version) {
    return then(solids_);
  }
  waiting_.push_back({call, version, std::move(then)});
  if (!is_reading_) {
    is_reading_ = true;
    beginnings_ = 0;
    read_run_ = version.run;
    read_geometry_.reset();
    read_on();
  }
}

void SimulationGeometry::step(std::int64_t now_ns) {
  std::erase_if(waiting_, [&](const Waiting& one) {
    const bool late = now_ns >= one.call.ends_ns;
    if (late) {
      orders_.fail(one.call, "the simulator has not told its world within " + orders_.patience_of(one.call));
    }
    return late;
  });
}

void SimulationGeometry::forget(std::uint64_t client) {
  std::erase_if(waiting_, [client](const Waiting& one) { return one.call.call.client == client; });
}

void SimulationGeometry::read_on() {
  if (!read_geometry_) {
    read_.clear();
    ++beginnings_;
  }
  orders_.ask_for_nobody({{"order", "geometry"}, {"from", read_.size()}}, [this](const OrderResult* result) {
    if (result == nullptr || !result->done) {
      return fail(result == nullptr ? "the simulator has not told its world in time" : result->text);
    }
    try {
      take_part(read_answer<GeometryAnswer>(result->text));
    } catch (const std::exception& error) {
      fail(error.what());
    }
  });
}

void SimulationGeometry::take_part(const GeometryAnswer& part) {
  constexpr int kMostBeginnings = 5;
  if (part.total > kMostSolids) {
    return fail("the world has " + std::to_string(part.total) + " solids, but no more than " +
                std::to_string(kMostSolids) + " are read");
  }
  if (read_geometry_ && read_geometry_ != part.geometry) {
    if (beginnings_ >= kMostBeginnings) {
      return fail("the world changes while it is read: try again");
    }
    read_geometry_.reset();
    return read_on();
  }
  read_geometry_ = part.geometry;
  read_.insert(read_.end(), part.solids.begin(), part.solids.end());
  if (read_.size() >= part.total) {
    return finish();
  }
  if (part.solids.empty()) {
    return fail("the simulator tells " + std::to_string(read_.size()) + " solids of " +
                std::to_string(part.total));
  }
  read_on();
}

void SimulationGeometry::finish() {
  is_reading_ = false;
  version_ = {read_run_, *read_geometry_};
  solids_ = std::exchange(read_, {});
  for (const Waiting& one : std::exchange(waiting_, {})) {
    if (one.version.run != version_->run) {  // it came while those of another run were being read
      want(one.call, one.version, one.then);
      continue;
    }
    try {
      one.then(solids_);
    } catch (const std::exception& error) {
      orders_.fail(one.call, error.what());
    }
  }
}

void SimulationGeometry::fail(std::string_view why) {
  is_reading_ = false;
  read_.clear();
  for (const Waiting& one : std::exchange(waiting_, {})) {
    orders_.fail(one.call, why);
  }
}

}  // namespace gaitway::api
