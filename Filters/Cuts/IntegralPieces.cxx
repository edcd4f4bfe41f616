// SPDX-License-Identifier: BSD-3-Clause
#include "Cuts/IntegralPieces.h"

#include "Cuts/VtkCutFunction.h"
#include "HighOrderModel.h"
#include "vtkImplicitTorus.h"

#include "Core/Base/Error.h"
#include "Core/Location/Locator.h"

#include "vtkImplicitFunction.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace pixelexact
{
namespace
{
/// Of a plane or quadric; nothing of other functions.
std::optional<QuadricForm> FormOf(vtkImplicitFunction* function)
{
  // Planes and quadrics need no length.
  const auto cut = MakeCutFunction(function, 1.0);
  const QuadricForm* const form = cut->Quadric();
  return form != nullptr ? std::optional(*form) : std::nullopt;
}

/// The matrix of a quadric's terms of degree 2: its function is z Q z + g z + c.
std::array<Vec3, 3> MatrixOf(const QuadricForm& form)
{
  const auto& q = form.q;
  return { Vec3(q[0], q[3] / 2.0, q[5] / 2.0), Vec3(q[3] / 2.0, q[1], q[4] / 2.0),
    Vec3(q[5] / 2.0, q[4] / 2.0, q[2]) };
}

/// The direction of the largest diagonal coefficient of Q.
int LargestDiagonal(const std::array<Vec3, 3>& matrix)
{
  int largest = 0;
  for (int d = 1; d < 3; ++d)
  {
    const auto at = [&matrix](int k) { return std::abs(matrix[static_cast<std::size_t>(k)][k]); };
    largest = at(d) > at(largest) ? d : largest;
  }
  return largest;
}

/// The form times the power of two that brings the largest diagonal coefficient of Q into [1,2):
/// products of its coefficients neither underflow nor overflow. Nothing where there is none.
std::optional<QuadricForm> InUnits(const QuadricForm& form)
{
  const auto matrix = MatrixOf(form);
  const int axis = LargestDiagonal(matrix);
  const double a = matrix[static_cast<std::size_t>(axis)][axis];
  if (a == 0.0 || !std::isfinite(a))
  {
    return std::nullopt;
  }
  QuadricForm scaled = form;
  const auto scale = [exponent = -std::ilogb(a)](double& of) { of = std::ldexp(of, exponent); };
  std::ranges::for_each(scaled.q, scale);
  for (int d = 0; d < 3; ++d)
  {
    scale(scaled.g[d]);
  }
  scale(scaled.c);
  return scaled;
}

/// Whether a b = c d, without rounding.
bool AreProductsEqual(double a, double b, double c, double d)
{
  const double first = a * b;
  const double second = c * d;
  return first == second && std::fma(a, b, -first) == std::fma(c, d, -second);
}

/// The vector n of a quadric, as InUnits returns it, whose function is
/// (n z)^2 / a + (g_k / a) (n z) + c, with its largest diagonal coefficient a = n_k; nothing where
/// the function depends on more than one direction.
std::optional<std::pair<Vec3, int>> OnlyDirectionOf(const QuadricForm& form)
{
  const auto rows = MatrixOf(form);
  const int axis = LargestDiagonal(rows);
  const Vec3& n = rows[static_cast<std::size_t>(axis)];
  const double a = n[axis];
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j <= i; ++j)
    {
      if (!AreProductsEqual(rows[static_cast<std::size_t>(i)][j], a, n[i], n[j]))
      {
        return std::nullopt;
      }
    }
    if (!AreProductsEqual(form.g[i], a, form.g[axis], n[i]))
    {
      return std::nullopt;
    }
  }
  return std::pair(n, axis);
}

/// A quadric, or the parallel planes that it consists of where its function depends on one
/// direction n alone: two, or one where they coincide, at the equation's roots rounded to doubles,
/// with gradients of the quadric's sense; none where there is no root. The subdivision cannot
/// separate two planes in boxes that are wider than their distance.
std::vector<QuadricForm> PartsOf(const QuadricForm& given)
{
  const std::optional<QuadricForm> inUnits = InUnits(given);
  if (!inUnits)
  {
    return { given };
  }
  const QuadricForm& form = *inUnits;
  const auto direction = OnlyDirectionOf(form);
  if (!direction)
  {
    return { form };
  }
  // s = n z is a root of s^2 + g_k s + a c.
  const auto& [n, axis] = *direction;
  const double a = n[axis];
  const auto half = -static_cast<long double>(form.g[axis]) / 2.0L;
  const auto product = static_cast<long double>(form.c) * a;
  const long double square = half * half - product;
  if (!(square >= 0.0L))
  {
    const long double rounding =
      4.0L * std::numeric_limits<long double>::epsilon() * (half * half + std::abs(product));
    return square < -rounding ? std::vector<QuadricForm>() : std::vector<QuadricForm>{ form };
  }
  // The root of larger magnitude first: the other one does not cancel.
  const long double outer = half + (half < 0.0L ? -1.0L : 1.0L) * std::sqrt(square);
  const long double inner = outer != 0.0L ? product / outer : 0.0L;
  std::vector<QuadricForm> planes;
  for (const long double root : { outer, inner })
  {
    if (planes.empty() || square > 0.0L)
    {
      const double sense = static_cast<double>(root - half) * a < 0.0 ? -1.0 : 1.0;
      QuadricForm plane;
      plane.origin = form.origin;
      plane.g = sense * n;
      plane.c = -sense * static_cast<double>(root);
      planes.push_back(plane);
    }
  }
  return planes;
}

