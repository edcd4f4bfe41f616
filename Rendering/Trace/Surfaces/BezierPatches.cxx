// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/BezierPatches.h"

#include "Core/Basis/ChangeOfBasis.h"
#include "Core/Math/Rounding.h"
#include "Core/Shape/ShapeFace.h"
#include "Trace/Surfaces/Arguments.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <utility>

namespace pixelexact
{
struct BezierPatches::Storage
{
  std::vector<Space> spaces;
  std::vector<std::int32_t> spaceOf;
  std::vector<std::int64_t> offset;
  std::vector<double> coefficients;
  std::vector<double> centre;
  std::vector<double> size;
  std::vector<double> uncertainty;
  std::vector<Box3> boxes;

  explicit Storage(std::span<const BezierPatch> patches);
  [[nodiscard]] Mesh GetMesh() const
  {
    return { { spaces, spaceOf, offset, coefficients, 3 }, centre, size, uncertainty };
  }
  [[nodiscard]] std::vector<CurvedPart> Parts() const;
};

namespace
{
/// The face xi_3 = -1 of a hexahedron, in FacesOf.
constexpr std::int32_t kFace = 0;

void Check(const BezierPatch& patch, std::size_t number)
{
  const auto refuse = [number](const std::string& why)
  { Refuse(("patch " + std::to_string(number)).c_str(), why.c_str()); };
  for (const int n : patch.degree)
  {
    if (n < 1 || n > BezierPatches::kHighestDegree)
    {
      refuse("its degree is " + std::to_string(n) + "; it must lie from 1 to " +
        std::to_string(BezierPatches::kHighestDegree));
    }
  }
  const auto needed =
    static_cast<std::size_t>(patch.degree[0] + 1) * static_cast<std::size_t>(patch.degree[1] + 1);
  if (patch.points.size() != needed)
  {
    refuse("it has " + std::to_string(patch.points.size()) + " points where its degrees need " +
      std::to_string(needed));
  }
  if (!std::ranges::all_of(patch.points, IsFinite))
  {
    refuse("a point is not finite");
  }
}

Space SpaceFor(const BezierPatch& patch)
{
  return { Shape::Hexahedron, Form::Collapsed,
    { static_cast<std::uint8_t>(patch.degree[0]), static_cast<std::uint8_t>(patch.degree[1]), 0 } };
}
} // namespace

BezierPatches::Storage::Storage(std::span<const BezierPatch> patches)
{
  if (patches.empty())
  {
    Refuse("patches", "there are none");
  }
  std::map<Space, std::pair<std::int32_t, ChangeOfBasis>> known;
  std::vector<double> values;
  for (std::size_t k = 0; k < patches.size(); ++k)
  {
    const BezierPatch& patch = patches[k];
    Check(patch, k);
    const Space space = SpaceFor(patch);
    auto found = known.find(space);
    if (found == known.end())
    {
      std::vector<int> source(patch.points.size());
      std::iota(source.begin(), source.end(), 0);
      spaces.push_back(space);
      found = known
                .emplace(space,
                  std::pair(static_cast<std::int32_t>(spaces.size() - 1),
                    ChangeOfBasis::Hexahedron(space, Family::Bernstein, source)))
                .first;
    }
    spaceOf.push_back(found->second.first);
    offset.push_back(static_cast<std::int64_t>(coefficients.size()));
    // The patch lies in the convex hull of its points.
    Box3 box{ patch.points[0], patch.points[0] };
    for (const Vec3& x : patch.points)
    {
      box = { glm::min(box.lower, x), glm::max(box.upper, x) };
    }
    const Vec3 middle = 0.5 * box.lower + 0.5 * box.upper;
    const double extent = LargestOf(0.5 * box.upper - 0.5 * box.lower);
    const double unit = extent > 0.0 ? std::exp2(std::ceil(std::log2(extent))) : 1.0;
    const double off = 16.0 * kUnitRoundoff * (LargestOf(middle) + unit);
    boxes.push_back({ box.lower - off, box.upper + off });
    size.push_back(unit);
    uncertainty.push_back(off);
    const auto modes = static_cast<std::size_t>(space.Modes());
    const std::size_t first = coefficients.size();
    coefficients.resize(first + 3 * modes);
    for (std::size_t c = 0; c < 3; ++c)
    {
      const auto at = static_cast<int>(c);
      centre.push_back(middle[at]);
      values.clear();
      for (const Vec3& x : patch.points)
      {
        values.push_back((x[at] - middle[at]) / unit);
      }
      found->second.second.Apply(
        values, 0.0, std::span(coefficients).subspan(first + c * modes, modes));
    }
  }
}

std::vector<CurvedPart> BezierPatches::Storage::Parts() const
{
  std::vector<CurvedPart> parts;
  for (std::size_t k = 0; k < spaceOf.size(); ++k)
  {
    parts.push_back({ static_cast<std::int32_t>(k), kFace });
  }
  return parts;
}

BezierPatches::BezierPatches(std::span<const BezierPatch> patches)
  : BezierPatches(std::make_unique<const Storage>(patches))
{
  Seams = BezierSeams(patches);
}

BezierPatches::BezierPatches(std::unique_ptr<const Storage> storage)
  : CurvedSurface({ storage->GetMesh() }, storage->Parts(), storage->boxes)
  , Arrays(std::move(storage))
{
}

BezierPatches::~BezierPatches() = default;

double BezierPatches::Sagitta(
  const Ray& a, const SurfacePoint& atA, const Ray& b, const SurfacePoint& atB) const
{
  return Seams.Sagitta({ a, atA.position, b, atB.position }, atA, atB);
}
} // namespace pixelexact
