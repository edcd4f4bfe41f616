// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/MeshDiagnostics.h"

#include "Core/Element/Kernels.h"
#include "Core/Shape/Shape.h"
#include "Formats/Slab.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace pixelexact
{
namespace
{
// J = A + E, |E_cd| <= R_cd. If the largest row sum rho of |A^-1| R is below 1, A + t E is regular
// for all t in [0,1]: det J has the sign of det A, and |det J| >= |det A| (1 - rho)^3, for the
// eigenvalues of A^-1 J are no nearer to 0 than 1 - rho.

/// The ranges of the gradients of a space's modes over sample points. They bound the distance of a
/// map's Jacobian at the samples from a central matrix. This often decides the sign of det J at all
/// samples without evaluating it there.
class GradientSpread
{
public:
  GradientSpread(const Space& space, const LanePoints& samples);

  /// Returns 1 or -1 where det J has this sign at every sample, and |det J| is above `vanishing`
  /// times the product of the lengths of J's columns; 0 where that is not decided. `coefficients`:
  /// three components.
  [[nodiscard]] int SignOfJacobian(const double* coefficients, double vanishing) const;

private:
  /// The range of a mode's derivative by one xi: middle +- reach.
  struct Range
  {
    double middle;
    double reach;
  };
  std::vector<Range> Ranges; ///< three per mode
};

/// Limit of rho. Rounding is far smaller than 1 - rho then.
constexpr double kLargestRow = 0.999;

using Matrix = std::array<std::array<double, 3>, 3>;

Matrix Cofactors(const Matrix& a)
{
  Matrix cofactors{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      const std::size_t i1 = (i + 1) % 3;
      const std::size_t i2 = (i + 2) % 3;
      const std::size_t j1 = (j + 1) % 3;
      const std::size_t j2 = (j + 2) % 3;
      cofactors[i][j] = a[i1][j1] * a[i2][j2] - a[i1][j2] * a[i2][j1];
    }
  }
  return cofactors;
}

GradientSpread::GradientSpread(const Space& space, const LanePoints& samples)
{
  const auto modes = static_cast<std::size_t>(space.Modes());
  const auto padded = static_cast<std::size_t>(PaddedCount(samples.count));
  const auto count = static_cast<std::size_t>(samples.count);
  std::vector<double> unit(modes);
  std::vector<double> table(4 * padded);
  double* value = table.data();
  std::array<double*, 3> gradient{ &table[padded], &table[2 * padded], &table[3 * padded] };
  const KernelSet kernels = KernelsFor(space);
  for (std::size_t mode = 0; mode < modes; ++mode)
  {
    unit[mode] = 1.0;
    kernels.gradient(space, unit.data(), 1, samples, &value, gradient.data());
    unit[mode] = 0.0;
    for (const double* derivative : gradient)
    {
      const auto [least, most] = std::minmax_element(derivative, derivative + count);
      Ranges.push_back({ 0.5 * (*least + *most), 0.5 * (*most - *least) });
    }
  }
}

int GradientSpread::SignOfJacobian(const double* coefficients, double vanishing) const
{
  const std::size_t modes = Ranges.size() / 3;
  Matrix a{};
  Matrix reach{};
  for (std::size_t c = 0; c < 3; ++c)
  {
    for (std::size_t mode = 0; mode < modes; ++mode)
    {
      const double coefficient = coefficients[c * modes + mode];
      const double size = std::fabs(coefficient);
      for (std::size_t d = 0; d < 3; ++d)
      {
        a[c][d] += coefficient * Ranges[3 * mode + d].middle;
        reach[c][d] += size * Ranges[3 * mode + d].reach;
      }
    }
  }
  const Matrix cofactors = Cofactors(a);
  const double det =
    a[0][0] * cofactors[0][0] + a[0][1] * cofactors[0][1] + a[0][2] * cofactors[0][2];
  double rho = 0.0;
  double columns = 1.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    double row = 0.0;
    double square = 0.0;
    for (std::size_t c = 0; c < 3; ++c)
    {
      // Row i of the inverse is column i of the cofactors.
      row += std::fabs(cofactors[c][i]) * (reach[c][0] + reach[c][1] + reach[c][2]);
      const double most = std::fabs(a[c][i]) + reach[c][i];
      square += most * most;
    }
    rho = std::max(rho, row);
    columns *= std::sqrt(square);
  }
  rho /= std::fabs(det);
  const double rest = 1.0 - rho;
  if (!(rho <= kLargestRow) || !(std::fabs(det) * rest * rest * rest > vanishing * columns))
  {
    return 0;
  }
  return det > 0.0 ? 1 : -1;
}

/// Determinants below this, relative to the product of the lengths of the Jacobian's columns, count
/// as zero.
constexpr double kVanishing = 1e-9;

enum class Sign : std::uint8_t
{
  Positive,
  Negative,
  Mixed ///< changes, or vanishes somewhere
};

struct Samples
{
  std::array<std::vector<double>, 3> xi; ///< padded for the kernels
  int count = 0;
};

/// Samples a tensor grid of eta, vertices included, mapped to xi, twice as fine as the order.
Samples MakeSamples(const Space& space)
{
  Samples samples;
  auto& xi = samples.xi;
  const int n = std::min(2 * space.MaxOrder(), 16);
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= n; ++j)
    {
      for (int k = 0; k <= n; ++k)
      {
        const auto z = [&](int m) { return 2.0 * m / n - 1.0; };
        if (space.shape == Shape::Pyramid && k == n)
        {
          continue; // the map is not differentiable at the apex
        }
        const Vec3 point = TensorToReference(space.shape, { z(i), z(j), z(k) });
        for (int d = 0; d < 3; ++d)
        {
          xi[d].push_back(point[d]);
        }
      }
    }
  }
  samples.count = static_cast<int>(xi[0].size());
  for (auto& x : xi)
  {
    x.resize(PaddedCount(samples.count), x.back());
  }
  return samples;
}

