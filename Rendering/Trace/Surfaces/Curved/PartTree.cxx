// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Curved/PartTree.h"

#include "Core/Math/Rounding.h"
#include "Core/Shape/ShapeFace.h"
#include "Trace/Scene.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
/// Additional levels of a subdivision. Rays that need smaller pieces soon need even smaller ones,
/// and a conversion costs as much as several subdivisions.
constexpr int kBesides = 2;

/// Estimated cost of two children without their coefficients, in nanoseconds.
constexpr std::int64_t kCostOfTwo = 2000;

std::atomic<std::int64_t> bytesKept{ 0 };
std::atomic<std::int64_t> mostBytes{ PartTree::kMaxBytes };

std::int64_t CountBelow(const std::array<CurvedPiece, 2>& children)
{
  std::int64_t count = 2;
  for (const CurvedPiece& half : children)
  {
    const auto* below = half.children.load(std::memory_order_relaxed);
    count += below != nullptr ? CountBelow(*below) : 0;
  }
  return count;
}

std::int64_t BytesOf(const std::array<CurvedPiece, 2>& children)
{
  return CountBelow(children) * static_cast<std::int64_t>(sizeof(CurvedPiece));
}

std::size_t CoefficientsOf(const std::vector<BoxPolynomial>& polys)
{
  std::size_t count = 0;
  for (const BoxPolynomial& p : polys)
  {
    count += p.b.size();
  }
  return count;
}

std::int64_t CostOf(const std::vector<BoxPolynomial>& polys)
{
  int degree = 0;
  for (const BoxPolynomial& p : polys)
  {
    degree = std::max({ degree, p.degree[0], p.degree[1], p.degree[2] });
  }
  return kCostOfTwo + static_cast<std::int64_t>(CoefficientsOf(polys)) * (8 + degree) / 2;
}
} // namespace

bool PartTree::AreFull()
{
  return BytesKept() >= mostBytes.load(std::memory_order_relaxed);
}

std::int64_t PartTree::BytesKept()
{
  return bytesKept.load(std::memory_order_relaxed);
}

void PartTree::SetMostBytes(std::int64_t bytes)
{
  mostBytes = bytes;
}

void PartTree::Keep(std::int64_t bytes) const
{
  Bytes.fetch_add(bytes, std::memory_order_relaxed);
  bytesKept.fetch_add(bytes, std::memory_order_relaxed);
}

PartTree::~PartTree()
{
  bytesKept.fetch_sub(Bytes.load(), std::memory_order_relaxed);
}

PartTree::PartTree(
  const CurvedEquation& equation, const CurvedPart& part, const FaceModes* faceModes)
  : Equation(equation)
  , part_(part)
  , Modes(faceModes)
  , shape_(equation.mesh.ShapeOf(part.element))
  , Map(faceModes ? ScaledModes(faceModes->space, faceModes->coefficients.data(), 3)
                  : ScaledModes(equation.mesh.map.SpaceOf(part.element),
                      equation.mesh.map.Coefficients(part.element), 3))
{
  const auto e = static_cast<std::size_t>(part.element);
  Uncertainty = rounding::Above(equation.mesh.uncertainty[e] / equation.mesh.size[e]);
  std::vector<RangeIngredient> all{ { &Map, 0, Part::Value }, { &Map, 1, Part::Value },
    { &Map, 2, Part::Value } };
  if (equation.field != nullptr)
  {
    const Expansion& values = equation.field->values;
    // Magnitude and finiteness of the other components do not matter.
    const Space& space = values.SpaceOf(part.element);
    const int first = equation.component == kMagnitude ? 0 : equation.component;
    Field.emplace(space,
      values.Coefficients(part.element) +
        static_cast<std::ptrdiff_t>(first) * static_cast<std::ptrdiff_t>(space.Modes()),
      Components());
    if (!Field->finite)
    {
      return;
    }
    ScaledValue = std::ldexp(equation.value, -Field->exponent);
    for (int c = 0; c < Components(); ++c)
    {
      all.push_back({ &*Field, c, Part::Value });
    }
  }
  Level = LevelFor(all);
  const int count = 1 << Level;
  const auto ends = FacesOf(shape_);
  for (int i = 0; i < count * count * count; ++i)
  {
    const int number[3] = { i / (count * count), i / count % count, i % count };
    auto root = std::make_unique<CurvedPiece>();
    bool onFace = true;
    for (int d = 0; d < 3; ++d)
    {
      root->box.lower[d] = std::ldexp(number[d], 1 - Level) - 1.0;
      root->box.upper[d] = std::ldexp(number[d] + 1, 1 - Level) - 1.0;
      if (part_.face >= 0 && ends[static_cast<std::size_t>(part_.face)].direction == d)
      {
        const bool upper = ends[static_cast<std::size_t>(part_.face)].upper;
        onFace = number[d] == (upper ? count - 1 : 0);
        (upper ? root->box.lower : root->box.upper)[d] = upper ? 1.0 : -1.0;
      }
    }
    if (onFace)
    {
      const Polys whole = Convert(PieceAt({ root->box.lower, root->box.upper }, Level));
      CostOfChildren = std::max(CostOfChildren, CostOf(whole));
      Fill(*root, Restricted(whole, root->box, true), 0);
      if (!root->IsEmpty())
      {
        const auto* below = root->children.load(std::memory_order_relaxed);
        Keep(static_cast<std::int64_t>(sizeof(CurvedPiece)) + (below ? BytesOf(*below) : 0));
        All.push_back(std::move(root));
      }
    }
  }
}

