// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Faces/FaceJumps.h"

#include "Core/Base/Error.h"
#include "Core/Bounds/ElementBounds.h"
#include "Core/Element/FieldFunction.h"
#include "Core/Element/ParallelProgress.h"
#include "Core/Element/RangeIngredients.h"
#include "Core/Faces/FacePairs.h"
#include "Core/Faces/FacePlaces.h"
#include "Core/Faces/FaceSampler.h"
#include "Core/Faces/FacesBehind.h"
#include "Core/Location/Sample.h"
#include "Core/Shape/ShapeFace.h"

#include <glm/geometric.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <span>

namespace pixelexact
{
namespace
{
/// Bounds the error of a sample's xi, along each axis: roundings of its parameters and of the sums.
constexpr double kPlaceError = 64.0 * kUnitRoundoff;
/// The order for which an expression is sampled.
constexpr int kOrderOfExpressions = 8;

int HighestOrderOf(const Expansion& values)
{
  int order = 1;
  for (const Space& space : values.spaces)
  {
    order = std::max(order, space.MaxOrder());
  }
  return order;
}

/// Bounds the error of values that are computed at samples, for the norm of all components.
double SampleErrorOf(const Field& field, int element)
{
  const Space& space = field.values.SpaceOf(element);
  const PieceForm::Piece whole{};
  const PieceForm& form = PieceForm::Of(space, 0);
  const auto degree = space.TensorDegree();
  const double gamma = Gamma(degree[0] + degree[1] + degree[2] + 12);
  double error = 0.0;
  for (int c = 0; c < field.values.components; ++c)
  {
    const ScaledModes modes(space,
      field.values.Coefficients(element) +
        static_cast<std::size_t>(c) * static_cast<std::size_t>(space.Modes()),
      1);
    if (!modes.finite)
    {
      return kInfinity;
    }
    const RangeIngredient value{ &modes, 0, Part::Value };
    double one = value.RoundingInKernels(0, whole);
    for (const Part part : kDerivatives)
    {
      // The bound of rounding is gamma times a bound of the derivative.
      one += kPlaceError * form.ErrorBound(part, whole, value.Modes()) / gamma;
    }
    error += std::ldexp(one, modes.exponent);
  }
  return error * (1.0 + 0x1p-20) + kUnderflow;
}

class JumpFinder
{
public:
  JumpFinder(const Locator& locator, const FaceTable& table, const Field& field)
    : Table(table)
    , field_(field)
    , mesh_(locator.GetMesh())
    , Components(static_cast<std::size_t>(field.values.components))
    , FieldOrder(field.function != nullptr ? kOrderOfExpressions : HighestOrderOf(field.values))
    , Grids(HighestOrderOf(mesh_.map))
    , Places(FieldOrder + HighestOrderOf(mesh_.map), FieldOrder)
    , Uncertainty(static_cast<std::size_t>(mesh_.Elements()))
    , Many(locator, table, Places, FieldOrder)
  {
    tbb::parallel_for(0, mesh_.Elements(),
      [&](int e) { Uncertainty[static_cast<std::size_t>(e)] = ImageUncertainty(mesh_, e); });
  }

  /// Finds what lies behind faces that meet parts of others.
  void FindMany(int element) { Many.Find(element); }

  [[nodiscard]] FaceJumps Of(int element) const
  {
    FaceJumps found;
    for (int f = 0; f < FacesOfElement(element); ++f)
    {
      const ElementFace face{ element, f };
      const FaceKind kind = Table.KindOf(element, f);
      const ElementFace other = Table.NeighbourOf(element, f);
      if (kind == FaceKind::Interior && other.element > element)
      {
        AddWhole(face, other, found);
      }
      else if (kind == FaceKind::Hanging || kind == FaceKind::Partly)
      {
        AddMany(face, found);
      }
    }
    return found;
  }

private:
  [[nodiscard]] int FacesOfElement(int element) const
  {
    return static_cast<int>(FacesOf(mesh_.ShapeOf(element)).size());
  }
  [[nodiscard]] const ReferenceFace& Reference(const ElementFace& face) const
  {
    return ReferenceFaceOf(mesh_.ShapeOf(face.element), face.face);
  }
  [[nodiscard]] int OrderOf(int element) const
  {
    return field_.function != nullptr ? FieldOrder : field_.values.SpaceOf(element).MaxOrder();
  }

