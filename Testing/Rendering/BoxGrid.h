// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/ChangeOfBasis.h"
#include "HighOrderArrays.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace pixelexact::testing
{
/// The fields of BoxGrid, in closed form.
inline double FieldU(double x, double y, double z)
{
  return x * x * x - 0.5 * x + y * y + 0.25 * z;
}
inline Vec3 FieldV(double x, double y, double z)
{
  return { x + y, y * z, 1.0 - z };
}

/// One element of order `order` for a function that lies in that space.
inline void AddElement(OwnedExpansion& arrays, std::size_t element, int order,
  const std::function<void(const LongVec3& xi, long double* values)>& function)
{
  const Space space = UniformSpace(Shape::Hexahedron, order);
  const int components = arrays.components;
  const auto change = ChangeOfBasis::FromFunctions(space, components, function);
  std::vector<double> unit(static_cast<std::size_t>(components), 0.0);
  for (int c = 0; c < components; ++c)
  {
    unit[static_cast<std::size_t>(c)] = 1.0;
    const auto modes = static_cast<std::size_t>(space.Modes());
    change.Apply(
      unit, 0.0, arrays.Coefficients(element).subspan(static_cast<std::size_t>(c) * modes, modes));
    unit[static_cast<std::size_t>(c)] = 0.0;
  }
}

/// n^3 hexahedra over the cube [-1,1]^3 around `centre`, with the fields "u" (order 3), "v" (three
/// components, order 2) and "nan" (order 0, NaN in the first element, 1 elsewhere), all functions
/// of the position relative to the centre. `source` numbers start at 1000.
inline vtkSmartPointer<vtkUnstructuredGrid> BoxGrid(int n, const Vec3& centre = Vec3(0.0))
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  grid->SetPoints(points);
  const std::size_t count = static_cast<std::size_t>(n) * n * n;
  MeshArrays mesh;
  const auto spaces = [count](int order)
  { return std::vector<Space>(count, UniformSpace(Shape::Hexahedron, order)); };
  mesh.map.Allocate(spaces(1), 3);
  OwnedExpansion u;
  OwnedExpansion v;
  OwnedExpansion nan;
  u.Allocate(spaces(3), 1);
  v.Allocate(spaces(2), 3);
  nan.Allocate(spaces(0), 1);

  const double half = 1.0 / n;
  const double size = std::exp2(std::ceil(std::log2(half)));
  for (std::size_t e = 0; e < count; ++e)
  {
    const std::array<std::size_t, 3> cell{ e % n, e / n % n, e / n / n };
    LongVec3 local;
    for (int d = 0; d < 3; ++d)
    {
      local[d] = -1.0L + (2.0L * cell[d] + 1.0L) / n;
      mesh.centre.push_back(centre[d] + static_cast<double>(local[d]));
    }
    mesh.size.push_back(size);
    mesh.uncertainty.push_back(0.0);
    mesh.sourceCell.push_back(static_cast<std::int64_t>(1000 + e));
    AddElement(mesh.map, e, 1,
      [&](const LongVec3& xi, long double* out)
      {
        for (int d = 0; d < 3; ++d)
        {
          out[d] = xi[d] * half / size;
        }
      });
    const auto at = [&](const LongVec3& xi) {
      return LongVec3{ local[0] + xi[0] * half, local[1] + xi[1] * half, local[2] + xi[2] * half };
    };
    AddElement(u, e, 3,
      [&](const LongVec3& xi, long double* out)
      {
        const auto [x, y, z] = at(xi);
        out[0] = x * x * x - 0.5L * x + y * y + 0.25L * z;
      });
    AddElement(v, e, 2,
      [&](const LongVec3& xi, long double* out)
      {
        const auto [x, y, z] = at(xi);
        out[0] = x + y;
        out[1] = y * z;
        out[2] = 1.0L - z;
      });
    nan.Coefficients(e)[0] = e == 0 ? std::numeric_limits<double>::quiet_NaN() : 1.0;

    vtkIdType ids[8];
    for (int corner = 0; corner < 8; ++corner)
    {
      // VTK's order: counter-clockwise below, then above.
      const std::array<int, 3> sign{ ((corner + 1) & 2) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1,
        corner > 3 ? 1 : -1 };
      double x[3];
      for (int d = 0; d < 3; ++d)
      {
        x[d] = mesh.centre[3 * e + d] + sign[d] * half;
      }
      ids[corner] = points->InsertNextPoint(x);
    }
    grid->InsertNextCell(VTK_HEXAHEDRON, 8, ids);
  }
  StoreMesh(grid, std::move(mesh), Origin::Coefficients);
  StoreField(grid, "u", { std::move(u) }, Origin::Coefficients);
  StoreField(grid, "v", { std::move(v) }, Origin::Coefficients);
  StoreField(grid, "nan", { std::move(nan) }, Origin::Coefficients);
  return grid;
}
} // namespace pixelexact::testing
