// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/SolverModel.h"

#include <string>
#include <vector>

// The files of a run of FLEXI: a mesh of HOPR and states.
namespace pixelexact::flexi
{
/// Whether a file is a mesh of HOPR or a state of FLEXI; false also for files that cannot be read.
bool IsFile(const std::string& path);

class Series
{
public:
  /// `files`: states, or a mesh and states of it, which are ordered by their times; or a mesh
  /// alone. Without a mesh among them, each state has the mesh that it names: beside it, or where
  /// it says. Throws InvalidData or Unsupported, with the file's name and the remedy.
  explicit Series(const std::vector<std::string>& files);

  /// Ascending; empty for a mesh alone.
  [[nodiscard]] const std::vector<double>& Times() const { return TimeOf; }
  /// The names of DG_Solution's variables in any state.
  [[nodiscard]] const std::vector<std::string>& FieldNames() const { return Names; }
  /// The first step with the mesh of this one.
  [[nodiscard]] int StepOfMesh(int step) const;

  /// Reads the fields of a step and, if `wantMesh`, its mesh.
  [[nodiscard]] SolverModel Read(int step, bool wantMesh) const;

private:
  struct State
  {
    std::string file;
    std::string mesh;
    double time = 0.0;
  };

  std::string OnlyMesh; ///< a mesh without states
  std::vector<State> States;
  std::vector<double> TimeOf;
  std::vector<std::string> Names;
};
} // namespace pixelexact::flexi
