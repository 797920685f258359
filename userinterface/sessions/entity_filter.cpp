// Each filter by itself; an entity passes when it passes all.
#include "entity_filter.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "client_message.hpp"

namespace gaitway::api {

using namespace ros::simulation;

namespace {

// What makes a short pattern dear: repeats of repeats, and looking for what was found before.
bool may_be_dear(std::string_view pattern) {
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    const bool escaped = pattern[i] == '\\' && i + 1 < pattern.size();
    i += escaped ? 1 : 0;
    const bool is_digit = std::isdigit(static_cast<unsigned char>(pattern[i])) != 0;
    if ((escaped && is_digit) || (!escaped && pattern[i] == '{')) {
      return true;
    }
  }
  return false;
}

}  // namespace

EntityFilter::EntityFilter(EntityFilters filters) : filters_(std::move(filters)) {
  compile();
  check_bounds();
  if (filters_.tags.filter_mode > TagsFilter::FILTER_MODE_ALL) {
    throw Refused("filters.tags.filter_mode is " + std::to_string(filters_.tags.filter_mode) +
                  ", but must be 0 (any) or 1 (all)");
  }
}

void EntityFilter::FreePattern::operator()(regex_t* pattern) const noexcept {
  regfree(pattern);
  delete pattern;
}

void EntityFilter::compile() {
  const std::string& text = filters_.filter;
  if (text.empty()) {
    return;
  }
  if (text.size() > kMostPatternBytes || text.find('\0') != std::string::npos) {
    throw Refused("filters.filter is " + shown(text) + ", but must be a regular expression of at most " +
                  std::to_string(kMostPatternBytes) + " bytes");
  }
  if (may_be_dear(text)) {
    throw Unsupported("filters.filter is " + shown(text) +
                      ", but must be a regular expression without intervals {} and back references");
  }
  auto pattern = std::make_unique<regex_t>();
  if (const int error = regcomp(pattern.get(), text.c_str(), REG_EXTENDED | REG_NOSUB); error != 0) {
    std::array<char, 128> why{};
    regerror(error, pattern.get(), why.data(), why.size());
    throw Refused("filters.filter is " + shown(text) +
                  ", but must be a regular expression (POSIX extended): " + why.data());
  }
  pattern_.reset(pattern.release());
}

void EntityFilter::check_bounds() const {
  const Bounds& bounds = filters_.bounds;
  if (bounds.type > Bounds::TYPE_SPHERE) {
    throw Refused("filters.bounds.type is " + std::to_string(bounds.type) + ", but must be from 0 to 3");
  }
  if (bounds.type == Bounds::TYPE_BOX || bounds.type == Bounds::TYPE_CONVEX_HULL) {
    throw Unsupported("filters.bounds.type is " + std::to_string(bounds.type) +
                      ", but must be 3 (a sphere) or 0 (none)");
  }
  if (bounds.type == Bounds::TYPE_SPHERE && (bounds.points.size() != 2 || !(bounds.points[1].x > 0.0))) {
    throw Refused(
        "filters.bounds.points has " + std::to_string(bounds.points.size()) +
        " points, but must have two of a sphere: its centre, and its radius above 0 as the x of the "
        "second");
  }
}

bool EntityFilter::passes(const Entity& entity) const {
  if (pattern_ && regexec(pattern_.get(), entity.name.c_str(), 0, nullptr, 0) != 0) {
    return false;
  }
  const auto is_category = [&](const EntityCategory& one) {
    return one.category == entity.info.category.category;
  };
  if (!filters_.categories.empty() && std::ranges::none_of(filters_.categories, is_category)) {
    return false;
  }
  if (filters_.bounds.type == Bounds::TYPE_SPHERE) {
    const ros::Vector3& centre = filters_.bounds.points[0];
    if (distance_m(entity, {centre.x, centre.y, centre.z}) > filters_.bounds.points[1].x) {
      return false;
    }
  }
  return passes_tags(entity);
}

bool EntityFilter::passes_tags(const Entity& entity) const {
  const auto has = [&](const std::string& tag) {
    return std::ranges::find(entity.info.tags, tag) != entity.info.tags.end();
  };
  const auto& wanted = filters_.tags.tags;
  return wanted.empty() ||
         (filters_.tags.filter_mode == TagsFilter::FILTER_MODE_ALL ? std::ranges::all_of(wanted, has)
                                                                   : std::ranges::any_of(wanted, has));
}

}  // namespace gaitway::api
