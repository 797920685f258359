// The leaves that trees may use: their names, their ports, and who makes them.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "gaitway/behaviour/leaf.hpp"
#include "gaitway/behaviour/value.hpp"

namespace gaitway::behaviour {

enum class PortDirection : std::uint8_t { input, output, inout };

struct PortSpec {
  std::string name;
  ValueType type{};
  PortDirection direction = PortDirection::input;
  // Of an input: as written in XML; without it the port must be given. Outputs need not be.
  std::optional<std::string> standard{};
  std::string meaning{};
};

struct LeafSpec {
  std::string id;
  std::vector<PortSpec> ports{};
  std::string meaning{};
};

using ConditionMaker = std::function<std::unique_ptr<Condition>()>;
using ActionMaker = std::function<std::unique_ptr<Action>()>;

class Registry {
 public:
  struct Leaf {
    LeafSpec spec;
    std::variant<ConditionMaker, ActionMaker> maker;
  };

  // `maker` is called once for each node of a tree. Throws std::invalid_argument, naming leaf and port, for
  // an id that is taken or that BehaviorTree.CPP's format has for something else, a port's name that is none
  // or there twice, a unit that is not known, choices without names and a standard that is no value.
  void add_condition(LeafSpec spec, ConditionMaker maker);
  void add_action(LeafSpec spec, ActionMaker maker);

  [[nodiscard]] const Leaf* find(std::string_view id) const;
  [[nodiscard]] const std::map<std::string, Leaf, std::less<>>& leaves() const noexcept { return leaves_; }

 private:
  void add(Leaf leaf);

  std::map<std::string, Leaf, std::less<>> leaves_;
};

}  // namespace gaitway::behaviour
