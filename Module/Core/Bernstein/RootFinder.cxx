// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Bernstein/RootFinder.h"

#include "Core/Bernstein/Krawczyk.h"
#include "Core/Math/Rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
/// Ends of boxes are multiples of this: exact, also when added and subtracted.
constexpr double kGrid = 0x1p-50;
/// A box that loses less than this share of its width in every direction is split.
constexpr double kWorthwhile = 0.75;
/// A box is not made thinner than this in one step, relative to its largest width.
constexpr double kThinnest = 0x1p-8;
/// Krawczyk's test first reaches 1 / (4 total degree) beyond the box, where hulls of derivatives
/// grow by less than a factor of two; then so many times as far, e^16 at most.
constexpr double kFarther = 32.0;

struct Box
{
  Parameters lower{};
  Parameters width{};
  std::array<double, 3> error{}; ///< of each polynomial's coefficients
};

class Search
{
public:
  Search(const PolynomialSystem& system, const RootSearch& options)
    : System(system)
    , Options(options)
    , N(static_cast<std::size_t>(system.Variables()))
    , M(static_cast<std::size_t>(system.Equations()))
    , Degree(system.Degree())
    , Size(CoefficientCount(Degree))
    , Smallest(std::max(options.smallest, 0x1p-40))
    , Combined(Size)
  {
    Reach = 1.0 / (4.0 * std::max(1, Degree[0] + Degree[1] + Degree[2]));
  }

  RootSearchResult Run()
  {
    Box whole;
    std::fill_n(whole.width.begin(), N, 1.0);
    std::ranges::copy(System.Errors(), whole.error.begin());
    Boxes.assign(1, whole);
    Coefficients.assign(System.Coefficients().begin(), System.Coefficients().end());
    while (!Boxes.empty())
    {
      if (Result.boxes >= Options.budget)
      {
        Result.budgetSpent = true;
        for (const Box& box : Boxes)
        {
          Result.undecided.push_back(PartOf(box));
        }
        break;
      }
      ++Result.boxes;
      LookAtTop();
    }
    JoinTouching(Result.undecided);
    return std::move(Result);
  }

private:
  enum class Outcome : std::uint8_t
  {
    Empty,   ///< holds no root that is not listed
    Smaller, ///< look again
    Split
  };

  [[nodiscard]] std::span<double> Top(std::size_t k)
  {
    return std::span(Coefficients).subspan(((Boxes.size() - 1) * M + k) * Size, Size);
  }

  void LookAtTop()
  {
    switch (Examine())
    {
      case Outcome::Empty:
        if (Options.keepEmpty)
        {
          Result.empty.push_back(PartOf(Boxes.back()));
        }
        Boxes.pop_back();
        break;
      case Outcome::Smaller:
        break;
      case Outcome::Split:
        if (IsHopeless() || !SplitTop())
        {
          Result.undecided.push_back(PartOf(Boxes.back()));
          Boxes.pop_back();
        }
    }
  }

  Outcome Examine()
  {
    if (IsOutsideDomain() || IsSettled())
    {
      return Outcome::Empty;
    }
    std::array<Section, 3> sections{};
    if (!Clip(sections))
    {
      return Outcome::Empty;
    }
    // Where clipping converges, Krawczyk's test may succeed already: before the box has shrunk to
    // what the coefficients' errors leave open, when it no longer can.
    if (N == M && IsConverging(sections))
    {
      const Outcome outcome = Isolate();
      if (outcome != Outcome::Split)
      {
        return outcome;
      }
    }
    if (Shrink(sections))
    {
      return Outcome::Smaller;
    }
    return N == M ? Isolate() : Outcome::Split;
  }

  [[nodiscard]] bool IsConverging(const std::array<Section, 3>& sections) const
  {
    return std::all_of(sections.begin(), sections.begin() + static_cast<std::ptrdiff_t>(N),
      [](const Section& section) { return section.to - section.from < 0.5; });
  }

  /// False where a hull excludes zero.
  bool Clip(std::array<Section, 3>& sections)
  {
    const Box& box = Boxes.back();
    for (std::size_t k = 0; k < M; ++k)
    {
      for (std::size_t d = 0; d < N; ++d)
      {
        if (!Meet(sections[d], ClipToZero(Degree, static_cast<int>(d), Top(k), box.error[k])))
        {
          return false;
        }
      }
    }
    // One equation may narrow one direction far more than the others can be: a sliver, in which
    // nothing can be said of the others.
    std::array<double, 3> room{};
    for (std::size_t d = 0; d < N; ++d)
    {
      room[d] = kThinnest * std::ranges::max(box.width) / box.width[d];
    }
    if (N == M && !ClipPreconditioned(sections, room))
    {
      return false;
    }
    for (std::size_t d = 0; d < N; ++d)
    {
      const double middle = 0.5 * (sections[d].from + sections[d].to);
      sections[d].from = std::min(sections[d].from, std::max(0.0, middle - room[d]));
      sections[d].to = std::max(sections[d].to, std::min(1.0, middle + room[d]));
    }
    return true;
  }

