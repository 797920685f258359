// Which entities a client asks for: EntityFilters of simulation_interfaces, checked.
#pragma once

#include <regex.h>

#include <memory>
#include <stdexcept>
#include <string>

#include "gaitway/api/simulation_interfaces_types.hpp"
#include "simulation_entities.hpp"

namespace gaitway::api {

class EntityFilter {
 public:
  static constexpr std::size_t kMostPatternBytes = 128;

  // A kind of filter that is not there, as the result RESULT_FEATURE_UNSUPPORTED has it.
  class Unsupported : public std::runtime_error {
    using std::runtime_error::runtime_error;
  };

  // Throws Unsupported; Refused for a filter that is wrong.
  explicit EntityFilter(ros::simulation::EntityFilters filters);

  [[nodiscard]] bool passes(const Entity& entity) const;

 private:
  struct FreePattern {
    void operator()(regex_t* pattern) const noexcept;
  };
  void compile();
  void check_bounds() const;
  [[nodiscard]] bool passes_tags(const Entity& entity) const;

  ros::simulation::EntityFilters filters_;
  std::unique_ptr<regex_t, FreePattern> pattern_;  // null: any name
};

}  // namespace gaitway::api