  [[nodiscard]] std::vector<double> ValuesAt(int element, std::span<const Vec3> xi) const
  {
    std::vector<double> values(Components * xi.size());
    EvaluateAt(mesh_, field_, element, xi, values, {});
    return values;
  }

  struct Sampled
  {
    std::vector<double> jumps;
    bool isFinite = true;
    double size = 0.0;
  };
  [[nodiscard]] Sampled Compare(
    const std::vector<double>& here, const std::vector<double>& there) const
  {
    Sampled sampled;
    for (std::size_t i = 0; i < here.size(); i += Components)
    {
      double jump = 0.0;
      double one = 0.0;
      double other = 0.0;
      for (std::size_t c = i; c < i + Components; ++c)
      {
        jump = std::hypot(jump, here[c] - there[c]);
        one = std::hypot(one, here[c]);
        other = std::hypot(other, there[c]);
      }
      sampled.isFinite = sampled.isFinite && std::isfinite(jump);
      sampled.size = std::max({ sampled.size, one, other });
      sampled.jumps.push_back(jump);
    }
    return sampled;
  }

  /// Returns whether the samples have the largest jump.
  static bool KeepLargest(const Sampled& sampled, std::span<const Vec3> xi, FaceJump& jump)
  {
    const auto most = std::ranges::max_element(sampled.jumps);
    if (most == sampled.jumps.end() || !(*most >= jump.largest))
    {
      return false;
    }
    jump.largest = *most;
    jump.xi = xi[static_cast<std::size_t>(most - sampled.jumps.begin())];
    return true;
  }

  void AddWhole(const ElementFace& face, const ElementFace& other, FaceJumps& found) const;
  void AddMany(const ElementFace& face, FaceJumps& found) const;
  /// Adds the integrals over places of a face to a jump.
  void Integrate(const ElementFace& face, const FacePlaces& places, std::span<const double> jumps,
    std::span<const char> counts, FaceJump& jump) const;

