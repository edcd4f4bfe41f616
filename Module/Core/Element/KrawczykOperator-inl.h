// SPDX-License-Identifier: BSD-3-Clause
// Krawczyk's operator for the inverse map, in balls. Included once per instruction set.
//
// With y = (x - centre) / size, r = Phi(xi0) - y, C about the inverse Jacobian and X a box around
// xi0 of radius rho, every zero of C (Phi - y) in X lies in
//   K = xi0 - C r + (I - C J(X)) (X - xi0),
// and if K lies inside of X there is one, by Brouwer's theorem; C and every matrix in J(X) are then
// regular, so that it is a preimage of y and the only one in X.
#if defined(PIXELEXACT_KRAWCZYK_OPERATOR_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_KRAWCZYK_OPERATOR_INL_H
#undef PIXELEXACT_KRAWCZYK_OPERATOR_INL_H
#else
#define PIXELEXACT_KRAWCZYK_OPERATOR_INL_H
#endif

#include "Core/Element/BallKernels-inl.h"
#include "Core/Element/EnclosureTask.h"
#include "Core/Element/Matrix-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// The parts of K for one pack of points xi0.
class KrawczykOperator
{
public:
  HWY_INLINE KrawczykOperator(
    const EnclosureTask& task, const BallKernels& kernels, const Point<Lanes>& xi)
    : Task(task)
    , Kernels(kernels)
    , Xi(xi)
  {
  }

  /// r, from the difference of x and centre without rounding.
  HWY_INLINE void Evaluate(const Point<Lanes>& x)
  {
    const Lanes zero = Splat(0.0);
    Kernels.values(
      Task.mapSpace, Task.mapCoefficients, 3, BoxAround(Xi, { { zero, zero, zero } }), Residual.x);
    const Lanes inverseSize = Splat(Task.inverseSize);
    for (int d = 0; d < 3; ++d)
    {
      const Pair difference = ExactSum(x.x[d], Splat(-Task.centre[d]));
      const Ball high{ difference.high * inverseSize, Splat(ball::kTiny) };
      const Ball low{ difference.low * inverseSize, Splat(Task.uncertainty + ball::kTiny) };
      Residual.x[d] = (Residual.x[d] - high) - low;
    }
  }

  /// C, C r and bounds of |I - C J(X)|, X the box of this size around xi0.
  HWY_INLINE void Linearise(const Point<Lanes>& size)
  {
    Ball value[3];
    Ball jacobian[9];
    Kernels.gradients(Task.mapSpace, Task.mapCoefficients, 3, BoxAround(Xi, size), value, jacobian);
    Matrix<Lanes> middle;
    for (int k = 0; k < 9; ++k)
    {
      middle.m[k] = jacobian[k].middle;
    }
    C = Inverse(middle);
    Step = Solved(Residual.x);
    for (int i = 0; i < 3; ++i)
    {
      const Ball row[3] = { Ball::Exactly(C.m[3 * i]), Ball::Exactly(C.m[3 * i + 1]),
        Ball::Exactly(C.m[3 * i + 2]) };
      for (int j = 0; j < 3; ++j)
      {
        const Ball one = Ball::Exactly(Splat(i == j ? 1.0 : 0.0));
        Distance.m[3 * i + j] = NegMulAdd(row[0], jacobian[j],
          NegMulAdd(row[1], jacobian[3 + j], NegMulAdd(row[2], jacobian[6 + j], one)))
                                  .Magnitude();
      }
    }
  }

  /// C times a vector.
  HWY_INLINE Point<Ball> Solved(const Ball* vector) const
  {
    Point<Ball> out;
    for (int i = 0; i < 3; ++i)
    {
      const auto at = [&](int j) { return Ball::Exactly(C.m[3 * i + j]); };
      out.x[i] = MulAdd(at(0), vector[0], MulAdd(at(1), vector[1], at(2) * vector[2]));
    }
    return out;
  }

  /// |I - C J(X)| rho.
  HWY_INLINE Point<Lanes> Spread(const Point<Lanes>& rho) const
  {
    Point<Lanes> out;
    for (int i = 0; i < 3; ++i)
    {
      out.x[i] = ball::RoundUp(MulAdd(Distance.m[3 * i], rho.x[0],
        MulAdd(Distance.m[3 * i + 1], rho.x[1], Distance.m[3 * i + 2] * rho.x[2])));
    }
    return out;
  }

  Point<Ball> Residual; ///< r
  Point<Ball> Step;     ///< C r

private:
  const EnclosureTask& Task;
  const BallKernels& Kernels;
  const Point<Lanes>& Xi;
  Matrix<Lanes> C;        ///< about the inverse Jacobian
  Matrix<Lanes> Distance; ///< bounds of |I - C J(X)|
};
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
