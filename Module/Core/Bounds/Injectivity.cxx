// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Bounds/Injectivity.h"

#include "Core/Basis/ChangeOfBasis.h"
#include "Core/Bernstein/BernsteinForm.h"
#include "Core/Element/Kernels.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace pixelexact
{
namespace
{
/// Enlargements of the shape about its centre that are tried, the largest first.
constexpr std::array<double, 3> kScales{ 1.5, 1.2, 1.05 };

/// The smallest eigenvalue must be above this: far above all rounding of the enclosures.
constexpr double kDefinite = 1e-3;

/// Modes of f(s (xi - c) + c) and of its derivatives by xi before scaling, as matrices on the modes
/// of f. For hexahedra, where c = 0, they are products of one-dimensional ones.
struct ScaledDerivatives
{
  double margin = 0.0;
  bool separable = false;
  /// separable: per direction, plain and differentiated, (n + 1) x (n + 1); else: [0] per
  /// direction, modes x modes, row-major.
  std::array<std::array<std::vector<double>, 3>, 2> matrix;
};

/// The matrix of a linear map of modes, given the images of all modes as functions.
std::vector<double> MatrixOf(
  const Space& space, const std::function<void(const LongVec3&, long double*)>& images)
{
  const auto size = static_cast<std::size_t>(space.Modes());
  const auto change = ChangeOfBasis::FromFunctions(space, space.Modes(), images);
  std::vector<double> matrix(size * size);
  std::vector<double> unit(size, 0.0);
  std::vector<double> column(size);
  for (std::size_t k = 0; k < size; ++k)
  {
    unit[k] = 1.0;
    change.Apply(unit, 0.0, column);
    unit[k] = 0.0;
    for (std::size_t row = 0; row < size; ++row)
    {
      matrix[row * size + k] = column[row];
    }
  }
  return matrix;
}

/// All modes, or their derivatives by xi_direction, at one point.
class ModeEvaluator
{
public:
  explicit ModeEvaluator(const Space& space)
    : space_(space)
    , Modes(static_cast<std::size_t>(space.Modes()))
    , Identity(Modes * Modes, 0.0)
    , Lanes(4 * Modes * kLanePadding)
    , ValueTo(Modes)
    , GradientTo(3 * Modes)
  {
    for (std::size_t mode = 0; mode < Modes; ++mode)
    {
      Identity[mode * Modes + mode] = 1.0;
      ValueTo[mode] = &Lanes[4 * mode * kLanePadding];
      for (std::size_t d = 0; d < 3; ++d)
      {
        GradientTo[3 * mode + d] = ValueTo[mode] + (d + 1) * kLanePadding;
      }
    }
  }

  /// direction < 0: the values.
  void operator()(const Vec3& xi, int direction, long double* out)
  {
    double x[3][kLanePadding];
    for (int d = 0; d < 3; ++d)
    {
      std::fill_n(x[d], kLanePadding, xi[d]);
    }
    KernelsFor(space_).gradient(space_, Identity.data(), static_cast<int>(Modes),
      { { x[0], x[1], x[2] }, 1 }, ValueTo.data(), GradientTo.data());
    for (std::size_t k = 0; k < Modes; ++k)
    {
      out[k] =
        direction < 0 ? *ValueTo[k] : *GradientTo[3 * k + static_cast<std::size_t>(direction)];
    }
  }

private:
  Space space_;
  std::size_t Modes;
  std::vector<double> Identity;
  std::vector<double> Lanes;
  std::vector<double*> ValueTo;
  std::vector<double*> GradientTo;
};

ScaledDerivatives MakeScaledDerivatives(const Space& space, double scale)
{
  const Vec3 centre = Centre(space.shape);
  ScaledDerivatives result;
  result.margin = (scale - 1.0) * Margin(space.shape, centre);
  result.separable = space.shape == Shape::Hexahedron;
  const auto scaled = [&](const LongVec3& xi)
  {
    Vec3 x;
    for (int d = 0; d < 3; ++d)
    {
      x[d] = centre[d] + scale * (static_cast<double>(xi[d]) - centre[d]);
    }
    return x;
  };
  for (int d = 0; d < 3; ++d)
  {
    if (!result.separable)
    {
      ModeEvaluator evaluate(space);
      result.matrix[0][d] = MatrixOf(
        space, [&](const LongVec3& xi, long double* out) { evaluate(scaled(xi), d, out); });
      continue;
    }
    const Space line{ Shape::Hexahedron, Form::Collapsed, { space.order[d], 0, 0 } };
    ModeEvaluator evaluate(line);
    for (int derivative = 0; derivative < 2; ++derivative)
    {
      result.matrix[derivative][d] = MatrixOf(line,
        [&](const LongVec3& xi, long double* out)
        { evaluate(scaled(xi), derivative == 1 ? 0 : -1, out); });
    }
  }
  return result;
}

/// to = matrix applied along one axis of a tensor of modes.
void ApplyAlong(const std::vector<double>& matrix, std::size_t size, std::size_t stride,
  const std::vector<double>& from, std::vector<double>& to)
{
  for (std::size_t block = 0; block < from.size(); block += size * stride)
  {
    for (std::size_t row = 0; row < size; ++row)
    {
      for (std::size_t inner = 0; inner < stride; ++inner)
      {
        double sum = 0.0;
        for (std::size_t k = 0; k < size; ++k)
        {
          sum += matrix[row * size + k] * from[block + k * stride + inner];
        }
        to[block + row * stride + inner] = sum;
      }
    }
  }
}

/// Modes of (d_direction f)(scaled) from those of f.
std::vector<double> Differentiate(const Space& space, const ScaledDerivatives& derivatives,
  int direction, std::vector<double> modes)
{
  std::vector<double> next(modes.size());
  if (!derivatives.separable)
  {
    ApplyAlong(derivatives.matrix[0][direction], modes.size(), 1, modes, next);
    return next;
  }
  std::size_t stride = 1;
  for (int d = 2; d >= 0; --d)
  {
    const std::size_t size = space.order[d] + std::size_t{ 1 };
    ApplyAlong(derivatives.matrix[d == direction ? 1 : 0][d], size, stride, modes, next);
    modes.swap(next);
    stride *= size;
  }
  return modes;
}

const std::array<ScaledDerivatives, kScales.size()>& DerivativesOf(const Space& space)
{
  static std::mutex mutex;
  static std::map<Space, std::unique_ptr<std::array<ScaledDerivatives, kScales.size()>>> known;
  const std::scoped_lock lock(mutex);
  auto& entry = known[space];
  if (!entry)
  {
    entry = std::make_unique<std::array<ScaledDerivatives, kScales.size()>>();
    for (std::size_t i = 0; i < kScales.size(); ++i)
    {
      (*entry)[i] = MakeScaledDerivatives(space, kScales[i]);
    }
  }
  return *entry;
}

/// Whether the symmetric part of D(A^-1 Phi) is positive definite on the enlarged shape.
bool IsDefinite(const Space& space, const ScaledDerivatives& derivatives, const double* frame)
{
  const auto size = static_cast<std::size_t>(space.Modes());
  // Modes of the Jacobian's entries: entry[i][j] = d_j (A^-1 Phi)_i.
  std::array<std::array<std::vector<double>, 3>, 3> entry;
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      entry[i][j] = Differentiate(
        space, derivatives, j, std::vector<double>(frame + i * size, frame + (i + 1) * size));
    }
  }
  const auto& form = BernsteinForm::Of(space);
  std::vector<double> bernstein(form.Size());
  double circle[3] = { 0.0, 0.0, 0.0 };
  for (int i = 0; i < 3; ++i)
  {
    for (int j = i + 1; j < 3; ++j)
    {
      std::vector<double> sum(size);
      for (std::size_t k = 0; k < size; ++k)
      {
        sum[k] = 0.5 * (entry[i][j][k] + entry[j][i][k]);
      }
      form.Convert(sum.data(), bernstein);
      const Hull hull = HullOf(bernstein);
      const double radius = std::max(-hull.lower, hull.upper);
      circle[i] += radius;
      circle[j] += radius;
    }
  }
  for (int i = 0; i < 3; ++i)
  {
    form.Convert(entry[i][i].data(), bernstein);
    if (!(HullOf(bernstein).lower - circle[i] > kDefinite))
    {
      return false;
    }
  }
  return true;
}
} // namespace

double InjectiveMargin(const Space& space, const double* coefficients, const double* inverse)
{
  if (space.shape == Shape::Pyramid || space.MaxOrder() > kMaxInjectivityOrder ||
    (space.shape != Shape::Hexahedron && space.Modes() > kMaxInjectivityModes))
  {
    return 0.0;
  }
  const int modes = space.Modes();
  std::vector<double> frame(3 * static_cast<std::size_t>(modes));
  for (int i = 0; i < 3; ++i)
  {
    for (int k = 0; k < modes; ++k)
    {
      frame[i * modes + k] = inverse[3 * i] * coefficients[k] +
        inverse[3 * i + 1] * coefficients[modes + k] +
        inverse[3 * i + 2] * coefficients[2 * modes + k];
    }
  }
  for (const auto& derivatives : DerivativesOf(space))
  {
    if (IsDefinite(space, derivatives, frame.data()))
    {
      return derivatives.margin;
    }
  }
  return 0.0;
}
} // namespace pixelexact