Sign SampledSign(const Mesh& mesh, int element, const Samples& samples)
{
  const Space& space = mesh.map.SpaceOf(element);
  const auto& xi = samples.xi;
  const int count = samples.count;
  const int padded = PaddedCount(count);
  std::vector<double> table(static_cast<std::size_t>(12) * padded);
  std::array<double*, 3> value{};
  std::array<double*, 9> gradient{};
  for (int i = 0; i < 12; ++i)
  {
    (i < 3 ? value[i] : gradient[i - 3]) = &table[static_cast<std::size_t>(i) * padded];
  }
  KernelsFor(space).gradient(space, mesh.map.Coefficients(element), 3,
    { { xi[0].data(), xi[1].data(), xi[2].data() }, count }, value.data(), gradient.data());
  int positive = 0;
  int negative = 0;
  for (int i = 0; i < count; ++i)
  {
    const auto column = [&](int d)
    { return Vec3(gradient[d][i], gradient[3 + d][i], gradient[6 + d][i]); };
    const Vec3 a = column(0);
    const Vec3 b = column(1);
    const Vec3 c = column(2);
    const double det =
      a.x * (b.y * c.z - b.z * c.y) - a.y * (b.x * c.z - b.z * c.x) + a.z * (b.x * c.y - b.y * c.x);
    const auto length = [](const Vec3& v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); };
    const double zero = kVanishing * length(a) * length(b) * length(c);
    positive += det > zero ? 1 : 0;
    negative += det < -zero ? 1 : 0;
  }
  return positive == count ? Sign::Positive : negative == count ? Sign::Negative : Sign::Mixed;
}

/// The samples of one space.
struct SpaceSamples
{
  Samples samples;
  std::optional<GradientSpread> spread; ///< where there are elements enough to be worth it
};

Sign SignOf(const Mesh& mesh, int element, const SpaceSamples& space)
{
  if (space.spread)
  {
    const int sign = space.spread->SignOfJacobian(mesh.map.Coefficients(element), kVanishing);
    if (sign != 0)
    {
      return sign > 0 ? Sign::Positive : Sign::Negative;
    }
  }
  return SampledSign(mesh, element, space.samples);
}

/// Makes the samples of each space. A spread costs an evaluation of each mode at all samples, so it
/// is made only for spaces with many elements.
std::vector<SpaceSamples> MakeSpaceSamples(const Mesh& mesh)
{
  std::vector<std::int64_t> elements(mesh.map.spaces.size());
  for (const auto space : mesh.map.spaceOf)
  {
    ++elements[space];
  }
  std::vector<SpaceSamples> all;
  for (std::size_t s = 0; s < elements.size(); ++s)
  {
    const Space& space = mesh.map.spaces[s];
    all.push_back({ MakeSamples(space), std::nullopt });
    if (elements[s] > space.Modes())
    {
      const auto& xi = all.back().samples.xi;
      all.back().spread.emplace(space,
        LanePoints{ { xi[0].data(), xi[1].data(), xi[2].data() }, all.back().samples.count });
    }
  }
  return all;
}

struct SignedElements
{
  int count = 0;
  std::int64_t first = -1;

  void Add(std::int64_t cell) { first = count++ == 0 ? cell : first; }
};

std::string Sentence(const SignedElements& group, int all, const std::string& what)
{
  return std::to_string(group.count) + " of " + std::to_string(all) + " elements " + what +
    " (first: cell " + std::to_string(group.first) + "; sampled, not proven).";
}
} // namespace

std::vector<std::string> DiagnoseJacobian(
  const Mesh& mesh, std::span<const std::int64_t> sourceCells, bool isPlane)
{
  std::vector<Sign> sign(mesh.Elements());
  const std::vector<SpaceSamples> samples = MakeSpaceSamples(mesh);
  tbb::parallel_for(
    0, mesh.Elements(), [&](int e) { sign[e] = SignOf(mesh, e, samples[mesh.map.spaceOf[e]]); });

  SignedElements mixed;
  std::array<std::array<SignedElements, 2>, kShapeCount> oneSigned; // positive, negative
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    auto& group = sign[e] == Sign::Mixed
      ? mixed
      : oneSigned[static_cast<int>(mesh.ShapeOf(e))][sign[e] == Sign::Negative ? 1 : 0];
    group.Add(sourceCells[e]);
  }
  std::vector<std::string> lines;
  if (mixed.count > 0)
  {
    lines.push_back(Sentence(mixed, mesh.Elements(),
      "have a Jacobian determinant that vanishes or changes sign: their map folds or degenerates, "
      "points in them may have several reference coordinates"));
  }
  for (int s = 0; s < kShapeCount; ++s)
  {
    const auto& [positive, negative] = oneSigned[s];
    const SignedElements& fewer = positive.count < negative.count ? positive : negative;
    if (fewer.count > 0)
    {
      lines.push_back(Sentence(fewer, positive.count + negative.count,
        std::string("of shape ") +
          (isPlane ? PlaneName(static_cast<Shape>(s)) : Name(static_cast<Shape>(s))) +
          " are inside out compared with the others (Jacobian determinant of the other sign)"));
    }
  }
  return lines;
}
} // namespace pixelexact
