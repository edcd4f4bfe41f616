// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Quadric.h"

#include "Core/Math/Mat.h"
#include "Trace/Surfaces/Arguments.h"
#include "Trace/Surfaces/PairArithmetic.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
constexpr int kNoExponent = -100000;

int ExponentOf(double x)
{
  return x == 0.0 ? kNoExponent : std::ilogb(x);
}

int ExponentOf(const DoublePair* numbers, int count)
{
  int largest = kNoExponent;
  for (int i = 0; i < count; ++i)
  {
    largest = std::max(largest, ExponentOf(numbers[i].high));
  }
  return largest;
}

/// The index of Q(i, j) in QuadraticForm::Q.
int At(int i, int j)
{
  return i == j ? i : (i + j == 1 ? 3 : (i + j == 3 ? 4 : 5));
}

using PairVec3 = std::array<DoublePair, 3>;

DoublePair Dot(const PairVec3& a, const PairVec3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

PairVec3 Apply(const DoublePair (&Q)[6], const PairVec3& x)
{
  PairVec3 y;
  for (int i = 0; i < 3; ++i)
  {
    y[static_cast<std::size_t>(i)] = Dot({ Q[At(i, 0)], Q[At(i, 1)], Q[At(i, 2)] }, x);
  }
  return y;
}

/// f(linear x + offset), centred at the approximate preimage of the form's centre.
QuadraticForm Moved(const QuadraticForm& form, const AffineMap& map, const char* what)
{
  const Mat3& M = map.linear;
  QuadraticForm moved;
  moved.centre = map.Preimage(form.centre, what);
  PairVec3 columns[3];
  PairVec3 delta; // where the new centre goes, less the old one
  for (int i = 0; i < 3; ++i)
  {
    const auto row = static_cast<std::size_t>(i);
    delta[row] = ExactSum(map.offset[i], -form.centre[i]);
    for (int j = 0; j < 3; ++j)
    {
      columns[j][row] = { M[j][i], 0.0 };
      delta[row] = delta[row] + ExactProduct(M[j][i], moved.centre[j]);
    }
  }
  const PairVec3 Qdelta = Apply(form.Q, delta);
  const PairVec3 b{ form.b[0], form.b[1], form.b[2] };
  PairVec3 gradient;
  for (std::size_t i = 0; i < 3; ++i)
  {
    gradient[i] = Qdelta[i] + b[i];
  }
  for (int j = 0; j < 3; ++j)
  {
    const PairVec3 Qcolumn = Apply(form.Q, columns[j]);
    for (int i = 0; i <= j; ++i)
    {
      moved.Q[At(i, j)] = Dot(columns[i], Qcolumn);
    }
    moved.b[j] = Dot(columns[j], gradient);
  }
  moved.k = Dot(delta, Qdelta) + 2.0 * Dot(b, delta) + form.k;
  return moved;
}

/// Multiplies by a power of two, so that B^2 and A C are of size 1 for rays at the surface's scale.
void Scale(QuadraticForm& form)
{
  const int q = ExponentOf(form.Q, 6);
  const int b = ExponentOf(form.b, 3);
  const int k = ExponentOf(form.k.high);
  const bool hasBoth = q != kNoExponent && k != kNoExponent;
  int size = std::max(b, hasBoth ? (q + k) / 2 : kNoExponent);
  if (size == kNoExponent)
  {
    size = q;
  }
  // Keeps squares below the largest number.
  size = std::max(size, std::max({ q, b, k }) - 300);
  for (DoublePair& number : form.Q)
  {
    number = TimesPowerOfTwo(number, -size);
  }
  for (DoublePair& number : form.b)
  {
    number = TimesPowerOfTwo(number, -size);
  }
  form.k = TimesPowerOfTwo(form.k, -size);
}

bool IsZero(const DoublePair& a)
{
  return a.high == 0.0;
}
bool AreEqual(const DoublePair& a, const DoublePair& b)
{
  return a.high == b.high && a.low == b.low;
}

DoublePair SquaredLength(const Vec3& a)
{
  return ExactProduct(a.x, a.x) + ExactProduct(a.y, a.y) + ExactProduct(a.z, a.z);
}

/// across (a.a |x|^2 - (a.x)^2) - along (a.x)^2
QuadraticForm AroundAxis(
  const Vec3& centre, const Vec3& a, const DoublePair& across, const DoublePair& along)
{
  QuadraticForm form;
  form.centre = centre;
  for (int i = 0; i < 3; ++i)
  {
    // The squares of the other two coordinates are added, which avoids cancellation.
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    form.Q[At(i, i)] = across * (ExactProduct(a[j], a[j]) + ExactProduct(a[k], a[k])) -
      along * ExactProduct(a[i], a[i]);
    form.Q[At(i, j)] = -((across + along) * ExactProduct(a[i], a[j]));
  }
  return form;
}

/// AroundAxis divided by across a.a, without the constant k.
AxisForm RoundAbout(
  const Vec3& centre, const Vec3& a, const DoublePair& across, const DoublePair& along)
{
  AxisForm form;
  form.centre = centre;
  const DoublePair stretch = (across + along) / across;
  // The length of an axis along a coordinate is exact.
  const bool isExact = LargestOf(a) == std::fabs(a.x) + std::fabs(a.y) + std::fabs(a.z);
  const DoublePair factor = SquareRoot(isExact ? stretch : stretch / SquaredLength(a));
  for (int d = 0; d < 3; ++d)
  {
    const double sign = a[d] == 0.0 ? 0.0 : std::copysign(1.0, a[d]);
    form.v[d] = (isExact ? sign : a[d]) * factor;
  }
  return form;
}

/// The squares of an angle's sine and cosine, with relative errors of some 2^-100.
struct Squares
{
  DoublePair sine;
  DoublePair cosine;
};

Squares SquaresOf(double degrees)
{
  constexpr DoublePair kPi{ 0x1.921fb54442d18p1, 0x1.1a62633145c07p-53 };
  const bool isSteep = degrees > 45.0;
  const DoublePair angle =
    (isSteep ? ExactSum(90.0, -degrees) : DoublePair{ degrees, 0.0 }) * kPi / DoublePair{ 180.0 };
  // Taylor's series: for at most 45 degrees, 28 terms leave less than 2^-110.
  DoublePair sine;
  DoublePair cosine{ 1.0, 0.0 };
  DoublePair term{ 1.0, 0.0 };
  for (int n = 1; n <= 28; ++n)
  {
    term = term * angle / DoublePair{ static_cast<double>(n) };
    DoublePair& sum = n % 2 == 0 ? cosine : sine;
    sum = n % 4 < 2 ? sum + term : sum - term;
  }
  const Squares squares{ sine * sine, cosine * cosine };
  return isSteep ? Squares{ squares.cosine, squares.sine } : squares;
}
} // namespace

