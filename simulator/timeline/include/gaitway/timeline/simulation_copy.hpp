// A process that is a copy of the simulation at one instant of its time line. It waits there for what it is
// told: to be copied once more, to replay up to a later instant, or to become the one that people see.
//
// Told {"do": ...}: "copy" makes a copy of itself, which waits at the same instant, and answers with its
// process
// ("copied") and its channel. "events" keeps further events for the replay. "advance" replays to `to_ns`,
// with `what_is_due` also applies what is to happen then, and answers `at_ns` and `digest`. "live" becomes
// the simulation that runs (live_simulation.hpp). What throws is told as {"failed": why}, and the process
// ends. It ends, too, when the other end of its channel is closed.
#pragma once

#include <sys/types.h>

#include <functional>

#include "gaitway/process/file_descriptor.hpp"
#include "gaitway/timeline/copy_channel.hpp"
#include "gaitway/timeline/replayed_run.hpp"

namespace gaitway::timeline {

// Takes over a copy that is to live, and does not come back before its channel ends.
using Live = std::function<void(ReplayedRun& run, const CopyChannel& channel, const nlohmann::json& told)>;
// Makes the simulation at its start.
using MakeRun = std::function<std::unique_ptr<ReplayedRun>()>;

// The other side's hold on a copy.
class CopyHandle {
 public:
  CopyHandle(CopyChannel channel, pid_t process);
  CopyHandle(CopyHandle&&) noexcept = default;
  CopyHandle& operator=(CopyHandle&& other) noexcept;
  ~CopyHandle();  // ends the process, however it is, and waits until it has ended

  // A copy of the same instant. Throws ChannelEnded, std::runtime_error with why it failed.
  [[nodiscard]] CopyHandle copy() const;
  [[nodiscard]] const CopyChannel& channel() const noexcept { return channel_; }
  [[nodiscard]] pid_t process() const noexcept { return id_; }
  // Of one that lives: ends it and the processes that it has made, and waits until all have ended: what they
  // hold (sockets) is free then.
  void end_with_children() noexcept;
  // The next packet. Throws std::runtime_error when it says that the copy failed, ChannelEnded.
  [[nodiscard]] std::optional<CopyChannel::Packet> receive(int patience_ms) const;

 private:
  void end() noexcept;

  CopyChannel channel_;
  pid_t id_ = 0;
  process::FileDescriptor process_;  // a pidfd of it
};

// The first copy, in a process of its own that this one makes: where there is no other thread yet. Returns
// when the simulation is there. Throws std::runtime_error with what `make` threw.
[[nodiscard]] CopyHandle start_simulation(const MakeRun& make, const Live& live);

}  // namespace gaitway::timeline
