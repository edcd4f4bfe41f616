// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/LevelLattice.h"

#include "Core/Location/Sample.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace pixelexact
{
const ShapeLattice& LatticeOf(Shape shape, int level)
{
  static PerLevel<ShapeLattice> all;
  return all.Get(shape, level, [&] { return MakeShapeLattice(shape, 1 << level); });
}

std::vector<double> ValuesAt(
  const Mesh& mesh, const Field* field, int element, std::span<const Vec3> xi, int components)
{
  std::vector<double> values(xi.size() * static_cast<std::size_t>(components));
  if (field != nullptr)
  {
    EvaluateAt(mesh, *field, element, xi, values, {});
    return values;
  }
  std::vector<Vec3> x(xi.size());
  MapForward(mesh, element, xi, x);
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    std::copy_n(glm::value_ptr(x[i]), 3, &values[3 * i]);
  }
  return values;
}
} // namespace pixelexact
