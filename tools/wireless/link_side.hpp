// One side of the emulated link: a network namespace of its own with a TUN device, and the program that runs
// in it.
#pragma once

#include <sys/types.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::tools {

// The machine has no TUN or no namespaces for this user; says what to do about it.
class NoIsolation : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct SideSettings {
  std::string own_address, other_address;  // IPv4
  std::vector<std::string> program;        // with its arguments; empty: none, the namespace alone
  int output = -1;                         // its standard output and error; -1: as here
  bool reads_input = false;                // ours; otherwise there is nothing to read
};

// A process group; whoever is left of it is killed at the end.
class LinkSide {
 public:
  // Everything is there, but the program does not run yet. To be called while there is one thread. Throws
  // NoIsolation.
  explicit LinkSide(const SideSettings& settings);
  LinkSide(const LinkSide&) = delete;
  LinkSide& operator=(const LinkSide&) = delete;
  ~LinkSide();

  void start();
  void signal(int number) const;  // to the whole group
  [[nodiscard]] bool reap();      // whether it has ended; its `code` is known then
  [[nodiscard]] int tun() const { return tun_.get(); }
  [[nodiscard]] pid_t group() const { return pid_; }
  [[nodiscard]] bool ended() const { return ended_; }
  [[nodiscard]] int code() const { return code_; }  // as a shell has it: 128 and the signal's number

 private:
  process::FileDescriptor tun_, go_;
  pid_t pid_ = -1;
  bool ended_ = false;
  int code_ = 0;
};

}  // namespace gaitway::tools
