// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "MeshSurfaces.h"
#include "PlaneOption.h"

#include <vtkSmartPointer.h>

#include <map>
#include <string>
#include <vector>

class vtkImplicitFunction;

namespace CLI
{
class App;
} // namespace CLI

namespace pixelexact
{
/// A surface that is integrated over.
struct IntegralSurface
{
  std::string name;                              ///< the option, and what it was given
  vtkSmartPointer<vtkImplicitFunction> function; ///< null: the boundary
  std::vector<std::int32_t> attributes;          ///< of the boundary's parts; none: all of it
};

/// The surfaces of `integrate`, in the order of their kinds in the help.
class IntegralSurfaces
{
public:
  void AddTo(CLI::App& command);

  [[nodiscard]] bool HasBoundaries() const { return !Boundaries.empty(); }
  /// Without any: the plane through the middle. Throws UsageError when numbers describe no surface.
  [[nodiscard]] std::vector<IntegralSurface> Make(const Box3& box) const;

private:
  std::vector<PlaneChoice> Planes;
  std::map<std::string, std::vector<std::vector<double>>> Numbers; ///< by option
  std::vector<BoundaryChoice> Boundaries;
};
} // namespace pixelexact
