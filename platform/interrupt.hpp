// Ctrl-C as a wish that work looks at, and what must not stay behind when the user does not wait.
#pragma once
#include <cstddef>

namespace netmesh::platform {

// From now on the first SIGINT, SIGTERM or SIGHUP only sets a flag (and interrupts a blocking read); the second removes
// the temporary files registered below and ends the process by that signal. Running into the limit on file sizes
// becomes an error of the write.
void catch_interrupts();

// True once a signal has come.
bool interrupted();
// What ends because of it has to be said: interrupted() is false until the next signal.
void take_interrupt();

// Files to be removed if the process is killed as above. Returns a handle, or -1 when the name is too long or the table
// is full (the file then merely stays). At most 8 at a time.
int remove_when_killed(const char* path);
void forget(int handle);

}  // namespace netmesh::platform
