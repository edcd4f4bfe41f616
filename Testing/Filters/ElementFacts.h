// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Location/Sample.h"
#include "HighOrderModel.h"

#include <map>
#include <vector>

namespace pixelexact::testing
{
/// Per source cell: place and values of all fields at a few points, bit for bit what a model gives.
using Facts = std::map<std::int64_t, std::vector<double>>;
inline Facts FactsOf(vtkDataObject* grid)
{
  const auto model = HighOrderModel::From(grid);
  const Vec3 xi[] = { Vec3(-0.3, -0.5, -0.4), Vec3(-0.8, -0.1, -0.9) };
  Facts facts;
  for (int e = 0; e < model->GetMesh().Elements(); ++e)
  {
    auto& numbers = facts[model->SourceCells()[static_cast<std::size_t>(e)]];
    Vec3 world[2];
    MapForward(model->GetMesh(), e, xi, world);
    for (const Vec3& x : world)
    {
      numbers.insert(numbers.end(), { x.x, x.y, x.z });
    }
    for (const Field& field : model->Fields())
    {
      std::vector<double> values(2 * static_cast<std::size_t>(field.values.components));
      EvaluateAt(model->GetMesh(), field, e, xi, values, {});
      numbers.insert(numbers.end(), values.begin(), values.end());
    }
    for (const AttributedFace& face : model->BoundaryFaces())
    {
      if (face.face.element == e)
      {
        numbers.push_back(10.0 * face.attribute + face.face.face);
      }
    }
  }
  return facts;
}
} // namespace pixelexact::testing