/// A face of a convex body: a plane within the others.
std::vector<IntegralPiece> FacesOfBody(const std::vector<QuadricForm>& planes)
{
  std::vector<IntegralPiece> faces;
  for (std::size_t k = 0; k < planes.size(); ++k)
  {
    IntegralPiece face{ std::make_shared<QuadricSurface>(planes[k]), planes, std::nullopt };
    face.clips.erase(face.clips.begin() + static_cast<std::ptrdiff_t>(k));
    faces.push_back(std::move(face));
  }
  return faces;
}
} // namespace

std::vector<IntegralPiece> PiecesOf(vtkImplicitFunction* function)
{
  if (auto* torus = vtkImplicitTorus::SafeDownCast(function))
  {
    if (torus->GetTransform() != nullptr)
    {
      throw Unsupported("a vtkImplicitTorus with a transform is not integrated over; give it its "
                        "centre, axis and radii instead.");
    }
    const double* const c = torus->GetCenter();
    const double* const a = torus->GetAxis();
    return { { std::make_shared<TorusSurface>(Vec3(c[0], c[1], c[2]), Vec3(a[0], a[1], a[2]),
                 torus->GetRadius(), torus->GetTubeRadius()),
      {}, std::nullopt } };
  }
  if (const auto planes = PlanesOf(function); !planes.empty())
  {
    return FacesOfBody(planes);
  }
  if (const auto form = FormOf(function))
  {
    std::vector<IntegralPiece> pieces;
    for (const QuadricForm& part : PartsOf(*form))
    {
      pieces.push_back({ std::make_shared<QuadricSurface>(part), {}, std::nullopt });
    }
    return pieces;
  }
  throw Unsupported(std::string(function->GetClassName()) +
    ": integrals are taken over planes, spheres, cylinders, cones of two halves, quadrics, "
    "vtkImplicitTorus, vtkBox, vtkPlanes, iso-surfaces and the boundary.");
}

std::vector<QuadricForm> ClipsOf(vtkImplicitFunction* function)
{
  if (auto planes = PlanesOf(function); !planes.empty())
  {
    return planes;
  }
  if (const auto form = FormOf(function))
  {
    return { *form };
  }
  throw Unsupported(std::string(function->GetClassName()) +
    ": integrals are clipped by planes, spheres, cylinders, cones of two halves, quadrics, vtkBox "
    "and vtkPlanes.");
}

std::optional<IntegralPiece> TrianglePiece(const std::array<Vec3, 3>& triangle)
{
  const auto& [a, b, c] = triangle;
  const Vec3 normal = glm::cross(b - a, c - a);
  if (!(glm::length(normal) > 0.0))
  {
    return std::nullopt;
  }
  QuadricForm plane;
  plane.origin = a;
  plane.g = normal;
  IntegralPiece piece{ std::make_shared<QuadricSurface>(plane), {}, std::nullopt };
  for (std::size_t k = 0; k < 3; ++k)
  {
    QuadricForm side;
    side.origin = triangle[k];
    side.g = glm::cross(triangle[(k + 1) % 3] - triangle[k], normal);
    piece.clips.push_back(side);
  }
  piece.within = Box3{ glm::min(glm::min(a, b), c), glm::max(glm::max(a, b), c) };
  return piece;
}

SurfaceIntegral IntegratePieces(const IntegralQuestion& question,
  std::span<const IntegralPiece> pieces, std::span<const QuadricForm> clips,
  const HighOrderModel& model, const IntegralEffort& effort)
{
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  SurfaceIntegral sum;
  sum.met = true;
  sum.sums.resize(question.Quantities());
  sum.magnitudes.resize(question.Quantities());
  std::size_t left = pieces.size();
  for (const IntegralPiece& piece : pieces)
  {
    std::vector<QuadricForm> all = piece.clips;
    std::ranges::copy(clips, std::back_inserter(all));
    const IntegralQuestion part{ question.mesh, question.field, piece.cut.get(), all,
      piece.within };
    IntegralEffort share = effort;
    // What others leave of their time is for those that come behind.
    const std::chrono::duration<double> spent = Clock::now() - start;
    share.seconds = std::max(1e-3, (effort.seconds - spent.count()) / static_cast<double>(left--));
    AddTo(sum, IntegrateCut(part, model.GetLocator(), model.Faces(), share));
  }
  return sum;
}
} // namespace pixelexact
