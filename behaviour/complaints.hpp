// Collects what is wrong with a file, so that all of it is told at once.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "gaitway/behaviour/read.hpp"

namespace gaitway::behaviour {

// Where something is wrong: a line, and the node's path if it is about one.
struct Place {
  int line = 0;
  std::string path{};
};

class Complaints {
 public:
  explicit Complaints(const std::filesystem::path& file) : file_(file) {}

  void add(Place place, std::string field, std::string value, std::string rule, std::string remedy) {
    if (all_.size() >= kMostComplaints) return;
    TreeComplaint complaint{};
    static_cast<input::Complaint&>(complaint) = {
        file_, place.line, std::move(field), std::move(value), std::move(rule), std::move(remedy)};
    complaint.path = std::move(place.path);
    all_.push_back(std::move(complaint));
  }

  // Whether a further complaint would be told.
  [[nodiscard]] bool full() const noexcept { return all_.size() >= kMostComplaints; }

  // Throws BadTree if there is a complaint.
  void throw_if_any();

 private:
  std::filesystem::path file_;
  std::vector<TreeComplaint> all_;
};

}  // namespace gaitway::behaviour