  /// The same with P f, P near the inverse of the mean Jacobian: P f vanishes exactly where f does,
  /// and its i-th component is nearly t_i minus the root's.
  bool ClipPreconditioned(std::array<Section, 3>& sections, std::array<double, 3>& room)
  {
    const auto inverse = Inverse(static_cast<int>(N), MeanJacobian());
    if (!inverse)
    {
      return true;
    }
    const Box& box = Boxes.back();
    for (std::size_t i = 0; i < N; ++i)
    {
      std::ranges::fill(Combined, 0.0);
      double error = 0.0;
      double magnitude = 0.0;
      for (std::size_t k = 0; k < M; ++k)
      {
        const double weight = (*inverse)[i][k];
        const auto from = Top(k);
        for (std::size_t at = 0; at < Size; ++at)
        {
          Combined[at] += weight * from[at];
        }
        error += std::fabs(weight) * box.error[k];
        magnitude += std::fabs(weight) * LargestMagnitude(from);
      }
      error = (error + Gamma(8) * magnitude) * (1.0 + Gamma(16)) +
        16.0 * std::numeric_limits<double>::denorm_min();
      if (!Meet(sections[i], ClipToZero(Degree, static_cast<int>(i), Combined, error)))
      {
        return false;
      }
      // What the coefficients' errors make of a root, P f being about t, with room around it: in a
      // box no wider than that, Krawczyk's test could not succeed.
      room[i] = std::max(room[i], 8.0 * error);
    }
    return true;
  }

  static bool Meet(Section& section, const Section& other)
  {
    section.from = std::max(section.from, other.from);
    section.to = std::min(section.to, other.to);
    return !(section.from > section.to);
  }

  SmallMatrix MeanJacobian()
  {
    SmallMatrix mean{};
    for (std::size_t k = 0; k < M; ++k)
    {
      const auto b = Top(k);
      for (std::size_t d = 0; d < N; ++d)
      {
        const std::size_t stride = StrideOf(Degree, static_cast<int>(d));
        const auto count = static_cast<std::size_t>(Degree[d] + 1);
        double sum = 0.0;
        for (std::size_t at = 0; at < Size; ++at)
        {
          const std::size_t place = at / stride % count;
          sum += place + 1 == count ? b[at] : 0.0;
          sum -= place == 0 ? b[at] : 0.0;
        }
        mean[k][d] = sum * static_cast<double>(count) / static_cast<double>(Size);
      }
    }
    return mean;
  }

  /// Restricts the box to the sections, where that is worthwhile.
  bool Shrink(const std::array<Section, 3>& sections)
  {
    bool shrunk = false;
    for (std::size_t d = 0; d < N; ++d)
    {
      Box& box = Boxes.back();
      const double upper = box.lower[d] + box.width[d];
      // One grid unit outward covers the rounding of the ends.
      const double from = std::max(box.lower[d],
        (std::floor((box.lower[d] + sections[d].from * box.width[d]) / kGrid) - 1.0) * kGrid);
      const double to = std::min(
        upper, (std::ceil((box.lower[d] + sections[d].to * box.width[d]) / kGrid) + 1.0) * kGrid);
      const double width = to - from;
      if (!(width < kWorthwhile * box.width[d]) || !(width >= Smallest))
      {
        continue;
      }
      const double relativeFrom = (from - box.lower[d]) / box.width[d];
      const double relativeTo = (to - box.lower[d]) / box.width[d];
      for (std::size_t k = 0; k < M; ++k)
      {
        const auto b = Top(k);
        box.error[k] =
          rounding::Above(box.error[k] + RestrictionError(Degree[d], LargestMagnitude(b)));
        Restrict(Degree, static_cast<int>(d), relativeFrom, relativeTo, b);
      }
      box.lower[d] = from;
      box.width[d] = width;
      shrunk = true;
    }
    return shrunk;
  }

