// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPixelExactSlice.h"

#include "CutDescription.h"

#include "Core/Base/Error.h"

#include "vtkImplicitFunction.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPlane.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

vtkStandardNewMacro(vtkPixelExactSlice);

namespace
{
/// The plane moved by `offset` along its normal.
vtkSmartPointer<vtkImplicitFunction> Moved(vtkPlane* plane, double offset)
{
  double origin[3];
  double normal[3];
  plane->GetOrigin(origin);
  plane->EvaluateGradient(origin, normal);
  const double length = vtkMath::Norm(normal);
  if (!(length > 0.0))
  {
    throw pixelexact::InvalidData("the normal of the plane is zero; give it a direction.");
  }
  // ParaView's plane has an offset of its own, which only its value contains.
  const double step = (offset - plane->EvaluateFunction(origin) / length) / length;
  auto moved = vtkSmartPointer<vtkPlane>::New();
  moved->SetOrigin(
    origin[0] + step * normal[0], origin[1] + step * normal[1], origin[2] + step * normal[2]);
  moved->SetNormal(normal);
  moved->SetTransform(plane->GetTransform());
  return moved;
}
} // namespace

//------------------------------------------------------------------------------
vtkPixelExactSlice::vtkPixelExactSlice() = default;

//------------------------------------------------------------------------------
vtkPixelExactSlice::~vtkPixelExactSlice() = default;

//------------------------------------------------------------------------------
void vtkPixelExactSlice::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Offsets: " << this->Offsets.size() << "\n";
}

//------------------------------------------------------------------------------
void vtkPixelExactSlice::SetNumberOfOffsets(int number)
{
  this->Offsets.resize(static_cast<std::size_t>(std::max(0, number)), 0.0);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPixelExactSlice::SetOffset(int index, double offset)
{
  if (index >= 0 && index < static_cast<int>(this->Offsets.size()))
  {
    this->Offsets[static_cast<std::size_t>(index)] = offset;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkPixelExactSlice::Describe(vtkImplicitFunction* function, vtkUnstructuredGrid* grid)
{
  std::vector<pixelexact::DescribedCut> cuts;
  auto* const plane = vtkPlane::SafeDownCast(function);
  for (const double offset : this->Offsets)
  {
    if (offset != 0.0 && plane == nullptr)
    {
      throw pixelexact::InvalidData(
        "Slice Offset Values move planes; choose the Slice Type Plane, or remove all but 0.");
    }
    if (offset != 0.0)
    {
      cuts.push_back({ Moved(plane, offset) });
    }
  }
  // The plane itself, unmoved, is the cut that the representation would make.
  if (cuts.size() < this->Offsets.size() || cuts.empty())
  {
    cuts.push_back({ function });
  }
  pixelexact::RemoveCuts(grid, pixelexact::kSlices);
  pixelexact::AddCuts(grid, pixelexact::kSlices, cuts);
}
