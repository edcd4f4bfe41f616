// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Model.h"

namespace pixelexact
{
class SurfaceOptions;

/// Of the parts of a mesh that several processes have read, the elements that these surfaces can
/// meet, in the order of the whole mesh, on all processes: what is traced of them is what would be
/// traced of the whole. Beside them the elements at the ends of the mesh's box, so that it has the
/// same one. The part is given up. All processes must call it; throws Error on all of them.
LoadedModel WithNeededElements(LoadedModel part, const SurfaceOptions& surfaces);

/// LoadModel for one process of several, whose part may be empty: it then has no model. Throws
/// Error on all processes where one cannot read its part.
LoadedModel LoadPart(const InputRequest& request, const std::string& field, Stopwatch& stopwatch);
} // namespace pixelexact
