// SPDX-License-Identifier: BSD-3-Clause
// Loaded before a process's own libraries: makes those of its threads sleep that only ask the system to let
// others go first. Processes of Open MPI that wait for each other do that without end, and where they are
// more than a machine's processors take them from those that work.
#include <sched.h>
#include <time.h>

extern "C" int sched_yield() noexcept
{
  const timespec moment = { 0, 200'000 };
  return nanosleep(&moment, nullptr);
}