Quadric::Quadric(const QuadraticForm& form, const AffineMap& toFunction, const char* what)
  : Form(form)
{
  if (!toFunction.IsIdentity())
  {
    // Scaled before and after, so that no intermediate result overflows.
    Scale(Form);
    Form = Moved(Form, toFunction, what);
  }
  const int largest = std::max(ExponentOf(Form.Q, 6), ExponentOf(Form.b, 3));
  if (largest == kNoExponent)
  {
    Refuse(what, "its function is constant; give a coefficient of x, y or z.");
  }
  const auto& Q = Form.Q;
  IsCentred = IsZero(Form.b[0]) && IsZero(Form.b[1]) && IsZero(Form.b[2]);
  IsSphere = IsCentred && !IsZero(Q[0]) && AreEqual(Q[0], Q[1]) && AreEqual(Q[0], Q[2]) &&
    IsZero(Q[3]) && IsZero(Q[4]) && IsZero(Q[5]);
  if (IsSphere)
  {
    SquaredRadius = -Form.k / Q[0];
  }
  Scale(Form);
  if (!std::isfinite(Form.k.high + SquaredRadius.high) || !IsFinite(Form.centre))
  {
    Refuse(what, "its coefficients are out of range; give lengths between 1e-100 and 1e100.");
  }
}

void Quadric::Meet(const RayLanes& rays, HitSlots& hits) const
{
  const QuadricKernels& kernels = GetQuadricKernels();
  if (IsSphere)
  {
    kernels.meetSphere(Form.centre, SquaredRadius, rays, hits);
  }
  else if (IsRound)
  {
    kernels.meetRound(Round, rays, hits);
  }
  else
  {
    (IsCentred ? kernels.meetCentred : kernels.meetQuadric)(Form, rays, hits);
  }
}

