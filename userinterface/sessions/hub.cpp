#include "gaitway/api/hub.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "client_session.hpp"

namespace gaitway::api {

HubState::HubState(RobotPort& port, HubOptions hub_options)
    : robot(port),
      options(std::move(hub_options)),
      commands(port, options.limits),
      topics(options.limits),
      services(
          options.limits, [this](const ServiceCall& call, Frame frame) { answer(call, std::move(frame)); },
          [this](std::uint64_t provider, Frame frame) {
            const auto session = sessions.find(provider);
            return session != sessions.end() && session->second->take_call(std::move(frame));
          }),
      desk(port, options.simulation, commands, options.limits, options.parameters, {topics, services},
           [this](const ServiceCall& call, Frame frame) { answer(call, std::move(frame)); }) {}

void HubState::answer(const ServiceCall& call, Frame frame) {
  if (const auto session = sessions.find(call.client); session != sessions.end()) {
    session->second->answer(call, std::move(frame));
  }
}

void HubState::keep_within_budget() {
  while (waiting_bytes > options.limits.waiting_bytes_of_all) {
    std::ranges::max_element(sessions, [](const auto& a, const auto& b) {
      return a.second->waiting_bytes() < b.second->waiting_bytes();
    })->second->cut();
  }
}

Hub::Hub(RobotPort& robot, HubOptions options)
    : state_(std::make_unique<HubState>(robot, std::move(options))) {}

Hub::~Hub() = default;

std::unique_ptr<Session> Hub::open(Connection& connection, std::string peer, bool authorised,
                                   std::int64_t wall_ns) {
  state_->now_ns = wall_ns;
  if (state_->sessions.size() >= state_->options.limits.connections) {
    return nullptr;
  }
  Claimant claimant;
  claimant.number = ++state_->last_number;
  claimant.name = std::move(peer);
  state_->commands.authority().see_all(claimant);
  return std::make_unique<ClientSession>(*state_, connection, std::move(claimant), authorised);
}

void Hub::step(std::int64_t wall_ns) {
  answer(wall_ns);
  state_->commands.step(wall_ns);
  for (const auto& [number, session] : state_->sessions) {
    session->step(wall_ns);
  }
}

void Hub::robot_lost() {
  state_->commands.robot_lost();
  state_->desk.robot_lost();
}

void Hub::stopped_by_datagram() {
  state_->commands.stopped_by_datagram();
}

void Hub::answer(std::int64_t wall_ns) {
  state_->now_ns = wall_ns;
  state_->desk.step(wall_ns);
  state_->services.step(wall_ns);
  state_->keep_within_budget();
}

std::optional<ros::SimulationState> Hub::take_simulation_state() {
  return state_->desk.take_simulation_state();
}

std::optional<ros::TwinState> Hub::take_twin_state() {
  return state_->desk.take_twin_state();
}

std::optional<Velocity> Hub::take_walk_command() {
  return state_->commands.take_told_velocity();
}

bool Hub::wanted(Topic topic) const noexcept {
  return state_->publications.wanted(topic);
}

HubStatistics Hub::statistics() const {
  HubStatistics statistics = state_->counts;
  statistics.clients = state_->sessions.size();
  for (const auto& [number, session] : state_->sessions) {
    statistics.subscriptions += session->subscriptions();
  }
  statistics.waiting_bytes = state_->waiting_bytes;
  statistics.commander = commander();
  return statistics;
}

std::string_view Hub::commander() const noexcept {
  return state_->commands.authority().holder();
}

void Hub::require_type(Topic topic, std::string_view type) {
  if (row(topic).type != type) {
    throw std::logic_error("a message of " + std::string(type) + " for the topic " +
                           std::string(row(topic).name) + ", which is of " + std::string(row(topic).type));
  }
}

std::int64_t Hub::robot_ns() const {
  return state_->robot.now_ns();
}

void Hub::publish_encoded(Topic topic, const Encode& encode) {
  state_->publications.publish(topic, encode);
  state_->keep_within_budget();
}

}  // namespace gaitway::api
