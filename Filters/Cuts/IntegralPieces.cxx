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
#include <string>

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
    return { { std::make_shared<QuadricSurface>(*form), {}, std::nullopt } };
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

std::optional<IntegralPiece> PieceOf(const std::array<Vec3, 3>& triangle)
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
