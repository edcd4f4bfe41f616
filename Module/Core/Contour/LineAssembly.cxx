// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Contour/LineAssembly.h"

#include "Core/Contour/SeedList.h"
#include "Core/Faces/FacePlane.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace pixelexact
{
namespace
{
/// Ends at most this far apart are joined, in sizes of their elements: values and surfaces on both
/// sides of a face agree to the digits of the solver's file.
constexpr double kSameEnd = 1e-7;
/// Distinct ends that lie close to each other by chance differ by more than this.
constexpr double kRounding = 1e-11;
constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// The ends of piece p are number 2 p and 2 p + 1.
class Assembly
{
public:
  Assembly(const Mesh& mesh, const FaceTable& faces, std::vector<PlacedPiece> pieces,
    std::size_t value, ContourSet& set)
    : mesh_(mesh)
    , Faces(faces)
    , Pieces(std::move(pieces))
    , Value(value)
    , Set(set)
    , Partner(2 * Pieces.size(), kNone)
    , Doubtful(2 * Pieces.size(), false)
    , Done(Pieces.size(), false)
  {
  }

  void Run()
  {
    Match();
    for (std::size_t p = 0; p < Pieces.size(); ++p)
    {
      // Lines with ends begin at one.
      for (const std::size_t end : { 2 * p, 2 * p + 1 })
      {
        if (!Done[p] && !Pieces[p].piece.closed && Partner[end] == kNone)
        {
          AddLine(end);
        }
      }
    }
    for (std::size_t p = 0; p < Pieces.size(); ++p)
    {
      if (!Done[p])
      {
        AddLine(2 * p);
      }
    }
  }

private:
  [[nodiscard]] const CurvePoint& At(std::size_t end) const
  {
    const auto& points = Pieces[end / 2].piece.points;
    return end % 2 == 0 ? points.front() : points.back();
  }
  [[nodiscard]] double SizeAt(std::size_t end) const
  {
    return mesh_.size[static_cast<std::size_t>(Pieces[end / 2].element)];
  }
  [[nodiscard]] double Reach(std::size_t end) const
  {
    const double uncertainty = mesh_.uncertainty[static_cast<std::size_t>(Pieces[end / 2].element)];
    return kSameEnd * SizeAt(end) + uncertainty;
  }

  void Match()
  {
    std::vector<std::size_t> ends;
    double widest = 0.0;
    for (std::size_t end = 0; end < Partner.size(); ++end)
    {
      if (!Pieces[end / 2].piece.closed)
      {
        ends.push_back(end);
        widest = std::max(widest, Reach(end));
      }
    }
    std::ranges::sort(ends, {}, [this](std::size_t end) { return At(end).x.x; });
    std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
    for (std::size_t i = 0; i < ends.size(); ++i)
    {
      const CurvePoint& a = At(ends[i]);
      for (std::size_t j = i + 1; j < ends.size() && At(ends[j]).x.x - a.x.x <= widest; ++j)
      {
        const CurvePoint& b = At(ends[j]);
        const double distance = glm::length(a.x - b.x);
        const bool isSamePoint = Pieces[ends[i] / 2].element == Pieces[ends[j] / 2].element &&
          glm::length(a.xi - b.xi) <= kOnFace;
        if (distance <= std::min(Reach(ends[i]), Reach(ends[j])) && !isSamePoint)
        {
          pairs.emplace_back(distance, std::min(ends[i], ends[j]), std::max(ends[i], ends[j]));
        }
      }
    }
    std::ranges::sort(pairs);
    for (const auto& [distance, a, b] : pairs)
    {
      if (Partner[a] == kNone && Partner[b] == kNone)
      {
        Partner[a] = b;
        Partner[b] = a;
      }
      else if (distance <= kRounding * std::min(SizeAt(a), SizeAt(b)))
      {
        Doubtful[a] = Doubtful[b] = true;
        ++Set.report.ambiguous;
      }
    }
  }

  std::int64_t AddVertex(const CurvePoint& point, int element)
  {
    Set.vertices.push_back({ point.x, point.xi, point.gradient, point.value, element });
    return static_cast<std::int64_t>(Set.vertices.size()) - 1;
  }

  /// Adds one vertex for two joined ends: the point in the element with the lower number.
  std::int64_t AddEnd(std::size_t end)
  {
    const std::size_t other = Partner[end];
    const bool takeOther = other != kNone && Pieces[other / 2].element < Pieces[end / 2].element;
    const std::size_t taken = takeOther ? other : end;
    return AddVertex(At(taken), Pieces[taken / 2].element);
  }

  void AddLine(std::size_t start)
  {
    ContourLine line;
    line.value = Value;
    line.certified = true;
    const auto check = [&](std::size_t end) { line.certified = line.certified && !Doubtful[end]; };
    std::size_t end = start;
    if (Pieces[start / 2].piece.closed)
    {
      Append(line, end, true);
      line.closed = true;
      line.vertices.push_back(line.vertices.front());
    }
    else
    {
      line.vertices.push_back(AddEnd(end));
      for (;;)
      {
        check(end);
        Append(line, end, false);
        const std::size_t last = end ^ 1U;
        check(last);
        const std::size_t next = Partner[last];
        if (next == start)
        {
          line.closed = true;
          line.vertices.push_back(line.vertices.front());
          break;
        }
        line.vertices.push_back(AddEnd(last));
        if (next == kNone)
        {
          CountEnd(last);
          CountEnd(start);
          break;
        }
        end = next;
      }
    }
    Set.report.uncertified += line.certified ? 0 : 1;
    Set.lines.push_back(std::move(line));
  }

  /// The points of a piece that begins at `end`; its ends are left out unless it is closed.
  void Append(ContourLine& line, std::size_t end, bool closed)
  {
    const PlacedPiece& placed = Pieces[end / 2];
    Done[end / 2] = true;
    line.certified = line.certified && placed.complete && placed.piece.certain;
    const auto& points = placed.piece.points;
    const std::size_t skip = closed ? 0 : 1;
    for (std::size_t i = skip; i + skip < points.size(); ++i)
    {
      const std::size_t at = end % 2 == 0 ? i : points.size() - 1 - i;
      line.vertices.push_back(AddVertex(points[at], placed.element));
    }
  }

  void CountEnd(std::size_t end)
  {
    if (Pieces[end / 2].piece.clipped[end % 2])
    {
      return;
    }
    const int element = Pieces[end / 2].element;
    const auto planes = FacePlanesOf(mesh_.ShapeOf(element));
    bool outside = false;
    for (std::size_t k = 0; k < planes.size(); ++k)
    {
      const FaceKind kind = Faces.KindOf(element, static_cast<int>(k));
      outside = outside ||
        (std::fabs(planes[k].Distance(At(end).xi)) <= kOnFace &&
          (kind == FaceKind::Boundary || kind == FaceKind::Partly));
    }
    Set.report.endsInside += outside ? 0 : 1;
  }

  const Mesh& mesh_;
  const FaceTable& Faces;
  std::vector<PlacedPiece> Pieces;
  std::size_t Value;
  ContourSet& Set;
  std::vector<std::size_t> Partner; ///< by end
  std::vector<bool> Doubtful;       ///< by end: it meets more than one
  std::vector<bool> Done;           ///< by piece
};
} // namespace

void AssembleLines(const Mesh& mesh, const FaceTable& faces, std::vector<PlacedPiece> pieces,
  std::size_t value, ContourSet& set)
{
  Assembly(mesh, faces, std::move(pieces), value, set).Run();
}
} // namespace pixelexact
