// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/NumberedSurfaces.h"

#include "Base/Command.h"

#include "Core/Base/Error.h"
#include "Trace/Surfaces/ConvexBody.h"
#include "Trace/Surfaces/Disc.h"
#include "Trace/Surfaces/Quadric.h"
#include "Trace/Surfaces/Torus.h"

#include <algorithm>
#include <string>

namespace pixelexact
{
namespace
{
using SurfacePointer = std::shared_ptr<const Surface>;

template <class Made>
SurfacePointer Shared(Made surface)
{
  return std::make_shared<const Made>(std::move(surface));
}
} // namespace

const std::array<NumberedSurface, 7> kNumberedSurfaces{ {
  { "--disc",
    [](const GivenNumbers& p) { return Shared(Disc(VectorAt(p, 0), VectorAt(p, 3), p[6])); } },
  { "--sphere", [](const GivenNumbers& p) { return Shared(MakeSphere(VectorAt(p, 0), p[3])); } },
  { "--cylinder",
    [](const GivenNumbers& p)
    { return Shared(MakeCylinder(VectorAt(p, 0), VectorAt(p, 3), p[6])); } },
  { "--cone",
    [](const GivenNumbers& p) { return Shared(MakeCone(VectorAt(p, 0), VectorAt(p, 3), p[6])); } },
  { "--quadric",
    [](const GivenNumbers& p)
    {
      std::array<double, 10> a{};
      std::ranges::copy(p, a.begin());
      return Shared(MakeQuadric(a));
    } },
  { "--torus",
    [](const GivenNumbers& p)
    { return Shared(Torus(VectorAt(p, 0), VectorAt(p, 3), p[6], p[7])); } },
  { "--box",
    [](const GivenNumbers& p) { return Shared(MakeBox(VectorAt(p, 0), VectorAt(p, 3))); } },
} };

SurfacePointer MakeNumbered(const NumberedSurface& kind, const GivenNumbers& numbers)
{
  try
  {
    return kind.make(numbers);
  }
  catch (const Error& error)
  {
    throw UsageError(std::string(kind.option) + ": " + error.what());
  }
}
} // namespace pixelexact
