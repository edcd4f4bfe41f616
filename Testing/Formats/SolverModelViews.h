// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Location/Sample.h"
#include "Formats/SolverModel.h"

#include <vector>

namespace pixelexact::testing
{
inline Expansion ViewOf(const SolverExpansion& e)
{
  return { e.spaces, e.spaceOf, e.offset, { e.coefficients.data.get(), e.coefficients.size },
    e.components };
}

inline Mesh ViewOf(const SolverMesh& mesh)
{
  return { ViewOf(mesh.map), mesh.centre, mesh.size, mesh.uncertainty };
}

inline Vec3 PointAt(const SolverModel& model, int element, const Vec3& xi)
{
  Vec3 x;
  MapForward(ViewOf(model.mesh), element, std::span(&xi, 1), std::span(&x, 1));
  return x;
}

inline std::vector<double> ValueAt(
  const SolverModel& model, std::size_t field, int element, const Vec3& xi)
{
  const SolverField& f = model.fields.at(field);
  std::vector<double> value(f.values.components);
  EvaluateAt(ViewOf(model.mesh), { f.name, ViewOf(f.values), f.mapping }, element,
    std::span(&xi, 1), value, {});
  return value;
}
} // namespace pixelexact::testing
