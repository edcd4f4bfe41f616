// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderJumpWalls.h"

#include "Surfaces/MeshSurfaces.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkHighOrderJumpWalls);

//------------------------------------------------------------------------------
vtkHighOrderJumpWalls::vtkHighOrderJumpWalls() = default;

//------------------------------------------------------------------------------
vtkHighOrderJumpWalls::~vtkHighOrderJumpWalls() = default;

//------------------------------------------------------------------------------
std::shared_ptr<const pixelexact::Surface> vtkHighOrderJumpWalls::MakeSurface(
  const std::shared_ptr<const pixelexact::HighOrderModel>& model,
  const pixelexact::SurfaceSearch& /*search*/)
{
  return pixelexact::MakeJumpWalls(model, { this->FieldName, this->Component, this->Value });
}
