#pragma once

namespace ink
{

/// How many threads vtkInk may use: the environment variable VTK_SMP_MAX_THREADS when it holds a positive
/// number, as VTK itself reads it, but no more than there are hardware threads, of which there is one each
/// without it. Read at every call, so that a program can change it between two runs. Run parallel work in
/// `tbb::task_arena(ink::threadCount())`.
int threadCount();

} // namespace ink
