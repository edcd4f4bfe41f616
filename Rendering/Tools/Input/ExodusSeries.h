// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input/ExodusName.h"
#include "Input/Input.h"

namespace pixelexact
{
/// Where a time step is: in which mesh of a series, and which of its own steps.
struct ExodusStep
{
  std::size_t mesh = 0;
  std::size_t own = 0;
};

/// The meshes that the files name, each once, in their order. Throws UsageError for files that are
/// no series, and no parts of one mesh.
std::vector<ExodusName> MeshesOf(const std::vector<std::string>& files);

/// Chooses among the steps of all meshes, and puts them into `input`. Throws Error for files that
/// are not there, or are no Exodus files.
ExodusStep ChooseStep(
  const std::vector<ExodusName>& meshes, const InputRequest& request, InputGrid& input);

/// Where the mesh that was named alone is followed by others.
void NoteOtherMeshes(const ExodusName& only, std::vector<std::string>& notes);
} // namespace pixelexact
