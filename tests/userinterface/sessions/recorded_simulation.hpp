// A simulator that writes down what it is asked: it answers pushes when the test says so, and orders at once,
// as the test has them.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "gaitway/api/simulation_port.hpp"

namespace gaitway::api {

class RecordedSimulation final : public SimulationPort {
 public:
  std::vector<LinkPush> pushes;
  std::deque<OrderResult> results;
  std::string refusal;  // of the next pushes, as of wrong arguments

  std::vector<nlohmann::json> orders;  // but for those of the states, which come by the clock, too
  std::vector<std::int64_t> patiences_ns;
  int state_orders = 0, twin_orders = 0;
  std::optional<nlohmann::json> twin_state;     // the answer to the order `twin`; nothing: there is none
  bool takes_orders = true;                     // false: as `gaitway serve`
  bool is_silent = false;                       // answers no order
  std::map<std::string, std::string> refusals;  // of orders by their names: why
  nlohmann::json state = {{"time_s", 2.5},
                          {"recorded_s", 4.0},
                          {"state", "paused"},
                          {"text", ""},
                          {"speed", 2.0},
                          {"pace", 0.98},
                          {"world", "boxes"},
                          {"geometry", 3},
                          {"run", 1},
                          {"fallen", false},
                          {"odometry", {1.0, 2.0, 0.0, 0.5}},
                          {"base", {0.1, 0.2, 0.3, 0.0, 0.0, 0.0, 1.0}},
                          {"things", {{{"name", "ball"}, {"pose", {3.0, 0.0, 0.1, 0.0, 0.0, 0.0, 1.0}}}}},
                          {"spawned", {"crate"}},
                          {"events", {{{"at_s", 1.0}, {"text", "{push: {body: trunk}}"}}}},
                          {"marks", {{{"at_s", 1.0}, {"kind", "push"}}}}};
  std::vector<nlohmann::json> solids = {solid("table", "box", "box", {1.0, 1.0, 0.05}, false),
                                        solid("ball", "thing", "sphere", {0.1, 0.0, 0.05}, true),
                                        solid("crate", "box", "cylinder", {2.0, -1.0, 0.05}, false)};
  std::size_t solids_an_answer = 200;

  [[nodiscard]] static nlohmann::json solid(const std::string& name, const std::string& kind,
                                            const std::string& shape, std::array<double, 3> place_m,
                                            bool movable) {
    return {{"name", name},
            {"kind", kind},
            {"shape", shape},
            {"size", {0.1, 0.1, 0.1}},
            {"pose", {place_m[0], place_m[1], place_m[2], 0.0, 0.0, 0.0, 1.0}},
            {"colour", {0.5, 0.25, 1.0}},
            {"movable", movable}};
  }

  std::uint32_t push(const LinkPush& push) override {
    if (!refusal.empty()) {
      throw std::invalid_argument(refusal);
    }
    pushes.push_back(push);
    return last_push_ = ++last_number_;
  }
  std::uint32_t order(const std::string& text, std::int64_t patience_ns) override {
    const auto order = nlohmann::json::parse(text);
    const std::string name = order.at("order");
    if (name == "state") {
      ++state_orders;
    } else if (name == "twin") {
      ++twin_orders;
    } else {
      orders.push_back(order);
      patiences_ns.push_back(patience_ns);
    }
    ++last_number_;
    if (!takes_orders) {
      results.push_back({last_number_, false, "this simulator takes pushes alone"});
    } else if (name == "twin" && !twin_state) {
      results.push_back({last_number_, false, "order is 'twin'"});
    } else if (refusals.contains(name)) {
      results.push_back({last_number_, false, refusals.at(name)});
    } else if (!is_silent) {
      results.push_back({last_number_, true, answer_to(name, order).dump()});
    }
    return last_number_;
  }
  std::optional<OrderResult> take_result() override {
    if (results.empty()) {
      return std::nullopt;
    }
    OrderResult result = results.front();
    results.pop_front();
    return result;
  }
  // Of the last push.
  void finish(bool done, std::string text) { results.push_back({last_push_, done, std::move(text)}); }

 private:
  [[nodiscard]] nlohmann::json answer_to(const std::string& name, const nlohmann::json& order) const {
    if (name == "state") {
      return state;
    }
    if (name == "twin") {
      return *twin_state;
    }
    if (name == "twin_picture") {
      return {{"total", 5}, {"data", "aGVsbG8="}};
    }
    if (name == "geometry") {
      return geometry_from(order.at("from"));
    }
    if (name == "seek" || name == "step") {
      return {{"time_s", 1.25}};
    }
    if (name == "plan") {
      return {
          {"steps", {{{"side", 0}, {"pose", {0.1, 0.04, 0.0}}}, {{"side", 1}, {"pose", {0.2, -0.04, 0.1}}}}},
          {"feet", {{0.0, 0.04, 0.0}, {0.0, -0.04, 0.0}}},
          {"seconds", 3.5}};
    }
    return nlohmann::json::object();
  }
  [[nodiscard]] nlohmann::json geometry_from(std::size_t from) const {
    auto part = nlohmann::json::array();
    for (std::size_t i = from; i < solids.size() && part.size() < solids_an_answer; ++i) {
      part.push_back(solids[i]);
    }
    return {{"geometry", state.at("geometry")}, {"world", state.at("world")}, {"total", solids.size()},
            {"floor_colour", {0.5, 0.5, 0.5}},  {"start", {0.0, 0.0, 0.0}},   {"solids", part}};
  }

  std::uint32_t last_number_ = 0, last_push_ = 0;
};

}  // namespace gaitway::api
