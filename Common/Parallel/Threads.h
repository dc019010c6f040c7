#pragma once

namespace ink
{

/// How many threads vtkInk may use: the environment variable VTK_SMP_MAX_THREADS when it holds a positive
/// number, as VTK itself reads it, otherwise one per hardware thread. Read at every call, so that a
/// program can change it between two runs. Run parallel work in `tbb::task_arena(ink::threadCount())`.
int threadCount();

} // namespace ink
