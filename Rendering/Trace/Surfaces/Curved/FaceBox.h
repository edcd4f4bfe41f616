// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Curved/CurvedPiece.h"
#include "Trace/Surfaces/Curved/FaceModes.h"

namespace pixelexact
{
/// A box in world coordinates that holds a face of an element, moved by the mesh's uncertainty;
/// much smaller than the element's. Infinite where the map is not finite. `modes`: of the face, or
/// null.
Box3 FaceBox(const Mesh& mesh, const CurvedPart& part, const FaceModes* modes = nullptr);
} // namespace pixelexact
