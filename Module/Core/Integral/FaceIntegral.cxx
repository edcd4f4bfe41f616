// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Integral/FaceIntegral.h"

#include "Core/Faces/FacePlane.h"
#include "Core/Shape/ShapeFace.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
/// Boxes are not subdivided below this width, in the piece's units.
constexpr double kSmallestFaceBox = 0x1p-30;

struct FacePart
{
  PieceBox box;
  Sums sums;
  std::vector<double> magnitudes;
  int direction = -1;
};

/// Adds a model's variation along each variable.
void AddVariation(const ChebyshevModel& model, std::array<double, 2>& along)
{
  for (int i = 0; i <= ChebyshevModel::kDegree; ++i)
  {
    for (int j = 0; i + j <= ChebyshevModel::kDegree; ++j)
    {
      const double size = std::fabs(model.c[ChebyshevModel::Index(i, j)]);
      along[0] += size * i;
      along[1] += size * j;
    }
  }
}

class FaceTask
{
public:
  FaceTask(ElementFunctions& functions, int face)
    : Functions(functions)
    , Face(FacesOf(functions.GetShape())[static_cast<std::size_t>(face)])
    , Outward(-FacePlanesOf(functions.GetShape())[static_cast<std::size_t>(face)].gradient)
    , Axes{ (Face.direction + 1) % 3, (Face.direction + 2) % 3, Face.direction }
  {
  }

  [[nodiscard]] std::vector<PieceBox> Pieces() const
  {
    std::vector<PieceBox> pieces;
    for (PieceBox& piece : Functions.Pieces())
    {
      if (Functions.IsOnCube(piece, Face.direction, Face.upper))
      {
        const double end = Face.upper ? 1.0 : -1.0;
        piece.lower[Face.direction] = end;
        piece.upper[Face.direction] = end;
        pieces.push_back(piece);
      }
    }
    return pieces;
  }

  FacePart Look(const PieceBox& box)
  {
    const IntegralQuestion& question = Functions.Question();
    // The box takes the piece's whole thickness, for the model at its end.
    PieceBox thick = box;
    thick.lower[Face.direction] = -1.0;
    thick.upper[Face.direction] = 1.0;
    const ChebyshevModel b = ChebyshevModel::Second();
    const ChebyshevModel c(Face.upper ? 1.0 : -1.0);
    const PointedModels place(c);
    FacePart part{ box, Sums(question.Quantities()), std::vector<double>(question.Quantities()),
      -1 };
    if (IsClippedOff(Functions, box))
    {
      return part;
    }
    const auto clipped = ClippedPart(Functions, thick, Axes, place);
    if (clipped && clipped->IsEmpty())
    {
      return part;
    }
    const SurfaceModels models(Functions, thick, Axes, place, box);
    const auto eta = EtaModels(Functions, thick, Axes, b, c);
    std::array<ChebyshevModel, 3> normal;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::array<ChebyshevModel, 3> cofactors = Cofactors(models.jacobian, i);
      normal[i] = Outward.x * cofactors[0] + Outward.y * cofactors[1] + Outward.z * cofactors[2];
    }
    const double radius = Functions.Radius();
    const Interval widths =
      Functions.HalfWidth(thick, Axes[0]) * Functions.HalfWidth(thick, Axes[1]);
    const ChebyshevModel collapse = Collapses(eta);
    const ChebyshevModel square = Dot(normal, normal);
    ChebyshevModel length = SquareRoot(square);
    std::array<double, 2> rough{ 0.0, 0.0 };
    // At a collapsed edge the normal vanishes. Its length is small there, but not smooth.
    const bool vanishes = !std::isfinite(length.error);
    if (vanishes)
    {
      length = ChebyshevModel(Sqrt(square.TightRange()));
      AddVariation(square, rough);
    }
    const ChebyshevModel area = length * collapse;
    bool anyRange = !clipped;
    const auto add = [&](std::size_t q, const ChebyshevModel& density, const Interval& scale)
    {
      if (!vanishes)
      {
        AddRoughness(density, rough);
      }
      anyRange = anyRange || (!vanishes && IsRange(density));
      part.sums[q] = (clipped ? clipped->Integral(density) : PartOf(density)) * scale;
      // Where the clips are undecided, half of the part is assumed to count.
      const double share = clipped ? clipped->Part() : 0.5;
      const double magnitude = 4.0 * share * density.Norm() * scale.Magnitude();
      part.magnitudes[q] = std::isfinite(magnitude) ? magnitude : 0.0;
    };
    const Interval unit = widths * Interval(radius * radius);
    add(0, area, unit);
    part.sums[0].lower = std::max(part.sums[0].lower, 0.0);
    if (question.field == nullptr)
    {
      part.direction = Roughest(part, rough, box, anyRange);
      return part;
    }
    const Interval scale = unit * Interval(std::ldexp(1.0, Functions.FieldExponent()));
    std::vector<ChebyshevModel> values = models.field;
    if (question.field->mapping != Mapping::Identity)
    {
      const WeighedField field = Weigh(models, question.field->mapping);
      const ChebyshevModel inverse = Reciprocal(models.determinant);
      for (std::size_t k = 0; k < values.size(); ++k)
      {
        values[k] =
          ChebyshevModel(Interval(std::pow(radius, field.power - 3))) * (field.values[k] * inverse);
      }
    }
    for (std::size_t k = 0; k < values.size(); ++k)
    {
      add(k + 1, values[k] * area, scale);
    }
    if (question.HasFlux())
    {
      // Since det J > 0, the product of the tangents points outwards.
      const ChebyshevModel flux = Dot({ values[0], values[1], values[2] }, normal) * collapse;
      add(part.sums.size() - 1, flux, scale);
    }
    part.direction = Roughest(part, rough, box, anyRange);
    return part;
  }