int PartTree::Components() const
{
  return Equation.component == kMagnitude ? Equation.field->values.components : 1;
}

PartTree::Polys PartTree::ConvertOnFace(const PieceForm::Piece& piece) const
{
  const FaceChart chart = ChartOf(shape_, part_.face);
  const auto over = [&](int c, Part part) {
    return OverFace(chart, { &Map, c, part }, Level, piece);
  };
  Polys polys;
  for (int c = 0; c < 3; ++c)
  {
    polys.push_back(over(c, Part::Value));
  }
  for (int c = 0; c < 3; ++c)
  {
    for (int d = 0; d < 3; ++d)
    {
      polys.push_back(d == chart.across ? BoxPolynomial{ {}, { 0.0 } }
                                        : over(c, d == chart.free[0] ? Part::ByXi1 : Part::ByXi3));
    }
  }
  return polys;
}

PartTree::Polys PartTree::Convert(const PieceForm::Piece& piece) const
{
  if (Modes != nullptr)
  {
    return ConvertOnFace(piece);
  }
  const Box3 all{ Vec3(-1.0), Vec3(1.0) };
  const ShapeFace* face =
    part_.face < 0 ? nullptr : &FacesOf(shape_)[static_cast<std::size_t>(part_.face)];
  Polys polys;
  const auto add = [&](const ScaledModes& modes, int c, Part part)
  {
    const BoxPolynomial whole = RangeIngredient{ &modes, c, part }.Over(Level, piece, all);
    polys.push_back(face ? whole.AtEnd(face->direction, face->upper) : whole);
  };
  const auto addAll = [&](const ScaledModes& modes, int components)
  {
    for (int c = 0; c < components; ++c)
    {
      add(modes, c, Part::Value);
    }
    for (int c = 0; c < components; ++c)
    {
      for (const Part by : kDerivatives)
      {
        add(modes, c, by);
      }
    }
  };
  addAll(Map, 3);
  if (Field)
  {
    addAll(*Field, Components());
  }
  return polys;
}

template <class Visit>
void PartTree::WithConverted(const PieceForm::Piece& piece, const Visit& visit) const
{
  const Polys* kept = nullptr;
  {
    const std::scoped_lock lock(Converting);
    auto found = Whole.find(piece);
    if (found == Whole.end() && !AreFull())
    {
      found = Whole.emplace(piece, Convert(piece)).first;
      Keep(static_cast<std::int64_t>(CoefficientsOf(found->second) * sizeof(double)));
    }
    kept = found == Whole.end() ? nullptr : &found->second;
  }
  visit(kept != nullptr ? *kept : Convert(piece));
}

