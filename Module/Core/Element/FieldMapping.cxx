// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Element/FieldMapping.h"

#include "Core/Element/SecondDerivatives.h"
#include "Core/Element/Transform.h"

#include <glm/matrix.hpp>

// With H_ijk = d^2 x_i / d xi_j d xi_k, D = det J and t_k = (d D / d xi_k) / D = (J^-1)_ja H_ajk:
//
//   Contravariant  u = J F / D      du_i / dxi_k = (H_ijk F_j + J_ij dF_j/dxi_k) / D - u_i t_k
//   Covariant      J^T u = F        J^T du / dxi_k = dF / dxi_k - H_a.k u_a
//   Density        u = F / D        du / dxi_k = (dF / dxi_k) / D - u t_k
//
// and du / dx = (du / dxi) J^-1. See Rognes, Kirby and Logg, "Efficient assembly of H(div) and
// H(curl) conforming finite elements", SIAM J. Sci. Comput. 31 (2009), section 2.
namespace pixelexact
{
namespace
{
/// The map's derivatives at one point, in world units.
class MapAt
{
public:
  MapAt(const Mesh& mesh, int element, const Mat3& jacobian, const Vec3& xi)
    : J(jacobian * mesh.size[element])
    , Inverse(glm::inverse(jacobian) * (1.0 / mesh.size[element]))
    , D(glm::determinant(jacobian))
    , TheMesh(mesh)
    , Element(element)
    , Xi(xi)
  {
    // One factor after the other: the cube of a size may overflow where the quotient does not.
    for (int i = 0; i < 3; ++i)
    {
      InverseD = (i == 0 ? 1.0 / D : InverseD) / mesh.size[element];
    }
  }

  /// World value of one tuple.
  [[nodiscard]] Vec3 Value(Mapping mapping, const Vec3& F) const
  {
    return mapping == Mapping::Covariant ? glm::transpose(Inverse) * F : (J * F) * InverseD;
  }
  [[nodiscard]] double Density(double F) const { return F * InverseD; }

  void LoadSecondDerivatives()
  {
    H = SecondDerivatives(TheMesh.map.SpaceOf(Element), TheMesh.map.Coefficients(Element), Xi);
    LogD = Vec3(0.0);
    for (auto& component : H)
    {
      for (auto& row : component)
      {
        row *= TheMesh.size[Element];
      }
    }
    for (int a = 0; a < 3; ++a)
    {
      for (int j = 0; j < 3; ++j)
      {
        LogD += Inverse[a][j] * H[a][j];
      }
    }
  }

  /// d u_i / d x as row i, from u, F and the columns dF / dxi_k.
  [[nodiscard]] std::array<Vec3, 3> Gradient(
    Mapping mapping, const Vec3& u, const Vec3& F, const Mat3& byXi) const
  {
    Mat3 du; // column k: d u / d xi_k
    for (int k = 0; k < 3; ++k)
    {
      Vec3 bent(0.0);
      for (int a = 0; a < 3; ++a)
      {
        for (int j = 0; j < 3; ++j)
        {
          bent[mapping == Mapping::Covariant ? j : a] +=
            H[a][j][k] * (mapping == Mapping::Covariant ? u[a] : F[j]);
        }
      }
      du[k] = mapping == Mapping::Covariant ? glm::transpose(Inverse) * (byXi[k] - bent)
                                            : (bent + J * byXi[k]) * InverseD - u * LogD[k];
    }
    const Mat3 world = du * Inverse;
    return { glm::transpose(world)[0], glm::transpose(world)[1], glm::transpose(world)[2] };
  }
  [[nodiscard]] Vec3 DensityGradient(double u, const Vec3& byXi) const
  {
    return (byXi * InverseD - u * LogD) * Inverse;
  }

private:
  Mat3 J;
  Mat3 Inverse;
  double D;
  double InverseD = 0.0; ///< 1 / det J in world units
  const Mesh& TheMesh;
  int Element;
  Vec3 Xi;
  Hessian H{};
  Vec3 LogD{ 0.0 }; ///< the gradient of log |det J| by xi
};

Vec3 Tuple(double* const* arrays, int at)
{
  return { arrays[0][at], arrays[1][at], arrays[2][at] };
}

void Put(const Vec3& tuple, double* const* arrays, int at)
{
  for (int d = 0; d < 3; ++d)
  {
    arrays[d][at] = tuple[d];
  }
}

void MapVector(MapAt& map, Mapping mapping, int at, double* const* value, double* const* gradient)
{
  const Vec3 F = Tuple(value, at);
  const Vec3 u = map.Value(mapping, F);
  Put(u, value, at);
  if (!gradient)
  {
    return;
  }
  const Mat3 byXi =
    glm::transpose(Mat3(Tuple(gradient, at), Tuple(gradient + 3, at), Tuple(gradient + 6, at)));
  const auto rows = map.Gradient(mapping, u, F, byXi);
  for (int i = 0; i < 3; ++i)
  {
    Put(rows[i], gradient + 3 * i, at);
  }
}

void MapDensity(MapAt& map, int at, double* value, double* const* gradient)
{
  value[at] = map.Density(value[at]);
  if (gradient)
  {
    Put(map.DensityGradient(value[at], Tuple(gradient, at)), gradient, at);
  }
}
} // namespace

void ApplyMapping(const Mesh& mesh, int element, Mapping mapping, const LanePoints& xi,
  int components, double* const* value, double* const* gradient)
{
  if (mapping == Mapping::Identity)
  {
    if (gradient)
    {
      ToWorldGradient(mesh, element, xi, components, gradient);
    }
    return;
  }
  const auto jacobians = Jacobians(mesh, element, xi);
  for (int i = 0; i < xi.count; ++i)
  {
    MapAt map(mesh, element, jacobians[i], { xi.x[0][i], xi.x[1][i], xi.x[2][i] });
    if (gradient)
    {
      map.LoadSecondDerivatives();
    }
    if (mapping != Mapping::Density)
    {
      MapVector(map, mapping, i, value, gradient);
      continue;
    }
    for (int c = 0; c < components; ++c)
    {
      MapDensity(map, i, value[c], gradient ? gradient + 3 * c : nullptr);
    }
  }
}
} // namespace pixelexact
