// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ink::cli
{

struct RenderOptions;

/// Draws the pictures of an animation: of a series, each step in its turn, or once around what stands still.
/// The camera is placed so that all frames fit, and keeps its distance. A mesh whose faces stay the same is
/// sampled once and its samples are moved with it; anything else is sampled anew for each frame. @throws
/// Failure, UsageError
void renderFrames(const RenderOptions& options);

/// @throws Failure if nothing can be drawn on this machine
void requireGraphics();

} // namespace ink::cli