  /// Krawczyk's test.
  Outcome Isolate()
  {
    const Box& box = Boxes.back();
    const SquareSystem local{ static_cast<int>(N), Degree,
      std::span(Coefficients).subspan((Boxes.size() - 1) * M * Size, M * Size), box.error };
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
      return Record(box, found->image, reach) ? Outcome::Empty : Outcome::Split;
    }
    std::array<Section, 3> sections{};
    for (std::size_t d = 0; d < N; ++d)
    {
      const Interval part = Intersect(found->image[d], { 0.0, 1.0 });
      if (part.IsEmpty())
      {
        return Outcome::Empty;
      }
      sections[d] = { part.lower, part.upper };
    }
    return Shrink(sections) ? Outcome::Smaller : Outcome::Split;
  }

  [[nodiscard]] bool IsAboutTheBox(const ParameterIntervals& image) const
  {
    return std::all_of(image.begin(), image.begin() + static_cast<std::ptrdiff_t>(N),
      [](const Interval& part) { return part.lower > -2.0 && part.upper < 3.0; });
  }

  /// Lists a root, unless it is listed already or outside of the domain. False where it cannot be
  /// told from a listed one.
  bool Record(const Box& box, const ParameterIntervals& image, double reach)
  {
    IsolatedRoot root{};
    for (std::size_t d = 0; d < N; ++d)
    {
      const Interval lower(box.lower[d]);
      const Interval width(box.width[d]);
      root.enclosure[d] = lower + width * image[d];
      root.alone[d] = { (lower + width * Interval(-reach)).upper,
        (lower + width * (Interval(1.0) + Interval(reach))).lower };
      if (!root.alone[d].Contains(root.enclosure[d]))
      {
        return false;
      }
    }
    for (const IsolatedRoot& listed : Result.roots)
    {
      bool apart = false;
      bool within = true;
      bool around = true;
      for (std::size_t d = 0; d < N; ++d)
      {
        apart = apart || Intersect(listed.enclosure[d], root.enclosure[d]).IsEmpty();
        within = within && listed.alone[d].Contains(root.enclosure[d]);
        around = around && root.alone[d].Contains(listed.enclosure[d]);
      }
      if (within || around)
      {
        return true;
      }
      if (!apart)
      {
        return false;
      }
    }
    if (Place(root))
    {
      Result.roots.push_back(root);
    }
    return true;
  }

  /// Sets inDomain; false where the enclosure lies outside of the domain.
  bool Place(IsolatedRoot& root) const
  {
    root.inDomain = true;
    for (std::size_t d = 0; d < N; ++d)
    {
      if (Intersect(root.enclosure[d], { 0.0, 1.0 }).IsEmpty())
      {
        return false;
      }
      root.inDomain = root.inDomain && Interval(0.0, 1.0).Contains(root.enclosure[d]);
    }
    for (const HalfSpace& half : System.Domain())
    {
      Interval beyond = -Interval(half.offset);
      for (std::size_t d = 0; d < N; ++d)
      {
        beyond += Interval(half.normal[d]) * root.enclosure[d];
      }
      if (beyond.lower > 0.0)
      {
        return false;
      }
      root.inDomain = root.inDomain && beyond.upper <= 0.0;
    }
    return true;
  }

  [[nodiscard]] bool IsOutsideDomain() const
  {
    const Box& box = Boxes.back();
    return std::ranges::any_of(System.Domain(),
      [&](const HalfSpace& half)
      {
        Interval beyond = -Interval(half.offset);
        for (std::size_t d = 0; d < N; ++d)
        {
          beyond += Interval(half.normal[d]) * Interval(box.lower[d], box.lower[d] + box.width[d]);
        }
        return beyond.lower > 0.0;
      });
  }

  /// Whether a listed root is known to be the only one anywhere in the box.
  [[nodiscard]] bool IsSettled() const
  {
    const Box& box = Boxes.back();
    return std::ranges::any_of(Result.roots,
      [&](const IsolatedRoot& root)
      {
        bool within = true;
        for (std::size_t d = 0; d < N; ++d)
        {
          within =
            within && root.alone[d].Contains(Interval(box.lower[d], box.lower[d] + box.width[d]));
        }
        return within;
      });
  }

  /// Whether the coefficients' errors move roots by about the box's width: it will not be decided
  /// by splitting. Asked of the corner where the Jacobian is farthest from singular, for it may
  /// vanish elsewhere.
  bool IsHopeless()
  {
    const Box& box = Boxes.back();
    if (N != M || std::ranges::max(box.width) > 0x1p-6)
    {
      return false;
    }
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t corner = 0; corner < (std::size_t{ 1 } << N); ++corner)
    {
      const auto inverse = Inverse(static_cast<int>(N), CornerJacobian(corner));
      if (!inverse)
      {
        continue;
      }
      double largest = 0.0;
      for (std::size_t i = 0; i < N; ++i)
      {
        double moved = 0.0;
        for (std::size_t k = 0; k < M; ++k)
        {
          moved += std::fabs((*inverse)[i][k]) * box.error[k];
        }
        largest = std::max(largest, moved);
      }
      least = std::min(least, largest);
    }
    return least > 0.5;
  }

  SmallMatrix CornerJacobian(std::size_t corner)
  {
    SmallMatrix jacobian{};
    std::size_t at = 0;
    for (std::size_t d = 0; d < N; ++d)
    {
      at += (corner >> d & 1U) != 0U
        ? static_cast<std::size_t>(Degree[d]) * StrideOf(Degree, static_cast<int>(d))
        : 0;
    }
    for (std::size_t k = 0; k < M; ++k)
    {
      const auto b = Top(k);
      for (std::size_t d = 0; d < N; ++d)
      {
        const std::size_t stride = StrideOf(Degree, static_cast<int>(d));
        if (Degree[d] > 0)
        {
          jacobian[k][d] = Degree[d] *
            ((corner >> d & 1U) != 0U ? b[at] - b[at - stride] : b[at + stride] - b[at]);
        }
      }
    }
    return jacobian;
  }

  /// Halves the box on top in its widest direction; false where it is too small.
  bool SplitTop()
  {
    std::size_t direction = 3;
    double widest = 0.0;
    for (std::size_t d = 0; d < N; ++d)
    {
      if (Boxes.back().width[d] >= 2.0 * Smallest && Boxes.back().width[d] > widest)
      {
        widest = Boxes.back().width[d];
        direction = d;
      }
    }
    if (direction == 3)
    {
      return false;
    }
    Box upper = Boxes.back();
    // The middle, on the grid.
    const double part = std::floor(widest / 2.0 / kGrid) * kGrid;
    upper.lower[direction] += part;
    upper.width[direction] = widest - part;
    Coefficients.resize(std::max(Coefficients.size(), (Boxes.size() + 1) * M * Size));
    for (std::size_t k = 0; k < M; ++k)
    {
      const auto lower = Top(k);
      const auto to = std::span(Coefficients).subspan((Boxes.size() * M + k) * Size, Size);
      const double error = RestrictionError(Degree[direction], LargestMagnitude(lower));
      upper.error[k] = rounding::Above(upper.error[k] + error);
      Boxes.back().error[k] = upper.error[k];
      std::ranges::copy(lower, to.begin());
      Restrict(Degree, static_cast<int>(direction), 0.0, part / widest, lower);
      Restrict(Degree, static_cast<int>(direction), part / widest, 1.0, to);
    }
    Boxes.back().width[direction] = part;
    Boxes.push_back(upper);
    return true;
  }

  [[nodiscard]] ParameterBox PartOf(const Box& box) const
  {
    ParameterBox part;
    for (std::size_t d = 0; d < N; ++d)
    {
      part.lower[d] = box.lower[d];
      part.upper[d] = box.lower[d] + box.width[d];
    }
    return part;
  }

  void JoinTouching(std::vector<ParameterBox>& parts) const
  {
    // Beyond this, the list says no more than its number.
    constexpr std::size_t kMostJoined = 1000;
    if (parts.size() > kMostJoined || N != M)
    {
      return;
    }
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      for (std::size_t j = i + 1; j < parts.size();)
      {
        bool touches = true;
        for (std::size_t d = 0; d < N; ++d)
        {
          touches = touches && parts[i].lower[d] <= parts[j].upper[d] &&
            parts[j].lower[d] <= parts[i].upper[d];
        }
        if (!touches)
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

  const PolynomialSystem& System;
  const RootSearch& Options;
  std::size_t N; ///< variables
  std::size_t M; ///< equations
  Degrees Degree;
  std::size_t Size; ///< coefficients of a polynomial
  double Smallest;
  double Reach; ///< of Krawczyk's test beyond a box, in its widths
  RootSearchResult Result;
  std::vector<Box> Boxes;           ///< a stack
  std::vector<double> Coefficients; ///< M Size for each box of the stack
  std::vector<double> Combined;
};
} // namespace

RootSearchResult FindRoots(const PolynomialSystem& system, const RootSearch& search)
{
  return Search(system, search).Run();
}
} // namespace pixelexact
