// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderWarp.h"

#include "Conversion/ModelSource.h"
#include "Conversion/WarpedGrid.h"
#include "Core/Base/Error.h"

#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkHighOrderWarp);

vtkHighOrderWarp::vtkHighOrderWarp()
  : MeshFilter(pixelexact::MeshScope::PartByBlock)
{
}

vtkHighOrderWarp::~vtkHighOrderWarp() = default;

void vtkHighOrderWarp::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FieldName: " << this->FieldName << "\n";
  os << indent << "ScaleFactor: " << this->ScaleFactor << "\n";
  os << indent << "Direction: " << this->Direction[0] << " " << this->Direction[1] << " "
     << this->Direction[2] << "\n";
}

bool vtkHighOrderWarp::Make(vtkDataObject* mesh, vtkDataObject* output)
{
  using namespace pixelexact;
  const auto model = this->ModelOf(mesh);
  WarpRequest request{ ChosenName(this, this->FieldName), this->ScaleFactor, {} };
  if (request.field.empty())
  {
    throw InvalidData("there is no displacement; set FieldName.");
  }
  const Vec3 direction(this->Direction[0], this->Direction[1], this->Direction[2]);
  if (direction != Vec3(0.0))
  {
    request.direction = direction;
  }
  const WarpedGrid warped =
    WarpGrid(vtkUnstructuredGrid::SafeDownCast(this->Input.GridOf(mesh)), request);
  for (const std::string& name : warped.leftOut)
  {
    vtkWarningMacro(<< "field '" << name
                    << "' is left out: it is an H(curl), H(div) or density field, whose values "
                       "depend on the map.");
  }
  output->ShallowCopy(warped.grid);
  return true;
}
