// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Bernstein/BernsteinForm.h"

#include "Core/Bernstein/SweepKernels.h"
#include "Core/Math/Rounding.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>

namespace pixelexact
{
namespace
{
/// Rows of h^power P_n^{(alpha,0)}, n from 0 to `last`.
std::vector<FactorRow> UnivariateRows(int alpha, int last, int power, int degree)
{
  std::vector<FactorRow> rows;
  for (int n = 0; n <= last; ++n)
  {
    rows.push_back(MakeFactorRow({ alpha, n, power }, Factor::Plain, degree, 0, 0));
  }
  return rows;
}

template <bool kAbsolute>
const std::vector<double>& RowOf(const FactorRow& row)
{
  return kAbsolute ? row.magnitude : row.value;
}
} // namespace

BernsteinForm::BernsteinForm(const Space& space)
  : space_(space)
  , degree_(space.TensorDegree())
{
  MakeRows();
  Largest.reserve(static_cast<std::size_t>(space.Modes()));
  ForEachMode(space,
    [&](int p, int q, int r, int /*mode*/)
    {
      const Rows& y = Y[Y.size() > 1 ? p : 0];
      Largest.push_back(X[p].largest * y[q].largest * Z[FamilyOf(p, q)][r].largest);
    });
}

/// The power of h that the third factor of modes (p, q, *) carries, where it has families.
int BernsteinForm::FamilyOf(int p, int q) const
{
  if (Z.size() == 1)
  {
    return 0;
  }
  return space_.shape == Shape::Prism    ? p
    : space_.shape == Shape::Tetrahedron ? p + q
                                         : std::max(p, q);
}

void BernsteinForm::MakeRows()
{
  const Space& space = space_;
  const auto [P, Q, R] = degree_;
  X = UnivariateRows(0, P, 0, P);
  const bool tetrahedron = space.shape == Shape::Tetrahedron;
  for (int p = 0; p <= (tetrahedron ? P : 0); ++p)
  {
    Y.push_back(tetrahedron ? UnivariateRows(2 * p + 1, Q - p, p, Q) : UnivariateRows(0, Q, 0, Q));
  }
  if (space.shape == Shape::Hexahedron || space.form == Form::Tensor)
  {
    Z.push_back(UnivariateRows(0, R, 0, R));
    return;
  }
  const bool prism = space.shape == Shape::Prism;
  const int families = prism ? P : (tetrahedron ? Q : std::max(P, Q));
  for (int n = 0; n <= families; ++n)
  {
    Z.push_back(UnivariateRows(prism ? 2 * n + 1 : 2 * n + 2, R - n, n, R));
  }
}

const BernsteinForm& BernsteinForm::Of(const Space& space)
{
  static std::mutex mutex;
  static std::map<Space, std::unique_ptr<const BernsteinForm>> forms;
  const std::scoped_lock lock(mutex);
  auto& form = forms[space];
  if (!form)
  {
    form.reset(new BernsteinForm(space));
  }
  return *form;
}

int BernsteinForm::Size() const
{
  return (degree_[0] + 1) * (degree_[1] + 1) * (degree_[2] + 1);
}

template <bool kAbsolute>
void BernsteinForm::Contract(const double* modes, std::span<double> bernstein) const
{
  // Short lines are done before a kernel has been called.
  constexpr std::size_t kLong = 8;
  const auto [P, Q, R] = degree_;
  const auto width = static_cast<std::size_t>(R) + 1;
  std::vector<double> line(width);
  std::vector<double> layer(static_cast<std::size_t>(Q + 1) * width);
  std::vector<double> magnitudes(width);
  std::vector<const double*> rows(width);
  std::ranges::fill(bernstein, 0.0);
  for (int p = 0; p <= P; ++p)
  {
    std::ranges::fill(layer, 0.0);
    const Rows& y = Y[Y.size() > 1 ? p : 0];
    for (int q = 0; q <= space_.LastQ(p); ++q)
    {
      const auto& z = Z[FamilyOf(p, q)];
      const auto count = static_cast<std::size_t>(space_.LastR(p, q)) + 1;
      std::span<const double> factors(modes, count);
      modes += count;
      if (kAbsolute)
      {
        std::ranges::transform(
          factors, magnitudes.begin(), [](double mode) { return std::fabs(mode); });
        factors = std::span(magnitudes).first(count);
      }
      const auto& along = RowOf<kAbsolute>(y[q]);
      if (width >= kLong)
      {
        for (std::size_t r = 0; r < count; ++r)
        {
          rows[r] = RowOf<kAbsolute>(z[r]).data();
        }
        Combine(factors, rows.data(), line);
        AddOuter(along, line, layer.data());
        continue;
      }
      std::ranges::fill(line, 0.0);
      for (std::size_t r = 0; r < count; ++r)
      {
        const auto& row = RowOf<kAbsolute>(z[r]);
        for (std::size_t k = 0; k < width; ++k)
        {
          line[k] += factors[r] * row[k];
        }
      }
      for (std::size_t j = 0; j < along.size(); ++j)
      {
        for (std::size_t k = 0; k < width; ++k)
        {
          layer[j * width + k] += along[j] * line[k];
        }
      }
    }
    AddOuter(RowOf<kAbsolute>(X[p]), layer, bernstein.data());
  }
}

void BernsteinForm::Convert(const double* modes, std::span<double> bernstein) const
{
  Contract<false>(modes, bernstein);
}

double BernsteinForm::ErrorBound(const double* modes) const
{
  std::vector<double> sums(Size());
  Contract<true>(modes, sums);
  const int operations = degree_[0] + degree_[1] + degree_[2] + 9;
  // The sums of magnitudes are themselves rounded: one more factor 1 + gamma covers that.
  return std::ranges::max(sums) * Gamma(operations) * (1.0 + Gamma(2 * operations));
}

double BernsteinForm::QuickErrorBound(const double* modes) const
{
  double sum = 0.0;
  for (const double largest : Largest)
  {
    sum += std::fabs(*modes++) * largest;
  }
  const int operations = degree_[0] + degree_[1] + degree_[2] + 9;
  // Covers the rounding of the sum and of the products of three magnitudes.
  return sum * Gamma(operations) * (1.0 + Gamma(static_cast<int>(Largest.size()) + 64));
}

Vec3 BernsteinForm::GridPoint(int i, int j, int k) const
{
  const auto at = [](int index, int degree)
  { return degree == 0 ? 0.0 : static_cast<double>(2 * index - degree) / degree; };
  return { at(i, degree_[0]), at(j, degree_[1]), at(k, degree_[2]) };
}

Hull HullOf(std::span<const double> bernstein)
{
  const NumberExtremes extremes = ExtremesOf(bernstein);
  if (extremes.finite)
  {
    return { extremes.least, extremes.most };
  }
  const auto [low, high] = std::ranges::minmax_element(bernstein);
  return { *low, *high };
}
} // namespace pixelexact
