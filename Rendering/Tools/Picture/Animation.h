// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pixelexact
{
struct CommonOptions;
struct RenderOptions;

/// Renders the pictures of an animation: numbered files, or a video. Mesh, bounds and trees are
/// kept between pictures. Another time step is read, and shares them where its mesh is the same. A
/// numbered picture is written completely or not at all. Its text `Provenance` identifies its
/// sources, so that --resume recognises it. With --range all the pictures are traced twice, first
/// for their values. Throws as render.
void RenderAnimation(RenderOptions options, const CommonOptions& common);
} // namespace pixelexact