  const FaceTable& Table;
  const Field& field_;
  const Mesh& mesh_;
  std::size_t Components;
  int FieldOrder;
  FaceGrids Grids;
  PlacesByOrder Places;
  std::vector<Vec3> Uncertainty;
  FacesBehind Many;
};

void JumpFinder::Integrate(const ElementFace& face, const FacePlaces& places,
  std::span<const double> jumps, std::span<const char> counts, FaceJump& jump) const
{
  FaceSampler sampler(mesh_);
  std::vector<FaceSample> samples;
  sampler.Sample(face.element, face.face, places.points, samples);
  const double size = mesh_.size[static_cast<std::size_t>(face.element)];
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    if (!counts.empty() && counts[i] == 0)
    {
      continue;
    }
    const double area = places.weights[i] * size * size *
      glm::length(glm::cross(samples[i].first, samples[i].second));
    jump.area += area;
    jump.square += area * jumps[i] * jumps[i];
  }
}

void JumpFinder::AddWhole(const ElementFace& face, const ElementFace& other, FaceJumps& found) const
{
  const std::optional<FaceTurn> turn = FindFaceTurn(mesh_, Grids, Uncertainty, face, other);
  if (!turn)
  {
    ++found.notFound;
    return;
  }
  const int corners = Reference(face).corners;
  const int order = std::max(OrderOf(face.element), OrderOf(other.element));
  const int mapOrder = std::max(
    mesh_.map.SpaceOf(face.element).MaxOrder(), mesh_.map.SpaceOf(other.element).MaxOrder());
  FaceJump jump{ face, other.element };
  bool isFinite = true;
  const auto compare = [&](std::span<const FacePoint> points)
  {
    std::vector<Vec3> here;
    std::vector<Vec3> there;
    for (const FacePoint& point : points)
    {
      here.push_back(Reference(face).At(point));
      there.push_back(Reference(other).At(turn->At(point)));
    }
    Sampled sampled = Compare(ValuesAt(face.element, here), ValuesAt(other.element, there));
    isFinite = isFinite && sampled.isFinite;
    found.size = sampled.isFinite ? std::max(found.size, sampled.size) : found.size;
    KeepLargest(sampled, here, jump);
    return sampled;
  };
  const Sampled chebyshev = compare(Places.ChebyshevOf(corners, order));
  const FacePlaces& gauss = Places.GaussOf(corners, order + mapOrder);
  const Sampled atGauss = compare(gauss.points);
  if (!isFinite)
  {
    ++found.notFinite;
    return;
  }
  const auto isPyramid = [&](int e) { return mesh_.ShapeOf(e) == Shape::Pyramid; };
  if (field_.function == nullptr && field_.mapping == Mapping::Identity &&
    !isPyramid(face.element) && !isPyramid(other.element))
  {
    const double cosine = std::cos(std::numbers::pi / (2.0 * PlacesByOrder::kPointsPerDegree));
    const double error = SampleErrorOf(field_, face.element) + SampleErrorOf(field_, other.element);
    jump.bound = (std::ranges::max(chebyshev.jumps) + error) / (cosine * cosine) * (1.0 + 0x1p-40);
  }
  Integrate(face, gauss, atGauss.jumps, {}, jump);
  found.faces.push_back(jump);
}

void JumpFinder::AddMany(const ElementFace& face, FaceJumps& found) const
{
  const ManyBehind& many = *Many.Of(face);
  const int order = FieldOrder + mesh_.map.SpaceOf(face.element).MaxOrder();
  const FacePlaces& places = Places.GaussOf(Reference(face).corners, order);
  // A part that two faces share counts on the face that lies in the other, else on the first.
  std::vector<char> counts(places.points.size(), 0);
  std::map<std::int32_t, std::vector<std::size_t>> byNeighbour;
  for (std::size_t i = 0; i < counts.size(); ++i)
  {
    const BehindFace& at = many.behind[i];
    found.notFound += at.verdict == Verdict::Unknown ? 1 : 0;
    if (at.verdict != Verdict::Inside)
    {
      continue;
    }
    const ManyBehind* const other = Many.Of(many.faces[i]);
    const bool isOtherNested = other != nullptr && other->isNested;
    if (many.isNested != isOtherNested ? many.isNested : face.element < at.element)
    {
      counts[i] = 1;
      byNeighbour[at.element].push_back(i);
    }
  }
  FaceJump jump{ face };
  std::vector<double> jumps(counts.size(), 0.0);
  for (const auto& [neighbour, points] : byNeighbour)
  {
    std::vector<Vec3> here;
    std::vector<Vec3> there;
    for (const std::size_t i : points)
    {
      here.push_back(Reference(face).At(places.points[i]));
      there.push_back(many.behind[i].xi);
    }
    const Sampled sampled = Compare(ValuesAt(face.element, here), ValuesAt(neighbour, there));
    if (!sampled.isFinite)
    {
      ++found.notFinite;
      return;
    }
    found.size = std::max(found.size, sampled.size);
    jump.neighbour = KeepLargest(sampled, here, jump) ? neighbour : jump.neighbour;
    for (std::size_t k = 0; k < points.size(); ++k)
    {
      jumps[points[k]] = sampled.jumps[k];
    }
  }
  if (!byNeighbour.empty())
  {
    Integrate(face, places, jumps, counts, jump);
    found.faces.push_back(jump);
  }
}
} // namespace

FaceJumps FindFaceJumps(const Locator& locator, const FaceTable& table, const Field& field,
  const std::function<void(double)>& progress)
{
  if (field.function != nullptr &&
    (field.function->NeedsNormals() || field.function->NeedsNeighbours()))
  {
    throw Unsupported("The jumps of '" + field.name + "' across faces are not available: " +
      (field.function->NeedsNormals() ? "it needs the normal of a surface."
                                      : "it is a jump itself; name the field."));
  }
  const int elements = locator.GetMesh().Elements();
  JumpFinder finder(locator, table, field);
  ParallelProgress first(progress, 0.0, 0.5, static_cast<std::size_t>(elements));
  tbb::parallel_for(0, elements,
    [&](int e)
    {
      finder.FindMany(e);
      first.Add();
    });
  std::vector<FaceJumps> ofElement(static_cast<std::size_t>(elements));
  ParallelProgress second(progress, 0.5, 1.0, static_cast<std::size_t>(elements));
  tbb::parallel_for(0, elements,
    [&](int e)
    {
      ofElement[static_cast<std::size_t>(e)] = finder.Of(e);
      second.Add();
    });
  second.Finish();
  FaceJumps all;
  for (const FaceJumps& one : ofElement)
  {
    all.faces.insert(all.faces.end(), one.faces.begin(), one.faces.end());
    all.notFound += one.notFound;
    all.notFinite += one.notFinite;
    all.size = std::max(all.size, one.size);
  }
  return all;
}
} // namespace pixelexact
