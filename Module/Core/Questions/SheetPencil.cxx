// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Math/Mat.h"
#include "Core/Questions/OnSheet.h"
#include "Core/Shape/ShapeFace.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace pixelexact
{
using namespace edges;

namespace
{
/// Row sums of |W J - I|, of rounding: beyond, the map is too nearly singular.
constexpr double kSingular = 1e-3;
} // namespace

std::size_t EndOfFace(Shape shape, int face)
{
  const ShapeFace& one = FacesOf(shape)[static_cast<std::size_t>(face)];
  return 2 * static_cast<std::size_t>(one.direction) + (one.upper ? 1U : 0U);
}

OnSheet::OnSheet(
  const EdgeFunctions& functions, const std::array<EdgeNodeEnd, 6>& ends, const Sheet& sheet)
  : Of(functions)
  , Ends(ends)
  , sheet_(sheet)
{
  if (sheet.face >= 0)
  {
    Own = EndOfFace(functions.GetShape(), sheet.face);
  }
}

void OnSheet::Evaluate(std::span<const Vec3> xi, std::span<Values> all) const
{
  const PointValues map = Of.ImagesAt(xi);
  for (std::size_t i = 0; i < xi.size(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      all[i].y[c] = map.values[c][i];
      for (int j = 0; j < 3; ++j)
      {
        all[i].jacobian[j][c] = map.slopes[3 * c + j][i];
      }
    }
    if (Own < 6)
    {
      const EdgeNodeEnd& end = Ends[Own];
      all[i].f = end.DepthOf(xi[i]);
      all[i].gradient = -Vec3(end.normal[0], end.normal[1], end.normal[2]);
    }
  }
  if (Own < 6)
  {
    return;
  }
  for (int c = 0; c < Of.Components(); ++c)
  {
    const PointValues component = Of.ValuesAt(c, xi);
    for (std::size_t i = 0; i < xi.size(); ++i)
    {
      const double value = component.values[0][i];
      all[i].size = IsNorm() ? std::hypot(all[i].size, value) : value;
      all[i].gradient += (IsNorm() ? value : 1.0) * component.SlopeOf(0, i);
    }
  }
  for (Values& at : all)
  {
    at.gradient /= IsNorm() ? at.size : 1.0;
    at.f = at.size - sheet_.value;
    at.size = std::fabs(at.size);
  }
}

std::optional<OnSheet::Pencil> OnSheet::PencilOf(
  const Values& at, const Vec3& first, const Vec3& last) const
{
  Pencil pencil;
  pencil.inverse = glm::inverse(at.jacobian);
  const Mat3& W = pencil.inverse;
  const Mat3 product = W * at.jacobian;
  for (int k = 0; k < 3; ++k)
  {
    double sum = 0.0;
    for (int j = 0; j < 3; ++j)
    {
      double size = 0.0;
      for (int c = 0; c < 3; ++c)
      {
        size +=
          std::fabs(W[c][k]) * (kRoundoffs * std::fabs(at.jacobian[j][c]) + Of.ImageSlopeError());
      }
      sum += std::fabs(product[j][k] - (j == k ? 1.0 : 0.0)) + size;
    }
    pencil.miss[static_cast<std::size_t>(k)] = sum * kUp;
  }
  // Written so that a NaN is not known.
  if (!(pencil.miss[0] <= kSingular && pencil.miss[1] <= kSingular && pencil.miss[2] <= kSingular))
  {
    return std::nullopt;
  }
  const bool rises = glm::dot(at.gradient, W * first) > 0.0;
  for (const Vec3& direction : { first, last })
  {
    const Vec3 w = W * direction;
    const double across = glm::dot(at.gradient, w);
    double size = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      for (int c = 0; c < 3; ++c)
      {
        size += std::fabs(at.gradient[k] * W[c][k] * direction[c]);
      }
    }
    if (!(std::fabs(across) > kGrazing * size && (across > 0.0) == rises))
    {
      return std::nullopt;
    }
    pencil.across = std::min(pencil.across, std::fabs(across) - kRoundoffs * size);
    for (int k = 0; k < 3; ++k)
    {
      const auto row = static_cast<std::size_t>(k);
      const double q = w[k] / across;
      pencil.towards[row] =
        std::max(pencil.towards[row], std::fabs(q) + kSteep * glm::length(w) / std::fabs(across));
      for (int j = 0; j < 3; ++j)
      {
        const double back = q * at.gradient[j];
        double& entry = pencil.project[row][static_cast<std::size_t>(j)];
        entry = std::max(
          entry, std::fabs((j == k ? 1.0 : 0.0) - back) + kSteep * (1.0 + std::fabs(back)));
      }
    }
  }
  return pencil;
}

double OnSheet::ErrorOf(const Values& at) const
{
  return Own < 6 ? kRoundoffs : Of.ValueError() + kRoundoffs * (at.size + std::fabs(sheet_.value));
}

double OnSheet::SlopeErrorOf(const EdgeNode& node, const Values& at) const
{
  if (Own < 6)
  {
    return 0.0;
  }
  const double most = std::max({ node.slope[0], node.slope[1], node.slope[2] });
  return Of.ValueSlopeError() + kRoundoffs * most +
    (IsNorm() ? 2.0 * most * Of.ValueError() / at.size : 0.0);
}
} // namespace pixelexact
