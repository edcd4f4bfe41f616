// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/Space.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>

// Non-owning views of a mesh and its fields. Whoever owns the arrays (a vtkUnstructuredGrid) keeps
// them alive and unchanged while a view, or a Locator built on it, is in use.
namespace pixelexact
{
/// One polynomial function per element, each in its own space. Coefficients of element e:
/// `coefficients[offset[e] + c * modes + mode]`, component by component.
struct Expansion
{
  std::span<const Space> spaces;         ///< the distinct spaces
  std::span<const std::int32_t> spaceOf; ///< per element, index into spaces
  std::span<const std::int64_t> offset;  ///< per element
  std::span<const double> coefficients;
  int components = 1;

  [[nodiscard]] int Elements() const { return static_cast<int>(spaceOf.size()); }
  [[nodiscard]] const Space& SpaceOf(int element) const { return spaces[spaceOf[element]]; }
  [[nodiscard]] const double* Coefficients(int element) const
  {
    return coefficients.data() + offset[element];
  }
};

/// The geometry: Phi(xi) = centre + size (sum of coefficients times modes). Size is a power of two
/// of the element's extent, so scaling by it is exact and sizes from 1e-150 to 1e150 meet the same
/// arithmetic.
struct Mesh
{
  Expansion map;                  ///< three components, in units of the element
  std::span<const double> centre; ///< 3 per element
  std::span<const double> size;   ///< per element, a power of two
  /// Per element, world units: how far the true map may be from the stored one, by the rounding of
  /// the source's coordinates and by modes dropped as noise. Faces are as uncertain as this.
  std::span<const double> uncertainty;
  /// The mesh is a surface in space: each element stands for its ShellFace, and the solid beneath
  /// it is there for the kernels alone. Only points on that face are inside.
  bool isShell = false;

  [[nodiscard]] int Elements() const { return map.Elements(); }
  [[nodiscard]] Shape ShapeOf(int element) const { return map.SpaceOf(element).shape; }
};

/// The mapping of a field's reference values to world values.
enum class Mapping : std::uint8_t
{
  Identity = 0,      ///< u(x) = F(xi)
  Covariant = 1,     ///< H(curl): u = J^-T F, three components
  Contravariant = 2, ///< H(div): u = J F / det J, three components (Piola)
  Density = 3        ///< u = F / det J
};

class FieldFunction;

struct Field
{
  std::string name;
  Expansion values; ///< of F
  Mapping mapping = Mapping::Identity;
  /// The function that defines the field, if not null: a function without coefficients. `values`
  /// then has a number of components alone.
  std::shared_ptr<const FieldFunction> function{};
};

/// Throws Unsupported where the field is a function without coefficients: `what` is not available
/// for it. "Contour lines as polylines", "integrals".
void RequirePolynomials(const Field& field, const std::string& what);

/// Checks that an expansion's arrays agree: spaces valid, indices and offsets within bounds,
/// components >= 1. Throws InvalidData naming `what` and the element.
void Validate(const Expansion& expansion, const std::string& what);
/// The same for a mesh; also checks that centres, sizes and coefficients are finite and sizes
/// positive.
void Validate(const Mesh& mesh);
/// The same for a field on a mesh; also checks that shapes and number of elements agree and that
/// the mapping suits the components. Coefficients may be NaN or infinite: these are the solver's
/// data, and are shown as such.
void Validate(const Field& field, const Mesh& mesh);
} // namespace pixelexact
