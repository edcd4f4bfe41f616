// SPDX-License-Identifier: BSD-3-Clause
#include "Input/BlockInput.h"
#include "Input/ExodusSeries.h"

#include "Files/ExodusGrid.h"

namespace pixelexact
{
InputGrid ReadExodusFile(const InputRequest& request)
{
  const std::vector<ExodusName> meshes = MeshesOf(request.files);
  InputGrid input;
  const ExodusStep step = ChooseStep(meshes, request, input);
  if (request.timesAlone)
  {
    return input;
  }
  input.grid =
    ReadExodusGrid(PartsOf(meshes[step.mesh]), step.own, request.surfaceElements, input.notes);
  if (meshes.size() == 1)
  {
    NoteOtherMeshes(meshes.front(), input.notes);
  }
  return input;
}
} // namespace pixelexact
