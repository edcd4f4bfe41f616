// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Bounds/InverseGuess.h"

#include "Core/Bounds/TensorLattice.h"
#include "Core/Element/LaneBuffer.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <glm/common.hpp>

#include <array>

namespace pixelexact
{
namespace
{
/// Points along each eta: Chebyshev's, stretched so that the outermost lie on the faces. The
/// polynomial is not evaluated outside of them.
constexpr int kGuessPoints = kGuessDegree + 2;

using Terms = Eigen::Matrix<double, 1, kGuessTerms>;

Terms TermsAt(const Vec3& s)
{
  std::array<Vec3, kGuessDegree + 1> power;
  power[0] = Vec3(1.0);
  for (std::size_t n = 1; n < power.size(); ++n)
  {
    power[n] = power[n - 1] * s;
  }
  const auto of = [&power](int n, int axis) { return power[static_cast<std::size_t>(n)][axis]; };
  Terms terms;
  int at = 0;
  for (int i = kGuessDegree; i >= 0; --i)
  {
    for (int j = kGuessDegree - i; j >= 0; --j)
    {
      for (int k = kGuessDegree - i - j; k >= 0; --k)
      {
        terms[at++] = of(i, 0) * of(j, 1) * of(k, 2);
      }
    }
  }
  return terms;
}

std::vector<Vec3> SamplePoints(Shape shape)
{
  std::array<double, kGuessPoints> eta{};
  for (int i = 0; i < kGuessPoints; ++i)
  {
    eta[static_cast<std::size_t>(i)] =
      ChebyshevPoint(i, kGuessPoints) / ChebyshevPoint(0, kGuessPoints);
  }
  return TensorLattice(shape, eta);
}

/// The affine frame's preimages of the points Phi(xi).
std::vector<Vec3> FrameImages(const InverseProblem& problem, const std::vector<Vec3>& xi)
{
  const LaneBuffer at(xi);
  std::vector<double> y[3];
  double* out[3];
  for (int c = 0; c < 3; ++c)
  {
    y[c].resize(static_cast<std::size_t>(PaddedCount(static_cast<int>(xi.size()))));
    out[c] = y[c].data();
  }
  KernelsFor(problem.space).value(problem.space, problem.coefficients, 3, at.View(), out);
  std::vector<Vec3> images(xi.size());
  for (std::size_t k = 0; k < xi.size(); ++k)
  {
    for (int d = 0; d < 3; ++d)
    {
      double sum = problem.start[d];
      for (int c = 0; c < 3; ++c)
      {
        sum += problem.inverse[3 * d + c] * (out[c][k] - problem.origin[c]);
      }
      images[k][d] = sum;
    }
  }
  return images;
}
} // namespace

InverseGuess MakeInverseGuess(const InverseProblem& problem)
{
  const std::vector<Vec3> xi = SamplePoints(problem.space.shape);
  const std::vector<Vec3> images = FrameImages(problem, xi);
  InverseGuess guess;
  Vec3 lower = images[0];
  Vec3 upper = images[0];
  for (const Vec3& image : images)
  {
    lower = glm::min(lower, image);
    upper = glm::max(upper, image);
  }
  const Vec3 centre = 0.5 * (lower + upper);
  const Vec3 scale = 2.0 / (upper - lower);
  const auto count = static_cast<Eigen::Index>(xi.size());
  Eigen::Matrix<double, Eigen::Dynamic, kGuessTerms> rows(count, kGuessTerms);
  Eigen::Matrix<double, Eigen::Dynamic, 3> wanted(count, 3);
  Eigen::Matrix<double, Eigen::Dynamic, 3> framed(count, 3);
  for (Eigen::Index k = 0; k < count; ++k)
  {
    const Vec3& image = images[static_cast<std::size_t>(k)];
    const Vec3& at = xi[static_cast<std::size_t>(k)];
    rows.row(k) = TermsAt((image - centre) * scale);
    wanted.row(k) << at.x, at.y, at.z;
    framed.row(k) << image.x, image.y, image.z;
  }
  // One product of whole matrices takes half the time of products row by row.
  Eigen::Matrix<double, kGuessTerms, kGuessTerms> normal;
  normal.setZero();
  normal.selfadjointView<Eigen::Lower>().rankUpdate(rows.transpose());
  const Eigen::Matrix<double, kGuessTerms, 3> terms =
    normal.ldlt().solve(rows.transpose() * wanted);
  const double error = (rows * terms - wanted).cwiseAbs().maxCoeff();
  const double frameError = (framed - wanted).cwiseAbs().maxCoeff();
  if (terms.allFinite() && error < 0.5 * frameError)
  {
    guess.error = error;
  }
  auto* term = guess.terms.data();
  for (int d = 0; d < 3; ++d)
  {
    guess.centre[static_cast<std::size_t>(d)] = centre[d];
    guess.scale[static_cast<std::size_t>(d)] = scale[d];
    for (int i = 0; i < kGuessTerms; ++i)
    {
      *term++ = terms(i, d);
    }
  }
  return guess;
}
} // namespace pixelexact