PartTree::Polys PartTree::Restricted(const Polys& whole, const EtaBox& box, bool slopes) const
{
  const Box3 at{ box.lower, box.upper };
  Box3 within = PartInPiece(at, Level, PieceAt(at, Level));
  if (part_.face >= 0)
  {
    const int across = FacesOf(shape_)[static_cast<std::size_t>(part_.face)].direction;
    within.lower[across] = -1.0;
    within.upper[across] = 1.0;
  }
  constexpr std::size_t kOfMap = 12;
  const double scale = std::ldexp(1.0, Map.exponent);
  Polys polys;
  const auto add = [&](std::size_t first, std::size_t count)
  {
    for (std::size_t k = first; k < first + count; ++k)
    {
      BoxPolynomial& p = polys.emplace_back(whole[k]);
      RestrictTo(within, p);
      if (k < kOfMap)
      {
        std::ranges::for_each(p.b, [scale](double& b) { b *= scale; });
        p.error = rounding::Above(std::ldexp(p.error, Map.exponent)) + 0x1p-1000;
        if (Modes != nullptr)
        {
          p.error = rounding::Above(p.error + (k < 3 ? Modes->error : Modes->SlopeError()));
        }
      }
    }
  };
  add(0, slopes ? kOfMap : 3);
  const std::size_t components = (whole.size() - kOfMap) / 4;
  add(kOfMap, slopes ? 4 * components : components);
  return polys;
}

std::vector<BoxPolynomial> PartTree::Polynomials(const CurvedPiece& piece) const
{
  Polys polys;
  WithConverted(PieceAt({ piece.box.lower, piece.box.upper }, Level),
    [&](const Polys& whole) { polys = Restricted(whole, piece.box, false); });
  const bool hasField = Field && Equation.component != kMagnitude;
  for (std::size_t c = 0; c < 3; ++c)
  {
    polys[c].error = rounding::Above(polys[c].error + Uncertainty);
  }
  if (hasField)
  {
    double largest = 0.0;
    for (double& b : polys[3].b)
    {
      b -= ScaledValue;
      largest = std::max(largest, std::fabs(b));
    }
    polys[3].error = rounding::Above(polys[3].error + Gamma(2) * largest) + 0x1p-1000;
  }
  polys.resize(hasField ? 4 : 3);
  return polys;
}

/// Describes a piece, and subdivides it while it bends, and then `besides` more levels.
void PartTree::Fill(CurvedPiece& piece, Polys polys, int besides) const
{
  Describe(piece, polys);
  const bool isPoint = piece.plateau && !Field;
  if (!piece.IsEmpty() && !isPoint && (!piece.flat || besides > 0))
  {
    auto children = Split(piece, std::move(polys), piece.flat ? besides - 1 : 0);
    piece.children.store(children.release(), std::memory_order_release);
  }
}

std::unique_ptr<const PartTree::Children> PartTree::Split(
  const CurvedPiece& piece, Polys polys, int besides) const
{
  const int direction = DirectionOf(piece, polys);
  auto children = std::make_unique<Children>();
  Polys upper;
  upper.reserve(polys.size());
  for (BoxPolynomial& p : polys)
  {
    upper.push_back(p.Subdivide(direction));
  }
  const double middle = 0.5 * (piece.box.lower[direction] + piece.box.upper[direction]);
  for (std::size_t k = 0; k < 2; ++k)
  {
    CurvedPiece& half = (*children)[k];
    half.box = piece.box;
    (k == 0 ? half.box.upper : half.box.lower)[direction] = middle;
    half.subdivisions = piece.subdivisions + 1;
    half.plateauFrom = piece.plateau ? piece.plateauFrom : half.subdivisions;
    Fill(half, std::move(k == 0 ? polys : upper), besides);
  }
  return children;
}

PieceChildren PartTree::GetChildren(const CurvedPiece& piece) const
{
  if (const auto* made = piece.children.load(std::memory_order_acquire))
  {
    return { made, nullptr };
  }
  // The count of levels is fixed, because subdivision and restriction round differently.
  const auto make = [&]
  {
    std::unique_ptr<const Children> children;
    WithConverted(PieceAt({ piece.box.lower, piece.box.upper }, Level),
      [&](const Polys& whole)
      { children = Split(piece, Restricted(whole, piece.box, true), kBesides); });
    return children;
  };
  if (AreFull())
  {
    const std::shared_ptr<const Children> own = make();
    return { own.get(), own };
  }
  const std::scoped_lock lock(Growing);
  if (piece.children.load(std::memory_order_relaxed) == nullptr)
  {
    auto children = make();
    Keep(BytesOf(*children));
    piece.children.store(children.release(), std::memory_order_release);
  }
  return { piece.children.load(std::memory_order_relaxed), nullptr };
}

} // namespace pixelexact
