// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Options.h"
#include "Scene/MeshSurfaceOptions.h"
#include "Scene/PlaneOption.h"

#include "Trace/Surfaces/Surface.h"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace pixelexact
{
/// Supplies a cut-surface: an existing one, or one created from a model's mesh. Throws Error, which
/// names the option.
using GivenSurface =
  std::function<std::shared_ptr<const Surface>(const std::shared_ptr<const HighOrderModel>& model)>;

/// The cut-surfaces of the command line, in the order of their kinds in the help.
class SurfaceOptions
{
public:
  void AddTo(CLI::App& command);

  /// Before all others.
  void AddFirst(const PlaneChoice& plane) { Planes.insert(Planes.begin(), plane); }

  /// Whether there are any; else a plane is chosen.
  [[nodiscard]] bool AreGiven() const { return CountGiven() > 0; }
  /// The number of surfaces.
  [[nodiscard]] std::size_t Count() const { return AreGiven() ? CountGiven() : 1; }

  /// Creates surfaces that need no mesh, and reads files. Throws UsageError when a number describes
  /// no surface, Error for a file that cannot be read.
  [[nodiscard]] std::vector<GivenSurface> Make() const;

  /// The same without surfaces that consist of the mesh's elements.
  [[nodiscard]] std::vector<GivenSurface> MakeInSpace() const;

  /// The number of walls of iso-surfaces, which are the last surfaces.
  [[nodiscard]] std::size_t CountWalls() const { return Walls ? Isos.size() : 0; }

  /// Whether the faces between elements are a surface.
  [[nodiscard]] bool HasInnerFaces() const { return InnerFaces; }

  [[nodiscard]] const std::vector<IsoText>& IsoSurfaces() const { return Isos; }
  [[nodiscard]] const std::vector<std::string>& PatchFiles() const { return Patches; }
  [[nodiscard]] const std::vector<BoundaryChoice>& BoundaryChoices() const { return Boundaries; }

  /// An option and its numbers.
  struct Described
  {
    std::string option;
    std::vector<double> numbers;
  };
  /// The first surface, where numbers describe it and it is no plane; empty otherwise.
  [[nodiscard]] Described First() const;

  /// The fields whose values define surfaces, as they were named (IsoText::name).
  [[nodiscard]] std::vector<std::string> Fields() const;

private:
  [[nodiscard]] std::size_t CountGiven() const;

  std::vector<PlaneChoice> Planes;
  std::map<std::string, std::vector<std::vector<double>>> Numbers; ///< by option
  std::vector<std::string> Files;                                  ///< of triangles
  std::vector<std::string> Patches;                                ///< files of patches
  std::vector<IsoText> Isos;
  std::vector<BoundaryChoice> Boundaries;
  bool InnerFaces = false; ///< those between elements
  bool Walls = false;      ///< of the iso-surfaces, where fields jump
};
} // namespace pixelexact
