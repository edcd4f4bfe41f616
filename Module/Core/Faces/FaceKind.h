// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace pixelexact
{
/// Classifies the elements behind a face.
enum class FaceKind : std::uint8_t
{
  Boundary, ///< nothing: the mesh ends there
  Interior, ///< one whole face of another element
  Hanging,  ///< faces of other elements of which at least one is larger or smaller; all of it is
            ///< covered
  Partly    ///< other elements behind a part of it
};
} // namespace pixelexact
