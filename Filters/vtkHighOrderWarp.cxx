// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderWarp.h"

#include "Conversion/Displacement.h"
#include "Conversion/ModelSource.h"
#include "Conversion/WarpedGrid.h"
#include "Core/Base/Error.h"
#include "Core/Element/WarpLimit.h"

#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <limits>

vtkStandardNewMacro(vtkHighOrderWarp);

vtkHighOrderWarp::vtkHighOrderWarp()
  : MeshFilter(pixelexact::MeshScope::PartByBlock)
{
  this->vtkHighOrderWarp::ResetReport();
}

vtkHighOrderWarp::~vtkHighOrderWarp() = default;

void vtkHighOrderWarp::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FieldName: " << this->FieldName << "\n";
  os << indent << "ScaleFactor: " << this->ScaleFactor << "\n";
  os << indent << "Direction: " << this->Direction[0] << " " << this->Direction[1] << " "
     << this->Direction[2] << "\n";
  os << indent << "FindLimit: " << this->FindLimit << "\n";
  os << indent << "ValidScale: " << this->ValidScale << "\n";
  os << indent << "InvertedScale: " << this->InvertedScale << "\n";
  os << indent << "InvertedCell: " << this->InvertedCell << "\n";
  os << indent << "ElementsWithoutLimit: " << this->ElementsWithoutLimit << "\n";
}

void vtkHighOrderWarp::ResetReport()
{
  this->ValidScale = 0.0;
  this->InvertedScale = std::numeric_limits<double>::infinity();
  this->InvertedCell = -1;
  std::ranges::fill(this->InvertedPoint, std::numeric_limits<double>::quiet_NaN());
  this->ElementsWithoutLimit = 0;
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
  auto* const grid = vtkUnstructuredGrid::SafeDownCast(this->Input.GridOf(mesh));
  if (this->FindLimit)
  {
    model->RequireSolids("the limit of a warp");
    Displacement displacement = DisplacementOf(*model, grid, request);
    const double sign = this->ScaleFactor < 0.0 ? -1.0 : 1.0;
    for (WarpTerm& term : displacement.terms)
    {
      term.direction *= sign;
    }
    const WarpLimit limit = FindWarpLimit(model->GetMesh(), displacement.terms, {},
      [this](double done) { this->UpdateProgress(done); });
    this->ValidScale = sign * limit.positive;
    this->InvertedScale = sign * limit.inverted;
    this->InvertedCell = limit.element < 0
      ? -1
      : static_cast<vtkIdType>(model->SourceCells()[static_cast<std::size_t>(limit.element)]);
    for (int d = 0; d < 3; ++d)
    {
      this->InvertedPoint[d] = limit.xi[d];
    }
    this->ElementsWithoutLimit = static_cast<vtkIdType>(limit.leftOut.size());
  }
  const WarpedGrid warped = WarpGrid(grid, request);
  for (const std::string& name : warped.leftOut)
  {
    vtkWarningMacro(<< "field '" << name
                    << "' is left out: it is an H(curl), H(div) or density field, whose values "
                       "depend on the map.");
  }
  output->ShallowCopy(warped.grid);
  return true;
}
