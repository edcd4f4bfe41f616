// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Faces/FacePairs.h"

#include "Core/Faces/FaceSampler.h"
#include "Core/Math/Rounding.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <atomic>

namespace pixelexact
{
namespace
{
/// No plane of a usual mesh is normal to this direction, so that few faces have the same place
/// along it.
constexpr Vec3 kDirection{ 0.6180339887498949, 0.7548776662466927, 0.5698402909980532 };

/// The interval along kDirection that may hold a face's centre.
struct Place
{
  double lower = 0.0;
  double upper = 0.0;
  ElementFace face;
};

bool IsWithin(const Vec3& a, const Vec3& b, const Vec3& tolerance)
{
  return glm::all(glm::lessThanEqual(glm::abs(a - b), tolerance));
}

/// Compares two faces. Keeps scratch arrays.
class Comparison
{
public:
  Comparison(const Mesh& mesh, const FaceGrids& grids, std::span<const Vec3> uncertainty)
    : mesh_(mesh)
    , Grids(grids)
    , Uncertainty(uncertainty)
    , Sampler(mesh)
  {
  }

  bool ArePair(const ElementFace& one, const ElementFace& other)
  {
    return Turn(one, other).has_value();
  }

  /// None where they are no pair.
  std::optional<FaceTurn> Turn(const ElementFace& one, const ElementFace& other)
  {
    const int corners = Reference(one).corners;
    if (one.element == other.element || corners != Reference(other).corners)
    {
      return std::nullopt;
    }
    Tolerance = Uncertainty[one.element] + Uncertainty[other.element];
    const int order = std::max(
      mesh_.map.SpaceOf(one.element).MaxOrder(), mesh_.map.SpaceOf(other.element).MaxOrder());
    const auto points = Grids.Closed(corners, order);
    Sampler.Sample(one.element, one.face, points, Mine);
    const auto cornersOfMine = CornersOf(one);
    const auto cornersOfOther = CornersOf(other);
    for (int start = 0; start < corners; ++start)
    {
      for (const int step : { 1, corners - 1 })
      {
        // Corner c of one face is corner `turned[c]` of the other.
        std::array<std::size_t, 4> turned{};
        bool fits = true;
        for (int c = 0; c < corners && fits; ++c)
        {
          const auto at = static_cast<std::size_t>((start + c * step) % corners);
          turned[static_cast<std::size_t>(c)] = at;
          fits =
            IsWithin(cornersOfMine[static_cast<std::size_t>(c)], cornersOfOther[at], Tolerance);
        }
        const FaceTurn turn = TurnOf(turned, static_cast<std::size_t>(corners));
        if (fits && AreAlike(other, points, turn))
        {
          return turn;
        }
      }
    }
    return std::nullopt;
  }

private:
  [[nodiscard]] const ReferenceFace& Reference(const ElementFace& face) const
  {
    return ReferenceFaceOf(mesh_.ShapeOf(face.element), face.face);
  }

  std::array<Vec3, 4> CornersOf(const ElementFace& face)
  {
    constexpr FacePoint kQuadrilateral[] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
    constexpr FacePoint kTriangle[] = { { 0, 0 }, { 1, 0 }, { 0, 1 } };
    Sampler.Sample(face.element, face.face,
      Reference(face).corners == 3 ? std::span<const FacePoint>(kTriangle) : kQuadrilateral,
      Others);
    std::array<Vec3, 4> corners{};
    std::ranges::transform(Others, corners.begin(), &FaceSample::x);
    return corners;
  }

  /// The map that takes corner c to corner `turned[c]`.
  static FaceTurn TurnOf(const std::array<std::size_t, 4>& turned, std::size_t corners)
  {
    constexpr FacePoint kPlaces[2][4] = { { { 0, 0 }, { 1, 0 }, { 0, 1 }, {} },
      { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } } };
    const auto& place = kPlaces[corners - 3];
    return { place[turned[0]], place[turned[1]], place[turned[corners - 1]] };
  }

  /// Whether all points agree, and the elements lie on different sides.
  bool AreAlike(const ElementFace& other, std::span<const FacePoint> points, const FaceTurn& turn)
  {
    Turned.resize(points.size());
    std::ranges::transform(
      points, Turned.begin(), [&turn](const FacePoint& point) { return turn.At(point); });
    Sampler.Sample(other.element, other.face, Turned, Others);
    double sides = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      if (!IsWithin(Mine[i].x, Others[i].x, Tolerance))
      {
        return false;
      }
      sides += glm::dot(Mine[i].normal, Others[i].normal);
    }
    return sides < 0.0;
  }

