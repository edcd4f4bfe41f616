// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPixelExactRepresentation.h"

#include "HighOrderModel.h"
#include "MessageWords.h"
#include "RepresentationInternals.h"

#include "Core/Base/Error.h"

#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkHighOrderGrid.h"
#include "vtkImplicitFunction.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkPixelExactRepresentation);

//------------------------------------------------------------------------------
vtkPixelExactRepresentation::Internals::Internals(vtkPixelExactRepresentation* self)
  : Notes([self](int x, int y) { return self->TextAt(x, y); })
{
}

//------------------------------------------------------------------------------
vtkPixelExactRepresentation::vtkPixelExactRepresentation()
  : Data(std::make_unique<Internals>(this))
{
  this->Data->Actor->SetMapper(this->Data->Mapper);
  this->Data->Mapper->SetUseLookupTableScalarRange(1);
  this->Data->Mapper->ScalarVisibilityOff();
  this->Data->WallLayer->SetSurface(this->Data->Walls);
  this->Data->WallLayer->ScalarVisibilityOff();
  this->Data->WallLayer->ContourVisibilityOff(); // which are not proven there
  vtkMath::UninitializeBounds(this->Data->Bounds.data());
}

//------------------------------------------------------------------------------
vtkPixelExactRepresentation::~vtkPixelExactRepresentation() = default;

