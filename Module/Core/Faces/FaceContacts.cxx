// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Faces/FaceContacts.h"

#include "Core/Faces/FaceProjection.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

namespace pixelexact
{
namespace
{
constexpr std::size_t kNone = ~std::size_t{ 0 };
constexpr std::size_t kSeveral = kNone - 1;

/// Counts the sample points of a face that lie on other faces.
struct Evidence
{
  bool hasArea = true;
  std::size_t points = 0;
  std::size_t covered = 0;
  std::size_t behind = kNone; ///< the one face on which they lie, by its place in the list
};

class Search
{
public:
  Search(const ElementIndex& index, const FaceGrids& grids, std::span<const Vec3> uncertainty,
    std::span<const ElementFace> faces, std::span<std::atomic<bool>> touched)
    : Index(index)
    , mesh_(index.GetMesh())
    , Grids(grids)
    , Uncertainty(uncertainty)
    , Faces(faces)
    , Touched(touched)
    , Sampler(mesh_)
    , Projection(mesh_, grids)
  {
  }

  Evidence Look(const ElementFace& face)
  {
    const Space& space = mesh_.map.SpaceOf(face.element);
    const int corners = ReferenceFaceOf(space.shape, face.face).corners;
    Sampler.Sample(face.element, face.face, Grids.Open(corners, space.MaxOrder()), Samples);
    Evidence evidence;
    evidence.points = Samples.size();
    evidence.hasArea = HasArea(face.element);
    if (!evidence.hasArea)
    {
      return evidence;
    }
    Covered.assign(Samples.size(), 0);
    const Vec3& mine = Uncertainty[face.element];
    Box3 region{ Samples.front().x, Samples.front().x };
    for (const FaceSample& sample : Samples)
    {
      region.lower = glm::min(region.lower, sample.x - mine);
      region.upper = glm::max(region.upper, sample.x + mine);
    }
    Index.FindNear(region, Near);
    for (const int element : Near)
    {
      if (element != face.element)
      {
        LookAt(element, mine, evidence);
      }
    }
    evidence.covered = static_cast<std::size_t>(std::ranges::count(Covered, 1));
    return evidence;
  }

private:
  [[nodiscard]] bool HasArea(int element) const
  {
    const Vec3 inUnits = Uncertainty[element] / mesh_.size[element];
    const double most = 2.0 * std::max({ inUnits.x, inUnits.y, inUnits.z });
    return std::ranges::any_of(Samples,
      [most](const FaceSample& sample)
      {
        const double extent = std::max(glm::length(sample.first), glm::length(sample.second));
        return glm::length(glm::cross(sample.first, sample.second)) > most * extent;
      });
  }

  /// Compares the samples with the unpaired faces of an element.
  void LookAt(int element, const Vec3& mine, Evidence& evidence)
  {
    const auto first = std::ranges::lower_bound(Faces, ElementFace{ element, 0 });
    if (first == Faces.end() || first->element != element)
    {
      return;
    }
    const Box3& box = Index.ElementBox(element);
    const Box3 wide{ box.lower - mine, box.upper + mine };
    Here.clear();
    Numbers.clear();
    for (std::size_t i = 0; i < Samples.size(); ++i)
    {
      if (wide.Contains(Samples[i].x))
      {
        Here.push_back(Samples[i]);
        Numbers.push_back(i);
      }
    }
    if (Here.empty())
    {
      return;
    }
    for (auto other = first; other != Faces.end() && other->element == element; ++other)
    {
      Projection.Find(element, other->face, Here, mine + Uncertainty[element], Found);
      const auto number = static_cast<std::size_t>(other - Faces.begin());
      for (std::size_t i = 0; i < Here.size(); ++i)
      {
        if (Found[i] != 0)
        {
          Covered[Numbers[i]] = 1;
          Touched[number].store(true, std::memory_order_relaxed);
          evidence.behind =
            evidence.behind == kNone || evidence.behind == number ? number : kSeveral;
        }
      }
    }
  }

  const ElementIndex& Index;
  const Mesh& mesh_;
  const FaceGrids& Grids;
  std::span<const Vec3> Uncertainty;
  std::span<const ElementFace> Faces;
  std::span<std::atomic<bool>> Touched;
  FaceSampler Sampler;
  FaceProjection Projection;
  std::vector<FaceSample> Samples;
  std::vector<char> Covered; ///< per sample
  std::vector<int> Near;
  std::vector<FaceSample> Here; ///< samples within an element's box
  std::vector<std::size_t> Numbers;
  std::vector<char> Found;
};

/// Whether all points of each of two faces lie on the other, and on no other face.
bool AreWhole(std::span<const Evidence> evidence, std::size_t one)
{
  const std::size_t other = evidence[one].behind;
  return other < evidence.size() && evidence[other].behind == one &&
    evidence[one].covered == evidence[one].points &&
    evidence[other].covered == evidence[other].points;
}
} // namespace

std::vector<FaceContact> FindFaceContacts(const ElementIndex& index, const FaceGrids& grids,
  std::span<const Vec3> uncertainty, std::span<const ElementFace> faces)
{
  std::vector<std::atomic<bool>> touched(faces.size());
  std::vector<Evidence> evidence(faces.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, faces.size(), 64),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      Search search(index, grids, uncertainty, faces, touched);
      for (std::size_t i = range.begin(); i < range.end(); ++i)
      {
        evidence[i] = search.Look(faces[i]);
      }
    });
  std::vector<FaceContact> contacts(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const Evidence& known = evidence[i];
    if (!known.hasArea)
    {
      contacts[i].kind = FaceKind::Interior;
    }
    else if (AreWhole(evidence, i))
    {
      contacts[i] = { FaceKind::Interior, faces[known.behind] };
    }
    else if (known.covered == known.points)
    {
      contacts[i].kind = FaceKind::Hanging;
    }
    else if (known.covered > 0 || touched[i].load(std::memory_order_relaxed))
    {
      contacts[i].kind = FaceKind::Partly;
    }
  }
  return contacts;
}
} // namespace pixelexact
