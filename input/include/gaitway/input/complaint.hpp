// One shape for every complaint about what people write: file, line, field, value, rule, remedy.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace gaitway::input {

// What is wrong with a file or a value that somebody wrote.
class InputError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Complaint {
  std::filesystem::path file;
  int line = 0;        // 1 is the first; 0: not known
  std::string field;   // e.g. "joints[3].node" or "joint 'left_knee' limit lower"
  std::string value;   // as written; empty: there is none
  std::string rule;    // what must hold, e.g. "must be 1..64"
  std::string remedy;  // what to do about it
};

// Throws InputError with the text "file:line: field = value: rule. remedy".
[[noreturn]] void refuse(const Complaint& complaint);

}  // namespace gaitway::input
