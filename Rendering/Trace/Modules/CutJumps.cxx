// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Modules/CutJumps.h"

#include "Core/Location/Sample.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pixelexact
{
namespace
{
constexpr int kBisections = 45;
/// Largest count of pairs that are located together.
constexpr std::size_t kPairsTogether = 256;
/// Part of its length by which a segment is moved into the mesh, if the surface is the mesh's
/// boundary and the mesh is concave there.
constexpr double kIntoMesh = 1.0 / 16.0;

/// A place in an element.
struct PlaceInElement
{
  std::int32_t element = -1; ///< -1: outside, or not decided
  Vec3 xi{ 0.0 };
};

/// The segment between the hits of two pixels, and what bisection found on it.
struct CutPair
{
  std::size_t pixel = 0;
  std::size_t other = 0;
  Vec3 from{ 0.0 };
  Vec3 to{ 0.0 };
  double here = 0.0;  ///< part of the way, in the pixel's element
  double there = 1.0; ///< part of the way, beyond it
  PlaceInElement placeHere;
  PlaceInElement placeThere;
  double jump = 0.0;

  [[nodiscard]] Vec3 At(double part) const { return glm::mix(from, to, part); }
  [[nodiscard]] bool IsFound() const { return placeThere.element >= 0; }
};

bool IsTangent(const Vec3& chord, const Vec3& normal)
{
  return std::fabs(glm::dot(chord, normal)) <= CutJumps::kSteepest * glm::length(chord);
}

/// The two pixels are neighbours on one surface, in different elements.
bool AreBetweenElements(const SampleBuffers& samples, std::size_t i, std::size_t j)
{
  if (samples.verdict[i] != kExactPixel || samples.verdict[j] != kExactPixel ||
    samples.layer[i] != samples.layer[j] || samples.element[i] == samples.element[j])
  {
    return false;
  }
  const Vec3 chord = samples.position[j] - samples.position[i];
  return IsTangent(chord, samples.normal[i]) && IsTangent(chord, samples.normal[j]);
}

CutPair MakePair(const SampleBuffers& samples, std::size_t i, std::size_t j)
{
  const auto placeOf = [&](std::size_t pixel) -> PlaceInElement {
    return { static_cast<std::int32_t>(samples.element[pixel]), samples.xi[pixel] };
  };
  CutPair pair;
  pair.pixel = i;
  pair.other = j;
  pair.from = samples.position[i];
  pair.to = samples.position[j];
  pair.placeHere = placeOf(i);
  pair.placeThere = placeOf(j);
  return pair;
}

std::vector<CutPair> PairsOf(const SampleBuffers& samples)
{
  std::vector<CutPair> pairs;
  const auto width = static_cast<std::size_t>(samples.width);
  for (std::size_t i = 0; i < samples.Size(); ++i)
  {
    if ((i + 1) % width != 0 && AreBetweenElements(samples, i, i + 1))
    {
      pairs.push_back(MakePair(samples, i, i + 1));
    }
    if (i + width < samples.Size() && AreBetweenElements(samples, i, i + width))
    {
      pairs.push_back(MakePair(samples, i, i + width));
    }
  }
  return pairs;
}

/// Narrows the segments to where they leave the pixels' elements.
void Bisect(const Locator& locator, std::span<CutPair> pairs)
{
  std::vector<Vec3> points(pairs.size());
  std::vector<std::int32_t> element(pairs.size());
  std::vector<Vec3> xi(pairs.size());
  std::vector<Verdict> verdict(pairs.size());
  SampleTarget target;
  target.element = element;
  target.xi = xi;
  target.verdict = verdict;
  for (int k = 0; k < kBisections; ++k)
  {
    std::ranges::transform(pairs, points.begin(),
      [](const CutPair& pair) { return pair.At((pair.here + pair.there) / 2.0); });
    SampleTile(locator, nullptr, points, target);
    for (std::size_t i = 0; i < pairs.size(); ++i)
    {
      CutPair& pair = pairs[i];
      const double middle = (pair.here + pair.there) / 2.0;
      const bool isInside = verdict[i] == Verdict::Inside;
      if (isInside && element[i] == pair.placeHere.element)
      {
        pair.here = middle;
        pair.placeHere.xi = xi[i];
        continue;
      }
      pair.there = middle;
      pair.placeThere = { isInside ? element[i] : -1, xi[i] };
    }
  }
}

/// Segments between points of a hollow surface of the mesh lie outside: those are moved into it.
void BisectInside(const Scene& scene, const SampleBuffers& samples, std::span<CutPair> pairs)
{
  std::vector<CutPair> moved;
  for (const CutPair& pair : pairs)
  {
    if (!pair.IsFound() && scene.layers[samples.layer[pair.pixel]].surface->IsOfMesh())
    {
      CutPair inside = MakePair(samples, pair.pixel, pair.other);
      const double by = kIntoMesh * glm::length(inside.to - inside.from);
      inside.from -= by * samples.normal[pair.pixel];
      inside.to -= by * samples.normal[pair.other];
      moved.push_back(inside);
    }
  }
  Bisect(*scene.locator, moved);
  for (const CutPair& inside : moved)
  {
    const auto same = std::ranges::find_if(pairs,
      [&](const CutPair& pair)
      { return pair.pixel == inside.pixel && pair.other == inside.other; });
    *same = inside;
  }
}

double ValueAt(
  const Mesh& mesh, const Layer& layer, const PlaceInElement& place, const Vec3& x, const Vec3& n)
{
  std::vector<double> values(static_cast<std::size_t>(layer.field->values.components));
  EvaluateAt(mesh, *layer.field, place.element, std::span(&place.xi, 1), values, {},
    { std::span(&x, 1), std::span(&n, 1) });
  return ComponentOf(values, layer.component);
}

void EvaluateJump(const Scene& scene, const SampleBuffers& samples, CutPair& pair)
{
  const Mesh& mesh = scene.locator->GetMesh();
  const Layer& layer = scene.layers[samples.layer[pair.pixel]];
  const Vec3 normal =
    glm::normalize(glm::mix(samples.normal[pair.pixel], samples.normal[pair.other], pair.here));
  const double here = ValueAt(mesh, layer, pair.placeHere, pair.At(pair.here), normal);
  const double there = ValueAt(mesh, layer, pair.placeThere, pair.At(pair.there), normal);
  pair.jump = std::fabs(there - here);
}

/// The largest finite value seen of each layer, by its size.
std::vector<double> SizesOf(const Scene& scene, const SampleBuffers& samples)
{
  std::vector<double> sizes(scene.layers.size(), 0.0);
  for (std::size_t i = 0; i < samples.Size(); ++i)
  {
    if (samples.verdict[i] == kExactPixel && std::isfinite(samples.value[i]))
    {
      double& size = sizes[samples.layer[i]];
      size = std::max(size, std::fabs(samples.value[i]));
    }
  }
  return sizes;
}

void Write(CutPair& pair, double rounding, SampleBuffers& samples, CutJumps& jumps)
{
  if (!pair.IsFound())
  {
    ++jumps.notFound;
    return;
  }
  if (!std::isfinite(pair.jump))
  {
    ++jumps.notFinite;
    return;
  }
  const double jump = pair.jump <= rounding ? 0.0 : pair.jump;
  ++(jump > 0.0 ? jumps.jumping : jumps.continuous);
  double& written = samples.jump[pair.pixel];
  written = std::isnan(written) ? jump : std::max(written, jump);
  if (jump > 0.0 && (!jumps.largest || jump > jumps.largest->jump))
  {
    jumps.largest = { jump, pair.At(pair.here), { pair.placeHere.element, pair.placeThere.element },
      samples.layer[pair.pixel] };
  }
}
} // namespace

CutJumps FindCutJumps(const Scene& scene, SampleBuffers& samples)
{
  std::vector<CutPair> pairs = PairsOf(samples);
  const std::size_t groups = (pairs.size() + kPairsTogether - 1) / kPairsTogether;
  tbb::parallel_for(std::size_t(0), groups,
    [&](std::size_t group)
    {
      const std::size_t begin = group * kPairsTogether;
      const std::span some =
        std::span(pairs).subspan(begin, std::min(kPairsTogether, pairs.size() - begin));
      Bisect(*scene.locator, some);
      BisectInside(scene, samples, some);
      for (CutPair& pair : some)
      {
        if (pair.IsFound())
        {
          EvaluateJump(scene, samples, pair);
        }
      }
    });
  const std::vector<double> sizes = SizesOf(scene, samples);
  CutJumps jumps;
  for (CutPair& pair : pairs)
  {
    Write(pair, CutJumps::kRounding * sizes[samples.layer[pair.pixel]], samples, jumps);
  }
  return jumps;
}
} // namespace pixelexact
