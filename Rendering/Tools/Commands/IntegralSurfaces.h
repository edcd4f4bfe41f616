// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Cuts/IntegralPieces.h"
#include "Scene/MeshSurfaceOptions.h"
#include "Scene/NumberedSurfaces.h"
#include "Scene/PlaneOption.h"

#include <vtkSmartPointer.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

class vtkImplicitFunction;

namespace CLI
{
class App;
} // namespace CLI

namespace pixelexact
{
/// A surface of integration.
struct IntegralSurface
{
  std::string name; ///< the option and its value
  std::vector<SurfacePatch> patches{};
  vtkSmartPointer<vtkImplicitFunction> function{}; ///< for VTK's filters; null: they have none
  std::optional<IsoText> iso{};
  bool boundary = false;
  std::vector<std::int32_t> attributes{}; ///< of the boundary's parts; none: all of it
};

/// The surfaces of `integrate`, in the order of their kinds in the help.
class IntegralSurfaces
{
public:
  void AddTo(CLI::App& command);

  /// The first given option for which VTK's filters have no surface; empty where there is none.
  [[nodiscard]] std::string NotLinear() const;
  /// Whether one of them is an iso-surface.
  [[nodiscard]] bool HasIsoSurfaces() const { return !Isos.empty(); }
  /// The functions that clip all surfaces.
  [[nodiscard]] std::vector<ImplicitPolynomial> Clips() const;
  /// Makes the surfaces in the mesh's box; without options the plane through the middle or, of a
  /// surface in space, the mesh. Throws UsageError when numbers describe no surface, Error for
  /// files that do not contain triangles, Unsupported where the mesh has no solids for them.
  [[nodiscard]] std::vector<IntegralSurface> Make(const HighOrderModel& model) const;

private:
  std::vector<PlaneChoice> Planes;
  std::map<std::string, std::vector<GivenNumbers>> Numbers; ///< by option
  std::vector<BoundaryChoice> Boundaries;
  std::vector<std::string> Files;
  std::vector<IsoText> Isos;
  std::vector<GivenNumbers> HalfSpaces;
};
} // namespace pixelexact