Vec3 Quadric::HalfGradient(const Vec3& position) const
{
  PairVec3 x;
  for (int d = 0; d < 3; ++d)
  {
    x[static_cast<std::size_t>(d)] = ExactSum(position[d], -Form.centre[d]);
  }
  const PairVec3 Qx = Apply(Form.Q, x);
  Vec3 gradient;
  for (int d = 0; d < 3; ++d)
  {
    gradient[d] = (Qx[static_cast<std::size_t>(d)] + Form.b[d]).high;
  }
  return gradient;
}

Vec3 Quadric::Normal(const SurfacePoint& point) const
{
  const Vec3 gradient = HalfGradient(point.position);
  if (!(LargestOf(gradient) > 0.0))
  {
    return { 0.0, 0.0, 1.0 };
  }
  return UnitDirection(gradient);
}

Quadric MakeSphere(const Vec3& centre, double radius, const AffineMap& toFunction)
{
  CheckPosition(centre, "sphere");
  CheckRadius(radius, "sphere");
  QuadraticForm form;
  form.centre = centre;
  form.Q[0] = form.Q[1] = form.Q[2] = { 1.0, 0.0 };
  form.k = -ExactProduct(radius, radius);
  return Quadric(form, toFunction, "sphere");
}

Quadric MakeCylinder(
  const Vec3& point, const Vec3& axis, double radius, const AffineMap& toFunction)
{
  CheckPosition(point, "cylinder");
  CheckRadius(radius, "cylinder");
  const Vec3 a = ScaledDirection(axis, "cylinder", "axis");
  QuadraticForm form = AroundAxis(point, a, { 1.0, 0.0 }, { 0.0, 0.0 });
  const DoublePair square = ExactProduct(radius, radius);
  form.k = -(SquaredLength(a) * square);
  Quadric cylinder(form, toFunction, "cylinder");
  cylinder.IsRound = toFunction.IsIdentity();
  cylinder.Round = RoundAbout(point, a, { 1.0, 0.0 }, { 0.0, 0.0 });
  cylinder.Round.k = -square;
  return cylinder;
}

Quadric MakeCone(
  const Vec3& apex, const Vec3& axis, double halfAngleDegrees, const AffineMap& toFunction)
{
  CheckPosition(apex, "cone");
  if (!(halfAngleDegrees > 0.0 && halfAngleDegrees < 90.0))
  {
    Refuse("cone", "its angle is not between 0 and 90 degrees; give one that is.");
  }
  const Vec3 a = ScaledDirection(axis, "cone", "axis");
  const Squares squares = SquaresOf(halfAngleDegrees);
  Quadric cone(AroundAxis(apex, a, squares.cosine, squares.sine), toFunction, "cone");
  // For a slender cone, |x|^2 - (v.x)^2 cancels, and v's rounding would change its angle.
  cone.IsRound = toFunction.IsIdentity() && halfAngleDegrees >= 1.0;
  cone.Round = RoundAbout(apex, a, squares.cosine, squares.sine);
  return cone;
}

Quadric MakeQuadric(const std::array<double, 10>& a, const AffineMap& toFunction)
{
  double largest = 0.0;
  for (const double number : a)
  {
    if (!std::isfinite(number))
    {
      Refuse("quadric", "a coefficient is not a finite number.");
    }
    largest = std::max(largest, std::fabs(number));
  }
  // After scaling, the division of the largest and smallest coefficients by two is exact.
  const int exponent = largest > 0.0 ? std::ilogb(largest) : 0;
  const auto scaled = [&](std::size_t i, int more) {
    return DoublePair{ std::ldexp(a[i], -exponent - more), 0.0 };
  };
  QuadraticForm form;
  for (std::size_t i = 0; i < 3; ++i)
  {
    form.Q[i] = scaled(i, 0);
    form.Q[3 + i] = scaled(3 + i, 1);
    form.b[i] = scaled(6 + i, 1);
  }
  form.k = scaled(9, 0);
  return Quadric(form, toFunction);
}

std::vector<SurfacePatch> Quadric::Implicit() const
{
  ImplicitPolynomial polynomial;
  polynomial.origin = Form.centre;
  for (std::size_t i = 0; i < 6; ++i)
  {
    polynomial.a.q[i] = (i < 3 ? 1.0 : 2.0) * Form.Q[i].high;
  }
  polynomial.a.g = 2.0 * Vec3(Form.b[0].high, Form.b[1].high, Form.b[2].high);
  polynomial.a.c = Form.k.high;
  return { { polynomial } };
}
} // namespace pixelexact
