// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input/ExodusName.h"
#include "Input/Input.h"

namespace pixelexact
{
/// The mesh and the step in it of a time step in a series of meshes.
struct ExodusStep
{
  std::size_t mesh = 0;
  std::size_t own = 0;
};

/// The meshes that the files name, each once, in their order. Throws UsageError for files that are
/// no series, and no parts of one mesh.
std::vector<ExodusName> MeshesOf(const std::vector<std::string>& files);

/// Chooses among the steps of all meshes and stores them in `input`. Throws Error for files that do
/// not exist or are not Exodus files.
ExodusStep ChooseStep(
  const std::vector<ExodusName>& meshes, const InputRequest& request, InputGrid& input);

/// Adds a note where further meshes follow a mesh that was named alone.
void NoteOtherMeshes(const ExodusName& only, std::vector<std::string>& notes);
} // namespace pixelexact
