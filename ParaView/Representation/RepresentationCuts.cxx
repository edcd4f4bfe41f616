// SPDX-License-Identifier: BSD-3-Clause
// Slices and clips that PixelExact Slice and PixelExact Clip describe in the data.
#include "RepresentationInternals.h"

#include "CutDescription.h"

#include "vtkImplicitBoolean.h"
#include "vtkImplicitFunctionCollection.h"

#include <vector>

namespace
{
using pixelexact::DescribedCut;

/// The boolean of some functions; null without any.
vtkSmartPointer<vtkImplicitFunction> Joined(
  const std::vector<DescribedCut>& clips, bool inverted, int operation)
{
  auto joined = vtkSmartPointer<vtkImplicitBoolean>::New();
  joined->SetOperationType(operation);
  for (const DescribedCut& clip : clips)
  {
    if (clip.inverted == inverted)
    {
      joined->AddFunction(clip.function);
    }
  }
  return joined->GetFunction()->GetNumberOfItems() > 0 ? joined : nullptr;
}

/// A function whose zeros are the rim of what all clips keep.
vtkSmartPointer<vtkImplicitFunction> RimOf(const std::vector<DescribedCut>& clips)
{
  if (clips.size() == 1)
  {
    return clips.front().function;
  }
  const auto within = Joined(clips, false, vtkImplicitBoolean::VTK_INTERSECTION);
  const auto outside = Joined(clips, true, vtkImplicitBoolean::VTK_UNION);
  if (within == nullptr || outside == nullptr)
  {
    return within != nullptr ? within : outside;
  }
  auto rim = vtkSmartPointer<vtkImplicitBoolean>::New();
  rim->SetOperationTypeToDifference();
  rim->AddFunction(within);
  rim->AddFunction(outside);
  return rim;
}
} // namespace

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::ChooseSliceOrClip(vtkDataObject* delivered)
{
  Internals& my = *this->Data;
  if (my.Described == delivered && my.DescribedTime == delivered->GetMTime())
  {
    my.Actor->SetVisibility(my.Actor->GetVisibility() && !my.LacksDescription);
    return;
  }
  my.Described = delivered;
  my.DescribedTime = delivered->GetMTime();
  const auto slices = pixelexact::CutsOf(delivered, pixelexact::kSlices);
  const auto clips = pixelexact::CutsOf(delivered, pixelexact::kClips);
  my.Clipped->RemoveAllCutFunctions();
  my.Clipped->RemoveAllClipFunctions();
  for (const DescribedCut& clip : clips)
  {
    my.Clipped->AddClipFunction(clip.function, clip.inverted);
  }
  my.Mapper->SetCutFunction(nullptr);
  my.Mapper->SetSurface(nullptr);
  if (clips.empty())
  {
    for (const DescribedCut& slice : slices)
    {
      my.Mapper->AddCutFunction(slice.function);
    }
  }
  else
  {
    my.Clipped->SetSurface(slices.empty() ? my.Boundary.Get() : nullptr);
    for (const DescribedCut& slice : slices)
    {
      my.Clipped->AddCutFunction(slice.function);
    }
    my.Mapper->SetSurface(my.Clipped);
    if (slices.empty())
    {
      my.Mapper->AddCutFunction(RimOf(clips));
    }
  }
  const bool lacks = slices.empty() && clips.empty();
  if (lacks && !my.LacksDescription)
  {
    vtkErrorMacro(<< "the data have no slice and no clip; apply PixelExact Slice or PixelExact "
                     "Clip, or choose another Surface");
  }
  my.LacksDescription = lacks;
  my.Actor->SetVisibility(my.Actor->GetVisibility() && !lacks);
}
