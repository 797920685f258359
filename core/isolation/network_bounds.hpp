// The tighter bounds of a child that serves the network: what reaches it from there must not reach
// further. In two parts, since a thread that the plug-in starts while it is constructed must be bound, too.
#pragma once

#include <filesystem>
#include <string>

namespace gaitway::core {

// Before the plug-in is constructed, by the only thread there is: files are created and written beneath
// `folder` alone (empty: nowhere), by this thread and all that it starts. True: the kernel sees to it
// (Landlock). False: it cannot; then no file may be opened once set-up is over. Throws PluginError if there
// is no such folder.
[[nodiscard]] bool confine_writes(const std::filesystem::path& folder);

// When set-up is over, for all threads that there are and will be: no new sockets but those that are
// accepted, no connections, no change of files or folders, no file opened but for writing, and that only if
// `may_write`. What is refused answers EPERM, an open EACCES. Throws PluginError where the kernel cannot do
// that: then nothing must be served.
void end_set_up(bool may_write);

}  // namespace gaitway::core
