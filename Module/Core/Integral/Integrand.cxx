// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Integral/Integrand.h"

#include <cmath>

namespace pixelexact
{
SurfaceModels::SurfaceModels(ElementFunctions& functions, const PieceBox& box,
  const std::array<int, 3>& axes, const PointedModels& place, const PieceBox& places)
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      jacobian[i][j] = place.Of(BoxModel(
        functions.Slope(box, static_cast<int>(i), static_cast<int>(j)), axes, place.IsWideB()));
    }
  }
  determinant = Dot(jacobian[0], Cofactors(jacobian, 0));
  field = functions.Values(box, axes, place, places);
}

std::array<ChebyshevModel, 3> Cofactors(
  const std::array<std::array<ChebyshevModel, 3>, 3>& matrix, std::size_t row)
{
  const auto& next = matrix[(row + 1) % 3];
  const auto& last = matrix[(row + 2) % 3];
  std::array<ChebyshevModel, 3> cofactors;
  for (std::size_t j = 0; j < 3; ++j)
  {
    const std::size_t m = (j + 1) % 3;
    const std::size_t n = (j + 2) % 3;
    cofactors[j] = next[m] * last[n] - next[n] * last[m];
  }
  return cofactors;
}

WeighedField Weigh(const SurfaceModels& models, Mapping mapping)
{
  WeighedField weighed;
  switch (mapping)
  {
    case Mapping::Identity:
      weighed.power = 3;
      for (const ChebyshevModel& value : models.field)
      {
        weighed.values.push_back(models.determinant * value);
      }
      break;
    case Mapping::Density:
      weighed.values = models.field;
      break;
    default:
      // J F, or det J J^-T F, which is the cofactors times F.
      const std::array<ChebyshevModel, 3> field{ models.field[0], models.field[1],
        models.field[2] };
      weighed.power = mapping == Mapping::Contravariant ? 1 : 2;
      for (std::size_t i = 0; i < 3; ++i)
      {
        weighed.values.push_back(Dot(
          mapping == Mapping::Contravariant ? models.jacobian[i] : Cofactors(models.jacobian, i),
          field));
      }
      break;
  }
  return weighed;
}

ChebyshevModel Dot(const std::array<ChebyshevModel, 3>& a, const std::array<ChebyshevModel, 3>& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

std::array<ChebyshevModel, 3> EtaModels(const ElementFunctions& functions, const PieceBox& box,
  const std::array<int, 3>& axes, const ChebyshevModel& b, const ChebyshevModel& c)
{
  const std::array<ChebyshevModel, 3> s{ ChebyshevModel::First(), b, c };
  std::array<ChebyshevModel, 3> eta;
  for (std::size_t v = 0; v < 3; ++v)
  {
    const int d = axes[v];
    eta[static_cast<std::size_t>(d)] =
      ChebyshevModel(functions.Middle(box, d)) + ChebyshevModel(functions.HalfWidth(box, d)) * s[v];
  }
  return eta;
}

std::array<ChebyshevModel, 3> PlaceModels(ElementFunctions& functions, const PieceBox& box,
  const std::array<int, 3>& axes, const PointedModels& place, const Vec3& origin)
{
  std::array<ChebyshevModel, 3> z;
  for (int d = 0; d < 3; ++d)
  {
    z[static_cast<std::size_t>(d)] = ChebyshevModel(functions.Shift(origin, d)) +
      functions.Radius() * place.Of(BoxModel(functions.Map3(box, d), axes, place.IsWideB()));
  }
  return z;
}

std::vector<ChebyshevModel> ClipModels(ElementFunctions& functions, const PieceBox& box,
  const std::array<int, 3>& axes, const PointedModels& place)
{
  std::vector<ChebyshevModel> clips;
  for (std::size_t k = 0; k < functions.Question().clips.size(); ++k)
  {
    const BoxPolynomial clip = functions.Clip(box, k);
    if (!(clip.Hull().upper <= 0.0))
    {
      clips.push_back(place.Of(BoxModel(clip, axes, place.IsWideB())));
    }
  }
  if (const auto& below = functions.Question().below)
  {
    const ChebyshevModel value = functions.Values(box, axes, place, box).front();
    clips.push_back(value - ChebyshevModel(std::ldexp(*below, -functions.FieldExponent())));
  }
  return clips;
}

std::optional<ClippedSquare> ClippedPart(ElementFunctions& functions, const PieceBox& box,
  const std::array<int, 3>& axes, const PointedModels& place)
{
  return ClippedSquare::Of(ClipModels(functions, box, axes, place));
}

bool IsClippedOff(ElementFunctions& functions, const PieceBox& box)
{
  for (std::size_t k = 0; k < functions.Question().clips.size(); ++k)
  {
    if (functions.Clip(box, k).Hull().lower > 0.0)
    {
      return true;
    }
  }
  const auto& below = functions.Question().below;
  return below &&
    functions.ValueRanges(box).front().lower > std::ldexp(*below, -functions.FieldExponent());
}

ChebyshevModel Collapse(const ChebyshevModel& eta)
{
  return 0.5 * (ChebyshevModel(1.0) - eta);
}

void DropZeroField(const ElementFunctions& functions, Sums& sums)
{
  for (std::size_t q = 1; q < sums.size() && functions.IsZeroField(); ++q)
  {
    sums[q] = sums[q].IsFinite() ? Interval(0.0) : sums[q];
  }
}

void AddTo(Sums& sums, const Sums& more)
{
  // Zeros are exact, and so are sums with them.
  const auto isZero = [](const Interval& sum) { return sum.lower == 0.0 && sum.upper == 0.0; };
  for (std::size_t q = 0; q < sums.size(); ++q)
  {
    sums[q] = isZero(more[q]) ? sums[q] : isZero(sums[q]) ? more[q] : sums[q] + more[q];
  }
}
} // namespace pixelexact