private:
  /// Encloses the integral over any part of the square.
  static Interval PartOf(const ChebyshevModel& density)
  {
    const Interval range = density.TightRange();
    return Interval(4.0) * Interval(std::min(range.lower, 0.0), std::max(range.upper, 0.0));
  }

  [[nodiscard]] ChebyshevModel Collapses(const std::array<ChebyshevModel, 3>& eta) const
  {
    // det dxi / deta over the extent of the face's own direction.
    const int d = Face.direction;
    switch (Functions.GetShape())
    {
      case Shape::Tetrahedron:
        return d == 2 ? Collapse(eta[1]) : Collapse(eta[2]);
      case Shape::Pyramid:
        return d == 2 ? ChebyshevModel(1.0) : Collapse(eta[2]);
      case Shape::Prism:
        return d == 1 ? Collapse(eta[2]) : ChebyshevModel(1.0);
      default:
        return 1.0;
    }
  }

  /// The direction of the subdivision; -1: the part is too small.
  [[nodiscard]] int Roughest(const FacePart& part, const std::array<double, 2>& rough,
    const PieceBox& box, bool widest) const
  {
    const auto width = [&box](int d) { return box.upper[d] - box.lower[d]; };
    const bool second =
      part.sums[0].IsFinite() && !widest ? rough[1] > rough[0] : width(Axes[1]) > width(Axes[0]);
    const int direction = second ? Axes[1] : Axes[0];
    return width(direction) > kSmallestFaceBox ? direction : -1;
  }

  ElementFunctions& Functions;
  ShapeFace Face;
  Vec3 Outward;
  std::array<int, 3> Axes;
};
} // namespace

Sums IntegrateFace(ElementFunctions& functions, int face, const std::vector<double>& allowed,
  std::int64_t boxes, std::vector<double>& magnitudes)
{
  FaceTask task(functions, face);
  std::vector<FacePart> parts;
  for (const PieceBox& piece : task.Pieces())
  {
    parts.push_back(task.Look(piece));
  }
  const auto badness = [&allowed](const Sums& sums)
  {
    double worst = 0.0;
    for (std::size_t q = 0; q < sums.size(); ++q)
    {
      const double width =
        sums[q].IsFinite() ? sums[q].Width() / allowed[q] : std::numeric_limits<double>::infinity();
      worst = std::max(worst, width);
    }
    return worst;
  };
  const auto total = [&parts](std::size_t quantities)
  {
    Sums sums(quantities);
    for (const FacePart& part : parts)
    {
      AddTo(sums, part.sums);
    }
    return sums;
  };
  const std::size_t quantities = functions.Question().Quantities();
  for (std::int64_t looked = 0; looked < boxes && badness(total(quantities)) > 1.0; looked += 2)
  {
    const auto worst = std::ranges::max_element(parts, {},
      [&](const FacePart& part) { return part.direction < 0 ? -1.0 : badness(part.sums); });
    if (worst == parts.end() || worst->direction < 0)
    {
      break;
    }
    const int d = worst->direction;
    PieceBox upper = worst->box;
    PieceBox lower = worst->box;
    const double middle = 0.5 * (lower.lower[d] + lower.upper[d]);
    lower.upper[d] = middle;
    upper.lower[d] = middle;
    *worst = task.Look(lower);
    parts.push_back(task.Look(upper));
  }
  for (std::size_t q = 0; q < quantities; ++q)
  {
    for (const FacePart& part : parts)
    {
      magnitudes[q] += part.magnitudes[q];
    }
  }
  return total(quantities);
}
} // namespace pixelexact
