// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Bernstein/PieceForm.h"

#include "Core/Bernstein/SweepKernels.h"
#include "Core/Math/Rounding.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

namespace pixelexact
{
namespace
{
std::size_t NumberOf(Part part)
{
  const int index = static_cast<int>(part) - static_cast<int>(Part::Value);
  return static_cast<std::size_t>(index);
}

constexpr auto kPlain = Factor::Plain;
constexpr auto kSlope = Factor::Slope;
constexpr auto kTilted = Factor::Tilted;

using Product = std::array<Factor, 3>;

/// The products of which a part consists (see the table in PieceForm.h).
std::vector<Product> ProductsOf(const Space& space, Part part)
{
  if (part == Part::Value)
  {
    return { { kPlain, kPlain, kPlain } };
  }
  const bool tetrahedron = space.shape == Shape::Tetrahedron;
  const Factor overH = space.form == Form::Tensor ? Factor::Closed : Factor::Lowered;
  const Factor y = tetrahedron ? overH : kPlain;
  const bool collapses1 = space.shape != Shape::Hexahedron;
  const bool collapses2 = tetrahedron || space.shape == Shape::Pyramid;
  switch (part)
  {
    case Part::ByXi1:
      return { { kSlope, y, collapses1 ? overH : kPlain } };
    case Part::ByXi2:
    {
      std::vector<Product> products{ { kPlain, kSlope, collapses2 ? overH : kPlain } };
      if (tetrahedron)
      {
        products.push_back({ kTilted, y, overH });
      }
      return products;
    }
    default:
    {
      std::vector<Product> products{ { kPlain, kPlain, kSlope } };
      if (collapses1)
      {
        products.push_back({ kTilted, y, overH });
      }
      if (collapses2)
      {
        products.push_back({ kPlain, kTilted, overH });
      }
      return products;
    }
  }
}

/// The factor of a direction's family and number.
FactorKey KeyOf(const Space& space, int direction, int family, int n)
{
  const bool collapsed = space.form == Form::Collapsed;
  if (direction == 1 && space.shape == Shape::Tetrahedron)
  {
    return { 2 * family + 1, n, family };
  }
  if (direction == 2 && collapsed && space.shape != Shape::Hexahedron)
  {
    return { space.shape == Shape::Prism ? 2 * family + 1 : 2 * family + 2, n, family };
  }
  return { 0, n, 0 };
}
} // namespace

PieceForm::PieceForm(const Space& space, int level)
  : space_(space)
  , level_(level)
  , degree_(space.TensorDegree())
{
  const auto [P, Q, R] = degree_;
  const bool tetrahedron = space.shape == Shape::Tetrahedron;
  Families[1] = tetrahedron ? P + 1 : 1;
  if (space.shape != Shape::Hexahedron && space.form == Form::Collapsed)
  {
    Families[2] = 1 + (space.shape == Shape::Prism ? P : (tetrahedron ? Q : std::max(P, Q)));
  }
  for (const Part part : { Part::Value, Part::ByXi1, Part::ByXi2, Part::ByXi3 })
  {
    for (const Product& product : ProductsOf(space, part))
    {
      Terms[NumberOf(part)].push_back({ product });
      MakeTables(product);
    }
  }
}

void PieceForm::MakeTables(const std::array<Factor, 3>& factor)
{
  for (std::size_t d = 0; d < 3; ++d)
  {
    auto& table = Tables[d][static_cast<std::size_t>(factor[d])];
    if (!table.empty())
    {
      continue;
    }
    const int degree = degree_[d];
    for (int piece = 0; piece < (1 << level_); ++piece)
    {
      for (int family = 0; family < Families[d]; ++family)
      {
        for (int n = 0; n <= degree; ++n)
        {
          const FactorKey key = KeyOf(space_, static_cast<int>(d), family, n);
          table.push_back(key.n + key.power <= degree
              ? MakeFactorRow(key, factor[d], degree, level_, piece)
              : FactorRow{});
          Largest[d][static_cast<std::size_t>(factor[d])].push_back(table.back().largest);
        }
      }
    }
  }
}

int PieceForm::LevelOf(int order)
{
  return order <= 5 ? 0 : (order <= 11 ? 1 : (order <= 23 ? 2 : 3));
}

const PieceForm& PieceForm::Of(const Space& space)
{
  return Of(space, LevelOf(space.MaxOrder()));
}

const PieceForm& PieceForm::Of(const Space& space, int level)
{
  static std::mutex mutex;
  static std::map<std::pair<Space, int>, std::unique_ptr<const PieceForm>> forms;
  const std::scoped_lock lock(mutex);
  auto& form = forms[{ space, level }];
  if (!form)
  {
    form.reset(new PieceForm(space, level));
  }
  return *form;
}

std::size_t PieceForm::Size() const
{
  return static_cast<std::size_t>(degree_[0] + 1) * static_cast<std::size_t>(degree_[1] + 1) *
    static_cast<std::size_t>(degree_[2] + 1);
}

std::array<int, 3> PieceForm::FamilyOf(int p, int q) const
{
  switch (space_.shape)
  {
    case Shape::Prism:
      return { 0, 0, p };
    case Shape::Tetrahedron:
      return { 0, p, p + q };
    case Shape::Pyramid:
      return { 0, 0, space_.form == Form::Tensor ? 0 : std::max(p, q) };
    default:
      return { 0, 0, 0 };
  }
}

std::size_t PieceForm::IndexOf(int direction, int piece, int family, int n) const
{
  const auto d = static_cast<std::size_t>(direction);
  const int index = (piece * Families[d] + family) * (degree_[d] + 1) + n;
  return static_cast<std::size_t>(index);
}

const FactorRow& PieceForm::RowOf(int direction, Factor factor, int piece, int family, int n) const
{
  return Tables[static_cast<std::size_t>(direction)][static_cast<std::size_t>(factor)]
               [IndexOf(direction, piece, family, n)];
}

const double* PieceForm::LargestOf(int direction, Factor factor, int piece, int family, int n) const
{
  return &Largest[static_cast<std::size_t>(direction)][static_cast<std::size_t>(factor)]
                 [IndexOf(direction, piece, family, n)];
}

void PieceForm::AddTerm(
  const Term& term, const Piece& piece, const double* modes, std::span<double> out) const
{
  const auto [P, Q, R] = degree_;
  const auto width = static_cast<std::size_t>(R) + 1;
  std::vector<double> line(width);
  std::vector<double> layer(width * (static_cast<std::size_t>(Q) + 1));
  std::vector<const double*> rows(width);
  for (int p = 0; p <= P; ++p)
  {
    std::ranges::fill(layer, 0.0);
    for (int q = 0; q <= space_.LastQ(p); ++q)
    {
      const auto family = FamilyOf(p, q);
      const auto count = static_cast<std::size_t>(space_.LastR(p, q)) + 1;
      const FactorRow* z = &RowOf(2, term.factor[2], piece[2], family[2], 0);
      for (std::size_t r = 0; r < count; ++r)
      {
        rows[r] = z[r].value.data();
      }
      Combine({ modes, count }, rows.data(), line);
      modes += count;
      AddOuter(RowOf(1, term.factor[1], piece[1], family[1], q).value, line, layer.data());
    }
    AddOuter(RowOf(0, term.factor[0], piece[0], 0, p).value, layer, out.data());
  }
}

void PieceForm::Convert(
  Part part, const Piece& piece, const double* modes, std::span<double> out) const
{
  std::ranges::fill(out, 0.0);
  for (const Term& term : Terms[NumberOf(part)])
  {
    AddTerm(term, piece, modes, out);
  }
}

double PieceForm::ErrorBound(Part part, const Piece& piece, const double* modes) const
{
  // The first mode is 1, whose factors are 1 exactly: a constant is converted without rounding.
  if (std::all_of(modes + 1, modes + space_.Modes(), [](double mode) { return mode == 0.0; }))
  {
    return 0.0;
  }
  double sum = 0.0;
  for (const Term& term : Terms[NumberOf(part)])
  {
    const double* mode = modes;
    for (int p = 0; p <= space_.order[0]; ++p)
    {
      const double x = *LargestOf(0, term.factor[0], piece[0], 0, p);
      for (int q = 0; q <= space_.LastQ(p); ++q)
      {
        const auto family = FamilyOf(p, q);
        const auto count = static_cast<std::size_t>(space_.LastR(p, q)) + 1;
        sum += x * *LargestOf(1, term.factor[1], piece[1], family[1], q) *
          WeighMagnitudes({ mode, count }, LargestOf(2, term.factor[2], piece[2], family[2], 0));
        mode += count;
      }
    }
  }
  const int operations = degree_[0] + degree_[1] + degree_[2] + 12;
  // The sum's own rounding is far below the slack; so is what underflows.
  return sum > 0.0 ? sum * Gamma(operations) * (1.0 + 0x1p-30) + 0x1p-900 : 0.0;
}

bool PieceForm::IsClosed(const Space& space, const double* modes)
{
  if (space.form != Form::Tensor)
  {
    return true;
  }
  double all = 0.0;
  double open = 0.0;
  double column = 0.0;
  ForEachMode(space,
    [&](int p, int q, int r, int mode)
    {
      column = (r == 0 ? 0.0 : column) + modes[mode];
      all += std::fabs(modes[mode]);
      if (r == space.LastR(p, q) && p + q > 0)
      {
        open += std::fabs(column);
      }
    });
  return open <= 64.0 * kUnitRoundoff * all;
}
} // namespace pixelexact