//------------------------------------------------------------------------------
int vtkPixelExactRepresentation::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  // Clients and render servers have none.
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkPixelExactRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  Internals& my = *this->Data;
  my.Shown = nullptr;
  vtkMath::UninitializeBounds(my.Bounds.data());
  if (inputVector[0]->GetNumberOfInformationObjects() == 1)
  {
    vtkDataObject* data = vtkDataObject::GetData(inputVector[0], 0);
    try
    {
      my.Shown = my.WithCoefficients(data);
      my.NumberSelectedCells(data);
      if (Internals::HasCells(my.Shown))
      {
        // Held until the mapper has it.
        const auto model = pixelexact::HighOrderModel::From(my.Shown);
        my.Mapper->SetInputData(my.Shown);
        my.Mapper->GetBounds(my.Bounds.data());
      }
    }
    catch (const pixelexact::Error& error)
    {
      my.Shown = nullptr;
      vtkErrorMacro(<< pixelexact::Worded(error.what()));
    }
    this->AskOthers();
  }
  return this->Superclass::RequestData(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkPixelExactRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0;
  }
  Internals& my = *this->Data;
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    vtkPVView::SetPiece(inInfo, this, my.Shown);
    vtkNew<vtkMatrix4x4> matrix;
    my.Actor->GetMatrix(matrix);
    vtkPVRenderView::SetGeometryBounds(inInfo, this, my.Bounds.data(), matrix);
    // Moved grids are appended, after which their coefficients are stale.
    vtkPVRenderView::SetRequiresDistributedRendering(inInfo, this, true);
    vtkPVRenderView::SetOrderedCompositingConfiguration(
      inInfo, this, vtkPVRenderView::USE_BOUNDS_FOR_REDISTRIBUTION);
    outInfo->Set(vtkPVRenderView::NEED_ORDERED_COMPOSITING(),
      my.Mapper->HasTranslucentPolygonalGeometry() || my.Actor->GetProperty()->GetOpacity() < 1.0
        ? 1
        : 0);
  }
  else if (request == vtkPVView::REQUEST_UPDATE_LOD())
  {
    vtkPVRenderView::SetRequiresDistributedRenderingLOD(inInfo, this, true);
  }
  else if (request == vtkPVView::REQUEST_RENDER())
  {
    vtkDataObject* delivered = vtkPVView::GetDeliveredPiece(inInfo, this);
    const bool isThere = Internals::HasCells(delivered);
    my.Actor->SetVisibility(this->GetVisibility() && isThere);
    my.Notes.Watch(vtkPVRenderView::SafeDownCast(this->GetView()));
    if (isThere)
    {
      my.Mapper->SetInputData(delivered);
      my.Mapper->SetScalarVisibility(!my.ColorArray.empty() && !my.HasOtherColors(delivered));
      my.Delivered = delivered;
      this->ChooseSurface(delivered);
      my.Notes.SetInterpolated(my.ShowsInterpolated());
    }
    if (isThere || Internals::HasSeveralProcesses())
    {
      this->Warn(isThere ? delivered : nullptr);
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::ChooseSurface(vtkDataObject* delivered)
{
  Internals& my = *this->Data;
  this->ChooseWalls();
  if (my.Surface != SLICE_OR_CLIP)
  {
    my.Described = nullptr;
  }
  switch (my.Surface)
  {
    case BOUNDARY:
      my.Mapper->SetSurface(my.Boundary);
      break;
    case ISO_SURFACE:
      my.Mapper->SetSurface(my.Iso);
      break;
    case SURFACE_OF_FILE:
      this->ReadSurfaceFile();
      my.Mapper->SetCutFunction(nullptr);
      my.Mapper->SetSurface(my.OfFile);
      my.Actor->SetVisibility(my.Actor->GetVisibility() && my.OfFile != nullptr);
      break;
    case SLICE_OR_CLIP:
      this->ChooseSliceOrClip(delivered);
      break;
    default:
      // A mesh without a volume has nothing else to show.
      if (vtkHighOrderGrid::IsSurfaceInSpace(delivered))
      {
        my.Mapper->SetSurface(my.Boundary);
        break;
      }
      my.Mapper->SetSurface(nullptr);
      my.Mapper->SetCutFunction(my.Cut);
      break;
  }
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::ChooseWalls()
{
  Internals& my = *this->Data;
  const bool shown = my.HasWalls && my.Surface == ISO_SURFACE && !Internals::HasSeveralProcesses();
  my.Iso->SetMayBeEmpty(shown);
  if (!shown)
  {
    my.Mapper->RemoveAllLayers();
  }
  else if (my.Mapper->GetNumberOfLayers() == 0)
  {
    my.Mapper->AddLayer(my.WallLayer);
  }
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::ReadSurfaceFile()
{
  Internals& my = *this->Data;
  if (my.OfFile != nullptr)
  {
    return;
  }
  try
  {
    my.OfFile = pixelexact::SurfaceOfFile(my.SurfaceFile);
    my.FailedFile.reset();
  }
  catch (const pixelexact::Error& error)
  {
    if (my.FailedFile != my.SurfaceFile)
    {
      my.FailedFile = my.SurfaceFile;
      vtkErrorMacro(<< pixelexact::Worded(error.what()));
    }
  }
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::Warn(vtkDataObject* shown)
{
  Internals& my = *this->Data;
  std::set<std::string> texts;
  if (my.Mapper->GetScalarVisibility() && my.Mapper->GetLookupTable() != nullptr)
  {
    auto* processes = vtkMultiProcessController::GetGlobalController();
    std::string complaint = my.Range.Complaint(shown, my.ColorArray, my.Mapper->GetLookupTable(),
      Internals::HasSeveralProcesses() ? processes : nullptr);
    if (!complaint.empty() && my.ShowsInterpolated())
    {
      complaint += "; a filter computed the array at the cells' points, and between them it is "
                   "interpolated, not the formula: PixelExact Calculator evaluates formulas at "
                   "every pixel";
    }
    texts.insert(complaint);
  }
  if (shown != nullptr && my.HasOtherColors(shown))
  {
    texts.insert("the " + std::string(my.ColorsCells ? "cell" : "point") + " array '" +
      my.ColorArray + "' is not the field of that name, which " +
      (my.ColorsCells ? "point" : "cell") +
      " data show: colour by that array, or give the result of a filter another name");
  }
  if (my.HasBlockColors || my.HasBlockOpacities ||
    std::ranges::any_of(my.Selectors, [](const auto& s) { return s != "/"; }))
  {
    texts.insert("blocks are not chosen, coloured or made translucent one by one: all are one "
                 "scene; the filter Extract Block takes out those to be seen");
  }
  if (my.HasWalls && my.Surface == ISO_SURFACE && Internals::HasSeveralProcesses())
  {
    texts.insert("jump walls are not shown: what lies on both sides of a face is known to one "
                 "process that has the whole mesh");
  }
  texts.erase("");
  for (const std::string& text : texts)
  {
    if (!my.Reported.contains(text) && Internals::IsFirstProcess())
    {
      vtkWarningMacro(<< text);
    }
  }
  my.Reported = std::move(texts);
}

//------------------------------------------------------------------------------
double* vtkPixelExactRepresentation::GetFieldRange()
{
  Internals& my = *this->Data;
  std::optional<std::array<double, 2>> range;
  if (Internals::HasSeveralProcesses())
  {
    range = my.Range.OfAll();
  }
  else if (my.Shown != nullptr)
  {
    range = my.Range.OfField(my.Shown, my.ColorArray, my.Mapper->GetLookupTable());
  }
  my.FieldRange = range.value_or(std::array{ 1.0, -1.0 });
  return my.FieldRange.data();
}

//------------------------------------------------------------------------------
bool vtkPixelExactRepresentation::AddToView(vtkView* view)
{
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  if (renderView == nullptr)
  {
    return false;
  }
  renderView->GetRenderer()->AddActor(this->Data->Actor);
  renderView->RegisterPropForHardwareSelection(this, this->Data->Actor);
  this->Data->Renderer = renderView->GetRenderer();
  this->Data->RenderObserver = renderView->GetRenderer()->AddObserver(
    vtkCommand::EndEvent, this, &vtkPixelExactRepresentation::AfterRender);
  this->Data->Notes.AddTo(renderView);
  return this->Superclass::AddToView(view);
}

//------------------------------------------------------------------------------
bool vtkPixelExactRepresentation::RemoveFromView(vtkView* view)
{
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  if (renderView == nullptr)
  {
    return false;
  }
  renderView->UnRegisterPropForHardwareSelection(this, this->Data->Actor);
  renderView->GetRenderer()->RemoveActor(this->Data->Actor);
  renderView->GetRenderer()->RemoveObserver(this->Data->RenderObserver);
  this->Data->Renderer = nullptr;
  this->Data->Notes.RemoveFrom(renderView);
  return this->Superclass::RemoveFromView(view);
}
