// Who commands the robot and what its behaviour does: what is told of it, and when.
#pragma once

#include <cstdint>

#include "gaitway/api/publication_sink.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "latest.hpp"
#include "tree_structure.hpp"

namespace gaitway::api {

class CommandNews {
 public:
  // Throws msgclient::TopicError.
  explicit CommandNews(msgclient::Client& client);

  void publish(PublicationSink& sink, std::int64_t robot_ns);
  // The robot was started anew: what it tells next is news.
  void forget() noexcept;

 private:
  void publish_command(PublicationSink& sink, std::int64_t robot_ns);
  void publish_behaviour(PublicationSink& sink, std::int64_t robot_ns);
  void publish_nodes(PublicationSink& sink, std::int64_t robot_ns);

  Latest<gaitway::CommandState> command_;
  Latest<gaitway::BehaviourState> behaviour_;
  Latest<gaitway::BehaviourNodes> nodes_;
  gaitway::CommandState command_told_{};  // as of the last message, of which any_* says whether there was one
  gaitway::BehaviourState behaviour_told_{};
  bool any_command_told_ = false, any_behaviour_told_ = false;
  TreeStructure tree_;
};

}  // namespace gaitway::api
