// Who commands the robot, and what its behaviour does, as the API tells it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gaitway/api/ros_messages.hpp"

namespace gaitway::api::ros {

// Who commands the robot, and why; and whose order walk, way, motion and head follow.
struct CommandState {
  Header header;
  std::string commander;  // "nobody", "behaviour", "person" or "emergency_stop"
  std::string reason;     // in a word: "person_stops"
  std::string text;       // the same for people
  Time since;             // when the two began, by the robot's clock
  std::string walk;       // whose order it follows: "nobody", "behaviour" or "person"
  std::string way;        // likewise
  std::string motion;     // likewise
  std::string head;       // likewise
  bool may_get_up =
      false;  // the behaviour's motions are obeyed, since the robot fell under a person's command
  std::uint32_t changes = 0;      // of commander or reason, since the robot's start
  std::uint32_t turned_away = 0;  // orders of the behaviour that came while it did not command, since then
  GAITWAY_ROS_MESSAGE("gaitway_msgs/msg/CommandState", header, commander, reason, text, since, walk, way,
                      motion, head, may_get_up, changes, turned_away);
};

// The behaviour tree after a tick.
struct BehaviourState {
  enum Status : std::int8_t { IDLE = 0, RUNNING = 1, SUCCESS = 2, FAILURE = 3, SKIPPED = 4 };  // of a node
  Header header;
  std::string mission;              // name of the tree; empty: there is none
  std::string state;                // "none", "runs", "halts", "succeeded", "failed" or "waits"
  std::string text;                 // of the last answer, or what the tree said last
  std::uint32_t revision = 0;       // counts trees: the nodes are those of /behaviour/nodes of this number
  std::uint32_t node_count = 0;     // of the tree
  std::uint64_t ticks = 0;          // of this tree
  std::vector<std::int8_t> status;  // of each node, the first 1024 of them
  // The newest that nodes went through, oldest first: when [s, the robot's clock], which, and to what. The
  // last one is number `transitions`, counted since the robot's start.
  std::uint64_t transitions = 0;
  std::vector<double> transition_time;
  std::vector<std::uint32_t> transition_node;
  std::vector<std::int8_t> transition_to;
  GAITWAY_CONSTANTS(int8, IDLE, RUNNING, SUCCESS, FAILURE, SKIPPED);
  GAITWAY_ROS_MESSAGE("gaitway_msgs/msg/BehaviourState", header, mission, state, text, revision, node_count,
                      ticks, status, transitions, transition_time, transition_node, transition_to);
};

// How the behaviour tree is built. A node comes before its children, and the root, 0, is its own parent.
struct BehaviourNodes {
  Header header;
  std::uint32_t revision = 0;    // as in BehaviourState
  std::uint32_t node_count = 0;  // of the tree; the first 1024 follow
  std::vector<std::uint32_t> parent;
  std::vector<std::string> type;  // as in the mission's file: Sequence, WalkTo
  std::vector<std::string> name;  // likewise; empty: it has none
  GAITWAY_ROS_MESSAGE("gaitway_msgs/msg/BehaviourNodes", header, revision, node_count, parent, type, name);
};

}  // namespace gaitway::api::ros
