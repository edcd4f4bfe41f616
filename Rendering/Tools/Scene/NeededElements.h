// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Model.h"

namespace pixelexact
{
class SurfaceOptions;

/// Gathers, from the parts of a mesh that several processes have read, the elements that these
/// surfaces can intersect, in the order of the whole mesh, on all processes. Tracing them gives the
/// result of the whole mesh. Elements at the ends of the mesh's box are included, so that the box
/// stays the same. The part is consumed. All processes must call it; throws Error on all of them.
LoadedModel WithNeededElements(LoadedModel part, const SurfaceOptions& surfaces);

/// LoadModel for one process of several, whose part may be empty: it then has no model. Throws
/// Error on all processes where one cannot read its part.
LoadedModel LoadPart(const InputRequest& request, const std::string& field, Stopwatch& stopwatch);
} // namespace pixelexact