  const Mesh& mesh_;
  const FaceGrids& Grids;
  std::span<const Vec3> Uncertainty;
  FaceSampler Sampler;
  Vec3 Tolerance{ 0.0 };
  std::vector<FaceSample> Mine;
  std::vector<FaceSample> Others;
  std::vector<FacePoint> Turned;
};

std::vector<Place> SortedPlaces(
  const Mesh& mesh, const FaceNumbers& numbers, std::span<const Vec3> uncertainty)
{
  std::vector<Place> places(numbers.Faces());
  tbb::parallel_for(tbb::blocked_range<int>(0, mesh.Elements()),
    [&](const tbb::blocked_range<int>& range)
    {
      FaceSampler sampler(mesh);
      std::vector<FaceSample> samples;
      for (int e = range.begin(); e < range.end(); ++e)
      {
        for (int f = 0; f < numbers.FacesOfElement(e); ++f)
        {
          const int corners = ReferenceFaceOf(mesh.ShapeOf(e), f).corners;
          const FacePoint centre =
            corners == 3 ? FacePoint{ 1.0 / 3.0, 1.0 / 3.0 } : FacePoint{ 0.5, 0.5 };
          sampler.Sample(e, f, std::span(&centre, 1), samples);
          const Vec3& x = samples.front().x;
          const double along = glm::dot(x, kDirection);
          const double off = glm::dot(uncertainty[e] + Gamma(4) * glm::abs(x), kDirection);
          places[numbers.NumberOf(e, f)] = { along - off, along + off, { e, f } };
        }
      }
    });
  tbb::parallel_sort(places,
    [](const Place& a, const Place& b)
    { return a.lower != b.lower ? a.lower < b.lower : a.face < b.face; });
  return places;
}

/// Keeps the first of the faces that are added, by element and face, in any order of additions.
class FirstFace
{
public:
  void Add(const ElementFace& face)
  {
    std::uint64_t known = Packed.load(std::memory_order_relaxed);
    const std::uint64_t added = Pack(face);
    while (added < known && !Packed.compare_exchange_weak(known, added, std::memory_order_relaxed))
    {
    }
  }
  /// Whether adding this face would change nothing.
  [[nodiscard]] bool IsBefore(const ElementFace& face) const
  {
    return Packed.load(std::memory_order_relaxed) <= Pack(face);
  }
  [[nodiscard]] ElementFace Get() const
  {
    const std::uint64_t packed = Packed.load(std::memory_order_relaxed);
    return packed == kNone ? ElementFace{}
                           : ElementFace{ static_cast<std::int32_t>(packed >> 3U),
                               static_cast<std::int32_t>(packed & 7U) };
  }

private:
  static constexpr std::uint64_t kNone = ~std::uint64_t{ 0 };
  static std::uint64_t Pack(const ElementFace& face)
  {
    return static_cast<std::uint64_t>(face.element) << 3U | static_cast<std::uint64_t>(face.face);
  }
  std::atomic<std::uint64_t> Packed{ kNone };
};
} // namespace

std::optional<FaceTurn> FindFaceTurn(const Mesh& mesh, const FaceGrids& grids,
  std::span<const Vec3> uncertainty, const ElementFace& one, const ElementFace& other)
{
  return Comparison(mesh, grids, uncertainty).Turn(one, other);
}

std::vector<ElementFace> FindFacePairs(const Mesh& mesh, const FaceNumbers& numbers,
  const FaceGrids& grids, std::span<const Vec3> uncertainty)
{
  const auto places = SortedPlaces(mesh, numbers, uncertainty);
  std::vector<FirstFace> first(numbers.Faces());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, places.size(), 256),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      Comparison comparison(mesh, grids, uncertainty);
      for (std::size_t i = range.begin(); i < range.end(); ++i)
      {
        const ElementFace& one = places[i].face;
        FirstFace& ofOne = first[numbers.NumberOf(one.element, one.face)];
        for (std::size_t j = i + 1; j < places.size() && places[j].lower <= places[i].upper; ++j)
        {
          const ElementFace& other = places[j].face;
          FirstFace& ofOther = first[numbers.NumberOf(other.element, other.face)];
          const bool known = ofOne.IsBefore(other) && ofOther.IsBefore(one);
          if (!known && comparison.ArePair(one, other))
          {
            ofOne.Add(other);
            ofOther.Add(one);
          }
        }
      }
    });
  std::vector<ElementFace> pairs(numbers.Faces());
  std::ranges::transform(first, pairs.begin(), &FirstFace::Get);
  return pairs;
}
} // namespace pixelexact
