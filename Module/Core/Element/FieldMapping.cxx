// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Element/FieldMapping.h"

#include "Core/Element/Dual.h"
#include "Core/Element/MappingKernels.h"
#include "Core/Element/Transform.h"
#include "Core/Math/Mat.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <vector>

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
template <template <class, class, bool> class Modes>
void HessianOf(const Space& space, const double* coefficients, const Vec3& xi,
  std::span<Hessian::value_type> out)
{
  using namespace HWY_NAMESPACE;
  const Modes<Dual, AnyOrder, true> modes(space,
    Point<Dual>{ { Dual::Variable(xi.x, 0), Dual::Variable(xi.y, 1), Dual::Variable(xi.z, 2) } });
  for (auto& component : out)
  {
    const auto e = modes.Evaluate(coefficients);
    coefficients += space.Modes();
    for (std::size_t j = 0; j < 3; ++j)
    {
      const auto& row = e.gradient[j].derivative;
      component[j] = { row[0], row[1], row[2] };
    }
  }
}

/// The map's derivatives at one point, in world units.
class MapAt
{
public:
  MapAt(const Mesh& mesh, int element, const Mat3& jacobian, const Vec3& xi)
    : J(jacobian * mesh.size[element])
    , Inverse(glm::inverse(jacobian) * (1.0 / mesh.size[element]))
    , InverseD(1.0 / glm::determinant(jacobian))
  {
    SecondDerivatives(mesh.map.SpaceOf(element), mesh.map.Coefficients(element), xi, H);
    // One factor after the other: the cube of a size may overflow where the quotient does not.
    for (int i = 0; i < 3; ++i)
    {
      InverseD /= mesh.size[element];
    }
    for (auto& component : H)
    {
      for (auto& row : component)
      {
        row *= mesh.size[element];
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
  double InverseD; ///< 1 / det J in world units
  Hessian H;
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

/// A tuple's gradient, from reference to world: u is its world value, F its reference value.
void MapGradient(
  const MapAt& map, Mapping mapping, int at, const Vec3& u, const Vec3& F, double* const* gradient)
{
  const Mat3 byXi =
    glm::transpose(Mat3(Tuple(gradient, at), Tuple(gradient + 3, at), Tuple(gradient + 6, at)));
  const auto rows = map.Gradient(mapping, u, F, byXi);
  for (int i = 0; i < 3; ++i)
  {
    Put(rows[i], gradient + 3 * i, at);
  }
}

/// Points that are mapped together, so that their Jacobians stay in cache.
constexpr int kTogether = 128;

void MapValues(const Mesh& mesh, int element, Mapping mapping, const LanePoints& xi, int components,
  double* const* value)
{
  const Space& space = mesh.map.SpaceOf(element);
  const KernelSet kernels = KernelsFor(space);
  std::array<std::array<double, kTogether>, 12> storage;
  std::array<double*, 12> map;
  std::ranges::transform(storage, map.begin(), [](auto& array) { return array.data(); });
  std::vector<double*> at(static_cast<std::size_t>(components));
  for (int begin = 0; begin < xi.count; begin += kTogether)
  {
    const LanePoints some{ { xi.x[0] + begin, xi.x[1] + begin, xi.x[2] + begin },
      std::min(kTogether, xi.count - begin) };
    kernels.gradient(space, mesh.map.Coefficients(element), 3, some, map.data(), map.data() + 3);
    std::transform(
      value, value + components, at.begin(), [begin](double* array) { return array + begin; });
    GetMappingKernels().toWorld(
      mapping, mesh.size[element], map.data() + 3, some.count, components, at.data());
  }
}

/// `reference` are the values before they were mapped, component by component.
void MapGradients(const Mesh& mesh, int element, Mapping mapping, const LanePoints& xi,
  int components, const std::vector<double>& reference, double* const* value,
  double* const* gradient)
{
  const auto jacobians = Jacobians(mesh, element, xi);
  const auto stride = static_cast<std::size_t>(xi.count);
  for (int i = 0; i < xi.count; ++i)
  {
    const MapAt map(mesh, element, jacobians[i], { xi.x[0][i], xi.x[1][i], xi.x[2][i] });
    if (mapping != Mapping::Density)
    {
      const double* F = &reference[static_cast<std::size_t>(i)];
      MapGradient(map, mapping, i, Tuple(value, i), Vec3(F[0], F[stride], F[2 * stride]), gradient);
      continue;
    }
    for (int c = 0; c < components; ++c)
    {
      double* const* byXi = gradient + 3 * c;
      Put(map.DensityGradient(value[c][i], Tuple(byXi, i)), byXi, i);
    }
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
  std::vector<double> reference;
  for (int c = 0; gradient && mapping != Mapping::Density && c < components; ++c)
  {
    reference.insert(reference.end(), value[c], value[c] + xi.count);
  }
  MapValues(mesh, element, mapping, xi, components, value);
  if (gradient)
  {
    MapGradients(mesh, element, mapping, xi, components, reference, value, gradient);
  }
}

void SecondDerivatives(const Space& space, const double* coefficients, const Vec3& xi,
  std::span<Hessian::value_type> out)
{
  using namespace HWY_NAMESPACE;
  switch (space.shape)
  {
    case Shape::Hexahedron:
      HessianOf<HexahedronModes>(space, coefficients, xi, out);
      return;
    case Shape::Prism:
      HessianOf<PrismModes>(space, coefficients, xi, out);
      return;
    case Shape::Tetrahedron:
      HessianOf<TetrahedronModes>(space, coefficients, xi, out);
      return;
    default:
      space.form == Form::Tensor ? HessianOf<TensorPyramidModes>(space, coefficients, xi, out)
                                 : HessianOf<PyramidModes>(space, coefficients, xi, out);
  }
}
} // namespace pixelexact
