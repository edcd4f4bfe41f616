// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Frames/FrameSource.h"

class vtkHighOrderLayer;
class vtkHighOrderMapper;
class vtkMapper;
class vtkProperty;

// What a mapper, its actor and its layers ask for, as requests for frames.
namespace pixelexact
{
/// What mapper and property say of all surfaces; the surface itself is left open.
[[nodiscard]] LayerRequest LayerOf(vtkHighOrderMapper* mapper, vtkProperty* property);

/// A layer: what it does not say itself is as `ofAll`. Its surface is left open, too.
[[nodiscard]] LayerRequest LayerOf(vtkHighOrderLayer* layer, LayerRequest ofAll);

/// Whether a layer of the mapper hides all that is behind it; null: one without a look of its own.
[[nodiscard]] bool IsOpaque(vtkMapper* mapper, vtkHighOrderLayer* layer);
} // namespace pixelexact
