// Which member answers which service, and what each asks of the simulator.
#include "simulation_services.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "client_message.hpp"
#include "gaitway/api/simulation_types.hpp"

namespace gaitway::api {

using nlohmann::json;
using ros::simulation::Result;
using StateNumber = ros::simulation::SimulationState;

namespace {

void require_between(const char* field, double value, double least, double most, const char* unit) {
  if (!(value >= least && value <= most)) {
    throw Refused(std::string(field) + " is " + shown_json(json(value)) + ", but must be from " +
                  shown_json(json(least)) + " to " + shown_json(json(most)) + unit);
  }
}

// Stopped is paused with nothing behind it: nothing can be told apart there.
std::uint8_t state_number_of(const StateAnswer& state) {
  if (state.state == "playing") {
    return StateNumber::STATE_PLAYING;
  }
  return state.time_s == 0.0 && state.recorded_s == 0.0 ? StateNumber::STATE_STOPPED
                                                        : StateNumber::STATE_PAUSED;
}

}  // namespace

struct SimulationServices::Answers {
  using Answer = void (SimulationServices::*)(const SimulationCall& call, const Arguments& arguments);
  struct Row {
    std::string_view name;
    Answer answer;
  };
  [[nodiscard]] static constexpr auto all();
};

constexpr auto SimulationServices::Answers::all() {
  using namespace ros::simulation;
  using S = SimulationServices;
  using E = EntityServices;
  return std::to_array<Row>({
      {"/simulation/push", &S::push},
      {"/simulation/set_speed", &S::set_speed},
      {"/simulation/seek", &S::seek},
      {"/simulation/apply", &S::apply},
      {"/simulation/plan", &S::plan},
      {"/simulation/geometry", &S::tell_geometry},
      {"/simulation/twin/follow", &S::of_twin<ros::SetBool, &TwinServices::follow>},
      {"/simulation/twin/send", &S::of_twin<ros::SendToRobot, &TwinServices::send>},
      {"/simulation/twin/stop", &S::of_twin<ros::Trigger, &TwinServices::stop>},
      {"/simulation/twin/reconnect", &S::of_twin<ros::Trigger, &TwinServices::reconnect>},
      {"/simulation/twin/picture", &S::of_twin<ros::GetPicture, &TwinServices::tell_picture>},
      {"/simulation/get_simulator_features", &S::tell_features},
      {"/simulation/get_simulation_state", &S::tell_state},
      {"/simulation/set_simulation_state", &S::set_state},
      {"/simulation/step_simulation", &S::step_simulation},
      {"/simulation/reset_simulation", &S::reset},
      {"/simulation/spawn_entity", &S::of_entities<SpawnEntity, &E::spawn>},
      {"/simulation/delete_entity", &S::of_entities<DeleteEntity, &E::remove>},
      {"/simulation/get_entities", &S::of_entities<GetEntities, &E::list>},
      {"/simulation/get_entity_state", &S::of_entities<GetEntityState, &E::tell_state>},
      {"/simulation/set_entity_state", &S::of_entities<SetEntityState, &E::set_state>},
      {"/simulation/get_entities_states", &S::of_entities<GetEntitiesStates, &E::list_states>},
      {"/simulation/get_entity_info", &S::of_entities<GetEntityInfo, &E::tell_info>},
      {"/simulation/get_spawnables", &S::tell_spawnables},
      {"/simulation/get_current_world", &S::tell_world},
  });
}

void SimulationServices::call(const ServiceRow& row, const ServiceCall& call, const Arguments& arguments,
                              std::int64_t now_ns) {
  static constexpr auto kAnswers = Answers::all();
  static_assert(std::ranges::all_of(kServices, [](const ServiceRow& one) {
    return !one.of_simulation || std::ranges::count(kAnswers, one.name, &Answers::Row::name) == 1;
  }));
  const auto found = std::ranges::find(kAnswers, row.name, &Answers::Row::name);
  (this->*found->answer)(orders_.begin(call, now_ns), arguments);
}

void SimulationServices::refuse_twin(const SimulationCall& call) const {
  orders_.reply(call, ros::Trigger::Response{
                          false,
                          "this simulation is the twin of no robot: start it with the robot's address, "
                          "`gaitway simulator --robot ws://HOST:PORT`"});
}

void SimulationServices::take_state(const std::string& answer) {
  orders_.states().take(read_answer<StateAnswer>(answer));
  news_ = message_of(*orders_.states().newest());
}

template <class S>
void SimulationServices::ask(const SimulationCall& call, const json& order, std::int64_t patience_ns,
                             std::function<typename S::Response(const std::string&)> response_of_answer) {
  orders_.ask(call, order, patience_ns,
              [this, call, response_of_answer = std::move(response_of_answer)](const OrderResult& result) {
                if (result.done) {
                  return orders_.reply(call, response_of_answer(result.text));
                }
                typename S::Response refused;
                refused.message = result.text;
                orders_.reply(call, refused);
              });
}

template <class S>
void SimulationServices::conclude(const SimulationCall& call, std::uint8_t code, std::string text) const {
  typename S::Response response;
  response.result = {code, std::move(text)};
  orders_.reply(call, response);
}

template <class S>
SimulationOrders::Then SimulationServices::conclude_refused(const SimulationCall& call) const {
  return [this, call](const OrderResult& refused) {
    conclude<S>(call, Result::RESULT_OPERATION_FAILED, refused.text);
  };
}

void SimulationServices::push(const SimulationCall& call, const Arguments& arguments) {
  const auto asked = request_of<ros::PushLink::Request>(arguments);
  const bool along_heading = asked.frame == "heading";
  if (!along_heading && asked.frame != "world" && !asked.frame.empty()) {
    throw Refused("frame is " + shown(asked.frame) + ", but must be \"world\" or \"heading\"");
  }
  orders_.push(call,
               {.link = asked.link,
                .force_N = {asked.force.x, asked.force.y, asked.force.z},
                .along_heading = along_heading,
                .duration_s = asked.duration},
               [this, call](const OrderResult& result) {
                 orders_.reply(call, ros::PushLink::Response{result.done,
                                                             result.done ? "the push begins" : result.text});
               });
}

void SimulationServices::set_speed(const SimulationCall& call, const Arguments& arguments) {
  constexpr double kSlowest = 0.1, kFastest = 40.0;
  const auto asked = request_of<ros::SetSpeed::Request>(arguments);
  require_between("speed", asked.speed, kSlowest, kFastest, " times real time");
  ask<ros::SetSpeed>(call, {{"order", "speed"}, {"times", asked.speed}}, SimulationOrders::kPatience_ns,
                     [](const std::string&) {
                       return ros::SetSpeed::Response{true, ""};
                     });
}

void SimulationServices::seek(const SimulationCall& call, const Arguments& arguments) {
  constexpr double kLatest_s = 1e7;
  const auto asked = request_of<ros::SeekTime::Request>(arguments);
  require_between("time", asked.time, 0.0, kLatest_s, " s");
  ask<ros::SeekTime>(call, {{"order", "seek"}, {"time_s", asked.time}}, SimulationOrders::kLongPatience_ns,
                     [](const std::string& answer) {
                       return ros::SeekTime::Response{true, "", read_answer<TimeAnswer>(answer).time_s};
                     });
}

void SimulationServices::apply(const SimulationCall& call, const Arguments& arguments) {
  constexpr std::size_t kMostEventBytes = 3000;
  const auto asked = request_of<ros::ApplyEvent::Request>(arguments);
  if (asked.event.empty() || asked.event.size() > kMostEventBytes) {
    throw Refused("event has " + std::to_string(asked.event.size()) +
                  " bytes, but must be an event of a scenario of 1 to " + std::to_string(kMostEventBytes));
  }
  ask<ros::ApplyEvent>(call, {{"order", "apply"}, {"event", asked.event}}, SimulationOrders::kPatience_ns,
                       [this](const std::string&) {
                         orders_.states().forget_motion();
                         return ros::ApplyEvent::Response{true, ""};
                       });
}

void SimulationServices::plan(const SimulationCall& call, const Arguments& arguments) {
  constexpr double kFarthest_m = 1000.0, kMostTurn_rad = 100.0;
  const auto asked = request_of<ros::PlanFootsteps::Request>(arguments);
  require_between("x", asked.x, -kFarthest_m, kFarthest_m, " m");
  require_between("y", asked.y, -kFarthest_m, kFarthest_m, " m");
  require_between("yaw", asked.yaw, -kMostTurn_rad, kMostTurn_rad, " rad");
  ask<ros::PlanFootsteps>(
      call, {{"order", "plan"}, {"goal", {asked.x, asked.y, asked.yaw}}}, SimulationOrders::kLongPatience_ns,
      [](const std::string& answer) { return response_of(read_answer<PlanAnswer>(answer)); });
}

void SimulationServices::tell_geometry(const SimulationCall& call, const Arguments& arguments) {
  const auto asked = request_of<ros::GetGeometry::Request>(arguments);
  ask<ros::GetGeometry>(
      call, {{"order", "geometry"}, {"from", asked.first}}, SimulationOrders::kPatience_ns,
      [](const std::string& answer) { return response_of(read_answer<GeometryAnswer>(answer)); });
}

void SimulationServices::tell_features(const SimulationCall& call, const Arguments& arguments) {
  using S = ros::simulation::GetSimulatorFeatures;
  static_cast<void>(request_of<S::Request>(arguments));
  orders_.ask_state(
      call,
      [this, call](const StateAnswer&) {
        using F = ros::simulation::SimulatorFeatures;
        S::Response response;
        response.features = {
            {F::SPAWNING, F::DELETING, F::ENTITY_TAGS, F::ENTITY_CATEGORIES, F::ENTITY_STATE_GETTING,
             F::ENTITY_STATE_SETTING, F::ENTITY_INFO_GETTING, F::SPAWNABLES, F::SIMULATION_RESET,
             F::SIMULATION_STATE_GETTING, F::SIMULATION_STATE_SETTING, F::SIMULATION_STATE_PAUSE,
             F::STEP_SIMULATION_SINGLE, F::STEP_SIMULATION_MULTIPLE, F::WORLD_INFO_GETTING},
            {"gaitway"},
            "a step is one millisecond; a reset is of everything; entities are filtered by spheres, in which "
            "the robot counts as the origin of its base; poses that are set are upright; docs/api.md has "
            "more"};
        orders_.reply(call, response);
      },
      [this, call](const OrderResult& refused) {
        S::Response response;
        response.features.custom_info = refused.text;
        orders_.reply(call, response);
      });
}

void SimulationServices::tell_state(const SimulationCall& call, const Arguments& arguments) {
  using S = ros::simulation::GetSimulationState;
  static_cast<void>(request_of<S::Request>(arguments));
  orders_.ask_state(
      call,
      [this, call](const StateAnswer& state) {
        S::Response response;
        response.state.state = state_number_of(state);
        response.result = {state.state == "failed" ? Result::RESULT_OPERATION_FAILED : Result::RESULT_OK,
                           state.text};
        orders_.reply(call, response);
      },
      conclude_refused<S>(call));
}

void SimulationServices::set_state(const SimulationCall& call, const Arguments& arguments) {
  using S = ros::simulation::SetSimulationState;
  const std::uint8_t target = request_of<S::Request>(arguments).state.state;
  if (target > StateNumber::STATE_PAUSED) {
    return conclude<S>(
        call, Result::RESULT_FEATURE_UNSUPPORTED,
        "state.state is " + std::to_string(target) +
            ", but must be 0 (stopped), 1 (playing) or 2 (paused): the simulator is ended, and "
            "given another world, by who started it");
  }
  orders_.ask_state(
      call, [this, call, target](const StateAnswer& state) { change_state(call, target, state); },
      conclude_refused<S>(call));
}

void SimulationServices::change_state(const SimulationCall& call, std::uint8_t target,
                                      const StateAnswer& from) {
  using S = ros::simulation::SetSimulationState;
  using Codes = ros::simulation::Transition;
  const std::uint8_t now = state_number_of(from);
  if (from.state == "busy") {
    return conclude<S>(call, Result::RESULT_INCORRECT_STATE, "the simulation is busy: " + from.text);
  }
  if (from.state == "failed" && target != StateNumber::STATE_STOPPED) {
    return conclude<S>(call, Codes::STATE_TRANSITION_ERROR,
                       "the simulation has failed, and can only be stopped, which resets it: " + from.text);
  }
  if (now == target && from.state != "failed") {
    return conclude<S>(call, Codes::ALREADY_IN_TARGET_STATE, "the simulation is in that state already");
  }
  if (now == StateNumber::STATE_STOPPED && target == StateNumber::STATE_PAUSED) {
    return conclude<S>(call, Codes::INCORRECT_TRANSITION,
                       "the simulation is stopped, which is paused with nothing simulated: step it, or play");
  }
  switch (target) {
    case StateNumber::STATE_PLAYING:
      return carry_out(call, {{{"order", "play"}}});
    case StateNumber::STATE_PAUSED:
      return carry_out(call, {{{"order", "pause"}}});
    default:
      return carry_out(call, {{{"order", "pause"}}, {{"order", "reset"}}});
  }
}

void SimulationServices::carry_out(const SimulationCall& call, std::vector<json> orders) {
  using S = ros::simulation::SetSimulationState;
  if (orders.empty()) {
    return conclude<S>(call, Result::RESULT_OK, "");
  }
  const json first = orders.front();
  orders.erase(orders.begin());
  orders_.ask(call, first, SimulationOrders::kLongPatience_ns,
              [this, call, orders = std::move(orders)](const OrderResult& result) {
                if (!result.done) {
                  return conclude<S>(call, ros::simulation::Transition::STATE_TRANSITION_ERROR, result.text);
                }
                carry_out(call, orders);
              });
}

void SimulationServices::step_simulation(const SimulationCall& call, const Arguments& arguments) {
  using S = ros::simulation::StepSimulation;
  constexpr std::uint64_t kMostSteps = 10'000;
  const auto asked = request_of<S::Request>(arguments);
  if (asked.steps < 1 || asked.steps > kMostSteps) {
    return conclude<S>(call, Result::RESULT_OPERATION_FAILED,
                       "steps is " + std::to_string(asked.steps) + ", but must be from 1 to " +
                           std::to_string(kMostSteps) + ", a millisecond each");
  }
  orders_.ask_state(
      call,
      [this, call, asked](const StateAnswer& state) {
        if (state.state != "paused") {
          return conclude<S>(call, Result::RESULT_OPERATION_FAILED,
                             "the simulation is " + shown(state.state) +
                                 ", but must be paused: call /simulation/set_simulation_state first");
        }
        orders_.ask(call, {{"order", "step"}, {"milliseconds", asked.steps}},
                    SimulationOrders::kLongPatience_ns, [this, call](const OrderResult& result) {
                      conclude<S>(call, result.done ? Result::RESULT_OK : Result::RESULT_OPERATION_FAILED,
                                  result.done ? "" : result.text);
                    });
      },
      conclude_refused<S>(call));
}

void SimulationServices::reset(const SimulationCall& call, const Arguments& arguments) {
  using S = ros::simulation::ResetSimulation;
  using Scope = ros::simulation::ResetScope;
  constexpr unsigned kEverything = Scope::SCOPE_TIME | Scope::SCOPE_STATE | Scope::SCOPE_SPAWNED;
  const auto asked = request_of<S::Request>(arguments);
  if (asked.scope != Scope::SCOPE_DEFAULT && (asked.scope & kEverything) != kEverything) {
    return conclude<S>(call, Result::RESULT_FEATURE_UNSUPPORTED,
                       "scope is " + std::to_string(asked.scope) +
                           ", but must be 0 or 255: time, state and what was spawned are reset together");
  }
  orders_.ask(call, {{"order", "reset"}}, SimulationOrders::kLongPatience_ns,
              [this, call](const OrderResult& result) {
                conclude<S>(call, result.done ? Result::RESULT_OK : Result::RESULT_OPERATION_FAILED,
                            result.done ? "" : result.text);
              });
}

void SimulationServices::tell_spawnables(const SimulationCall& call, const Arguments& arguments) {
  using S = ros::simulation::GetSpawnables;
  const auto asked = request_of<S::Request>(arguments);
  S::Response response;
  response.result.result = Result::RESULT_OK;
  for (const std::string& source : asked.sources) {
    response.result.error_message +=
        (response.result.error_message.empty() ? "no sources are looked at: " : ", ") + shown(source);
  }
  response.spawnables = spawnables();
  orders_.reply(call, response);
}

void SimulationServices::tell_world(const SimulationCall& call, const Arguments& arguments) {
  using S = ros::simulation::GetCurrentWorld;
  static_cast<void>(request_of<S::Request>(arguments));
  orders_.ask_state(
      call,
      [this, call](const StateAnswer& state) {
        S::Response response;
        response.result.result = Result::RESULT_OK;
        response.world = {state.world, {state.world, ""}, "", {}};
        orders_.reply(call, response);
      },
      conclude_refused<S>(call));
}

}  // namespace gaitway::api
