// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace pixelexact
{
/// The position of a point relative to an element or a mesh.
///
/// `Inside` requires a converged inverse whose residual is of rounding size and whose xi lies in
/// the reference shape, up to the tolerance that rounding and conditioning explain. `Outside`
/// requires a reason that excludes every xi of the shape (hull, frame, injectivity). Everything
/// else is `Unknown`: it is counted and shown, never painted over.
enum class [[nodiscard]] Verdict : std::uint8_t{ Outside = 0, Inside = 1, Unknown = 2 };

constexpr const char* Name(Verdict verdict)
{
  switch (verdict)
  {
    case Verdict::Outside:
      return "outside";
    case Verdict::Inside:
      return "inside";
    default:
      return "unknown";
  }
}
} // namespace pixelexact
