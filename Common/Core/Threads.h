// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ink
{

/// The maximum number of threads: the environment variable VTK_SMP_MAX_THREADS if it is a positive number, as
/// in VTK itself, but at most the number of hardware threads, which is also the default. Read at every call,
/// so that a program can change it between two runs. Run parallel work in
/// `tbb::task_arena(ink::threadCount())`.
int threadCount();

} // namespace ink
