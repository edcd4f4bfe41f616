// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Location/Owners.h"

#include "Core/Base/Error.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <vector>

namespace pixelexact
{
namespace
{
class Counter final : public PreimageSink
{
public:
  explicit Counter(std::span<Owners> owners)
    : Result(owners)
    , LastElement(owners.size(), -1)
    , Inner(owners.size(), 0)
  {
  }

  void Found(int index, const Preimage& preimage) override
  {
    const auto at = static_cast<std::size_t>(index);
    ++Result[at].preimages;
    // An element's preimages come one after the other.
    if (LastElement[at] != preimage.element)
    {
      LastElement[at] = preimage.element;
      ++Result[at].elements;
    }
    Inner[at] += preimage.onFace ? 0 : 1;
  }

  void Undecided(int index, int /*element*/) override
  {
    Result[static_cast<std::size_t>(index)].coverage = Coverage::Undecided;
  }

  void Classify()
  {
    for (std::size_t i = 0; i < Result.size(); ++i)
    {
      Owners& owners = Result[i];
      if (owners.coverage == Coverage::Undecided)
      {
        continue;
      }
      owners.coverage = owners.preimages == 0 ? Coverage::None
        : Inner[i] > 1                        ? Coverage::Several
                                              : Coverage::Once;
    }
  }

private:
  std::span<Owners> Result;
  std::vector<int> LastElement;
  std::vector<int> Inner; ///< preimages that lie on no face
};
} // namespace

const char* Name(Coverage coverage)
{
  switch (coverage)
  {
    case Coverage::None:
      return "none";
    case Coverage::Once:
      return "once";
    case Coverage::Several:
      return "several";
    default:
      return "undecided";
  }
}

void FindOwnersOfTile(
  const Locator& locator, std::span<const Vec3> points, std::span<Owners> owners)
{
  if (owners.size() != points.size())
  {
    throw Error("owners of " + std::to_string(points.size()) + " points need an array of as many.");
  }
  std::ranges::fill(owners, Owners{});
  Counter counter(owners);
  locator.LocateAll(points, counter);
  counter.Classify();
}

void FindOwners(const Locator& locator, std::span<const Vec3> points, std::span<Owners> owners)
{
  if (owners.size() != points.size())
  {
    throw Error("owners of " + std::to_string(points.size()) + " points need an array of as many.");
  }
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), 256),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      FindOwnersOfTile(locator, points.subspan(range.begin(), range.size()),
        owners.subspan(range.begin(), range.size()));
    });
}
} // namespace pixelexact
