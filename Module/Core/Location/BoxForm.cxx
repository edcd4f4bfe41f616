// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Location/BoxForm.h"

#include "Core/Basis/ChangeOfBasis.h"

#include <cmath>
#include <map>
#include <memory>
#include <mutex>

namespace pixelexact
{
namespace
{
/// Face tolerances are far below; boxes beyond it hold no root that could count as inside.
constexpr double kBeyond = 1e-6;

Space CubeSpace(const Space& space)
{
  return { Shape::Hexahedron, Form::Collapsed, space.order };
}

/// Canonical modes on the cube from those of a prism or tetrahedron: hexahedral modes x modes,
/// row-major. The same polynomials, continued over the cube.
const std::vector<double>& ToCube(const Space& space)
{
  static std::mutex mutex;
  static std::map<Space, std::unique_ptr<std::vector<double>>> known;
  const std::scoped_lock lock(mutex);
  auto& entry = known[space];
  if (!entry)
  {
    const Space cube = CubeSpace(space);
    const auto rows = static_cast<std::size_t>(cube.Modes());
    const auto columns = static_cast<std::size_t>(space.Modes());
    const auto change = ChangeOfBasis::FromFunctions(cube, space.Modes(),
      [&space](const LongVec3& xi, long double* modes) { EvaluateModes(space, xi, modes); });
    entry = std::make_unique<std::vector<double>>(rows * columns);
    std::vector<double> unit(columns, 0.0);
    std::vector<double> column(rows);
    for (std::size_t k = 0; k < columns; ++k)
    {
      unit[k] = 1.0;
      change.Apply(unit, 0.0, column);
      unit[k] = 0.0;
      for (std::size_t row = 0; row < rows; ++row)
      {
        (*entry)[row * columns + k] = column[row];
      }
    }
  }
  return *entry;
}
} // namespace

BoxForm::BoxForm(const Space& space, const double* coefficients, BoxSpace boxSpace)
  : inReferenceSpace(space.shape == Shape::Hexahedron ||
      (boxSpace == BoxSpace::Reference && space.shape != Shape::Pyramid))
{
  const bool continued = inReferenceSpace && space.shape != Shape::Hexahedron;
  const auto& form = BernsteinForm::Of(continued ? CubeSpace(space) : space);
  degree = form.Degree();
  const auto modes = static_cast<std::size_t>(space.Modes());
  const auto size = static_cast<std::size_t>(form.Size());
  map.resize(3 * size);
  std::vector<double> cube(continued ? size : 0);
  std::vector<double> magnitude(cube.size());
  for (std::size_t c = 0; c < 3; ++c)
  {
    const double* component = coefficients + c * modes;
    const auto to = std::span(map).subspan(c * size, size);
    if (!continued)
    {
      form.Convert(component, to);
      error[c] = form.ErrorBound(component);
      continue;
    }
    const auto& matrix = ToCube(space);
    for (std::size_t row = 0; row < size; ++row)
    {
      cube[row] = 0.0;
      magnitude[row] = 0.0;
      for (std::size_t k = 0; k < modes; ++k)
      {
        const double term = matrix[row * modes + k] * component[k];
        cube[row] += term;
        magnitude[row] += std::fabs(term);
      }
    }
    form.Convert(cube.data(), to);
    // The bound of one rounding's weight, times the roundings of the product with the matrix.
    error[c] = form.ErrorBound(magnitude.data()) * (static_cast<double>(modes) + 4.0);
  }
}

bool BoxForm::MeetsShape(Shape shape, const Vec3& lowerCorner) const
{
  if (!inReferenceSpace)
  {
    return true;
  }
  switch (shape)
  {
    case Shape::Prism:
      return !(lowerCorner.x + lowerCorner.z > kBeyond);
    case Shape::Tetrahedron:
      return !(lowerCorner.x + lowerCorner.y + lowerCorner.z > -1.0 + kBeyond);
    default:
      return true;
  }
}
} // namespace pixelexact
