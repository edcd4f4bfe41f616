// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Bernstein/RootFinder.h"

#include "Core/Bernstein/BoxStack.h"
#include "Core/Bernstein/RootList.h"

#include <algorithm>

namespace pixelexact
{
namespace
{
/// Krawczyk's test first reaches 1 / (4 total degree) beyond the box, where hulls of derivatives
/// grow by less than a factor of two; then this many times as far, where they grow by at most e^16.
constexpr double kFarther = 32.0;
/// The finder tests only boxes narrower than this for whether splitting helps.
constexpr double kNarrow = 0x1p-6;
/// A side is narrow, compared with the longest.
constexpr double kUneven = 1.0 / 16.0;

class Search
{
public:
  Search(const PolynomialSystem& system, const RootSearch& options)
    : Options(options)
    , N(static_cast<std::size_t>(system.Variables()))
    , IsSquare(system.Variables() == system.Equations())
    , Reach(1.0 / (4.0 * std::max(1, system.Degree()[0] + system.Degree()[1] + system.Degree()[2])))
    , Boxes(system, options.smallest)
    , Roots(system)
  {
  }

  RootSearchResult Run()
  {
    while (!Boxes.IsEmpty())
    {
      if (Result.boxes >= Options.budget)
      {
        Result.budgetSpent = true;
        std::ranges::copy(Boxes.Parts(), std::back_inserter(Result.undecided));
        break;
      }
      ++Result.boxes;
      LookAtTop();
    }
    if (IsSquare)
    {
      JoinTouching();
    }
    Result.roots = Roots.Take();
    return std::move(Result);
  }

private:
  enum class Outcome : std::uint8_t
  {
    Empty,   ///< holds no root that is not listed
    Smaller, ///< look again
    Split
  };

  void LookAtTop()
  {
    switch (Examine())
    {
      case Outcome::Empty:
        if (Options.keepEmpty)
        {
          Result.empty.push_back(Boxes.Part());
        }
        Boxes.Pop();
        break;
      case Outcome::Smaller:
        break;
      case Outcome::Split:
        if (IsHopeless() || !Boxes.Split())
        {
          Result.undecided.push_back(Boxes.Part());
          Boxes.Pop();
        }
    }
  }

  Outcome Examine()
  {
    if (Roots.IsSettled(Boxes.Part()))
    {
      return Outcome::Empty;
    }
    Sections sections{};
    if (!ClipSystem(Boxes.Local(), Boxes.Width(), sections))
    {
      return Outcome::Empty;
    }
    // Where clipping converges, Krawczyk's test may succeed already. It no longer can when the box
    // has shrunk to the size that the coefficients' errors leave open.
    if (IsSquare && IsConverging(sections))
    {
      const Outcome outcome = Isolate();
      if (outcome != Outcome::Split)
      {
        return outcome;
      }
    }
    if (Boxes.Shrink(sections))
    {
      return Outcome::Smaller;
    }
    return IsSquare ? Isolate() : Outcome::Split;
  }

  [[nodiscard]] bool IsConverging(const Sections& sections) const
  {
    return std::all_of(sections.begin(), sections.begin() + static_cast<std::ptrdiff_t>(N),
      [](const Section& section) { return section.to - section.from < 0.5; });
  }

  [[nodiscard]] bool IsHopeless() const
  {
    return IsSquare && std::ranges::max(Boxes.Width()) <= kNarrow && IsLostInErrors(Boxes.Local());
  }

  /// Krawczyk's test.
  Outcome Isolate()
  {
    const LocalSystem local = Boxes.Local();
    double reach = Reach;
    auto found = ApplyKrawczyk(local, reach);
    if (!found)
    {
      return Outcome::Split;
    }
    if (!found->unique && IsAboutTheBox(found->image))
    {
      // A root at the box's end, in a box not much wider than the coefficients' errors allow.
      reach *= kFarther;
      if (const auto again = ApplyKrawczyk(local, reach); again && again->unique)
      {
        found = again;
      }
    }
    if (found->unique)
    {
      IsolatedRoot root{};
      const bool isListed = Boxes.PlaceRoot(found->image, reach, root) && Roots.Add(root);
      return isListed ? Outcome::Empty : Outcome::Split;
    }
    Sections sections{};
    const double longest = std::ranges::max(Boxes.Width());
    for (std::size_t d = 0; d < N; ++d)
    {
      const Interval part = Intersect(found->image[d], { 0.0, 1.0 });
      if (part.IsEmpty())
      {
        return Outcome::Empty;
      }
      // The narrow sides of a long box wait for the others: near to what the errors make of a root,
      // nothing could be proven any more.
      const bool isNarrow = Boxes.Width()[d] < kUneven * longest;
      sections[d] = isNarrow ? Section{ 0.0, 1.0 } : Section{ part.lower, part.upper };
    }
    return Boxes.Shrink(sections) ? Outcome::Smaller : Outcome::Split;
  }

  [[nodiscard]] bool IsAboutTheBox(const ParameterIntervals& image) const
  {
    return std::all_of(image.begin(), image.begin() + static_cast<std::ptrdiff_t>(N),
      [](const Interval& part) { return part.lower > -2.0 && part.upper < 3.0; });
  }

  void JoinTouching()
  {
    std::vector<ParameterBox>& parts = Result.undecided;
    // Beyond this, the list says no more than its number.
    constexpr std::size_t kMaxJoined = 1000;
    for (std::size_t i = 0; i < parts.size() && parts.size() <= kMaxJoined; ++i)
    {
      for (std::size_t j = i + 1; j < parts.size();)
      {
        if (!Touch(parts[i], parts[j]))
        {
          ++j;
          continue;
        }
        for (std::size_t d = 0; d < N; ++d)
        {
          parts[i].lower[d] = std::min(parts[i].lower[d], parts[j].lower[d]);
          parts[i].upper[d] = std::max(parts[i].upper[d], parts[j].upper[d]);
        }
        parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(j));
        // The larger box may touch others that the smaller one did not.
        j = i + 1;
      }
    }
  }

  [[nodiscard]] bool Touch(const ParameterBox& a, const ParameterBox& b) const
  {
    for (std::size_t d = 0; d < N; ++d)
    {
      if (a.lower[d] > b.upper[d] || b.lower[d] > a.upper[d])
      {
        return false;
      }
    }
    return true;
  }

  const RootSearch& Options;
  std::size_t N; ///< variables
  bool IsSquare; ///< as many equations
  double Reach;  ///< of Krawczyk's test beyond a box, in its widths
  BoxStack Boxes;
  RootList Roots;
  RootSearchResult Result;
};
} // namespace

RootSearchResult FindRoots(const PolynomialSystem& system, const RootSearch& search)
{
  return Search(system, search).Run();
}
} // namespace pixelexact
