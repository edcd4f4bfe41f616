// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Curved/FaceNormal.h"

#include "Core/Element/Kernels.h"
#include "Core/Questions/Questions.h"
#include "Trace/Surfaces/Arguments.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>

namespace pixelexact
{
Vec3 FaceNormal(const Mesh& mesh, const CurvedPart& part, const Vec3& xi)
{
  constexpr auto kLanes = static_cast<std::size_t>(kLanePadding);
  std::array<std::array<double, kLanes>, 3> at;
  std::array<std::array<double, kLanes>, 12> out;
  for (std::size_t d = 0; d < 3; ++d)
  {
    at[d].fill(xi[static_cast<int>(d)]);
  }
  double* const value[3] = { out[0].data(), out[1].data(), out[2].data() };
  double* gradient[9];
  for (std::size_t k = 0; k < 9; ++k)
  {
    gradient[k] = out[3 + k].data();
  }
  const Space& space = mesh.map.SpaceOf(part.element);
  KernelsFor(space).gradient(space, mesh.map.Coefficients(part.element), 3,
    { { at[0].data(), at[1].data(), at[2].data() }, 1 }, value, gradient);
  const Shape shape = mesh.ShapeOf(part.element);
  const ShapeFace& face = FacesOf(shape)[static_cast<std::size_t>(part.face)];
  EtaBox end;
  (face.upper ? end.lower : end.upper)[face.direction] = face.upper ? 1.0 : -1.0;
  const auto normals = EndNormals(shape, end);
  const double* n = normals[static_cast<std::size_t>(2 * face.direction + (face.upper ? 1 : 0))];
  // The cofactors of J take normals in xi to normals in space.
  Vec3 normal(0.0);
  for (std::size_t c = 0; c < 3; ++c)
  {
    const std::size_t p = (c + 1) % 3;
    const std::size_t q = (c + 2) % 3;
    for (std::size_t d = 0; d < 3; ++d)
    {
      const std::size_t e = (d + 1) % 3;
      const std::size_t f = (d + 2) % 3;
      normal[static_cast<int>(c)] += n[d] *
        (out[3 + 3 * p + e][0] * out[3 + 3 * q + f][0] -
          out[3 + 3 * p + f][0] * out[3 + 3 * q + e][0]);
    }
  }
  const double size = LargestOf(normal);
  return size > 0.0 && std::isfinite(size) ? UnitDirection(normal / size) : Vec3(0.0);
}
} // namespace pixelexact
