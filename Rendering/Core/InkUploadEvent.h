// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkUploadEvent_h
#define InkUploadEvent_h

/// What vtkTimerLog calls the time in which a mapper brings up to date what it has on the GPU, also for a
/// view; such events follow each other, none is within another.
inline constexpr const char* InkUploadEvent = "Upload ink marks";

#endif
