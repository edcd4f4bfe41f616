// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderMapper.h"

#include "Frames/ContourLabels.h"
#include "Frames/FrameDrawer.h"
#include "Frames/FrameImage.h"
#include "Frames/FramePick.h"
#include "Frames/LayerRequests.h"
#include "Frames/MapperScene.h"
#include "Frames/ViewRequest.h"
#include "HighOrderModel.h"
#include "MessageWords.h"
#include "Views/MapperExecutive.h"
#include "Views/RenderLater.h"
#include "Views/StockSettings.h"
#include "Views/VtkColorMap.h"
#include "Views/VtkLook.h"

#include "Core/Base/Error.h"
#include "Core/Location/Locator.h"
#include "Trace/TraceTile.h"

#include "vtkCommand.h"
#include "vtkCompositeDataSet.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkHighOrderMapper);

struct vtkHighOrderMapper::Internals
{
  pixelexact::FrameDrawer Drawer;
  pixelexact::RenderLater Later;
  pixelexact::RenderCounters PickCounters;
  pixelexact::Renderer Picks{ PickCounters }; ///< for single pixels
  vtkSmartPointer<vtkImageData> Buffers;
  std::int64_t BuffersVersion = -1; ///< of the frame that Buffers hold
  std::array<double, 2> SeenRange;

  std::shared_ptr<const pixelexact::Appearance> Given; ///< null: the settings apply
  std::optional<std::size_t> TableLayer; ///< a layer of the last view that reads the mapper's table

  /// The view that mapper and actor determine.
  pixelexact::View ViewOf(vtkHighOrderMapper* self, vtkActor* actor);
  [[nodiscard]] pixelexact::RangeRule RuleOf(
    vtkHighOrderMapper* self, vtkScalarsToColors* table) const;
  /// The range that the mapper's table got.
  [[nodiscard]] pixelexact::ValueRange RangeIn(const pixelexact::Renderer& frames) const;
  pixelexact::ContourCounters CountContours();
};

//------------------------------------------------------------------------------
pixelexact::View vtkHighOrderMapper::Internals::ViewOf(vtkHighOrderMapper* self, vtkActor* actor)
{
  pixelexact::View view;
  pixelexact::Appearance& appearance = view.appearance;
  pixelexact::RequireFieldColors(self);
  const auto& model = Drawer.ModelOf(pixelexact::MapperExecutive::InputOf(self));
  view.data = model;
  view.scene.locator = &model->GetLocator();
  appearance.contours = self->AppearanceOfContours();
  appearance.edges = pixelexact::EdgesOf(actor->GetProperty());
  if (appearance.edges && self->EdgesByKind)
  {
    appearance.edges = pixelexact::EdgeStyle::ByKind(appearance.edges->width);
    appearance.faces = &model->Faces();
  }
  appearance.samples = self->Samples;
  if (self->Outlines)
  {
    appearance.outlines = pixelexact::ToRgba(self->OutlineColor);
  }
  if (self->ShowUndecided)
  {
    appearance.undecided = pixelexact::ToRgba(self->UndecidedColor);
  }
  pixelexact::LayerRequest ofAll = pixelexact::LayerOf(self, actor->GetProperty());
  ofAll.appearance.contours = self->ContoursOfAll();
  std::copy_n(self->UnknownColor, 4, ofAll.appearance.unknown.begin());
  ofAll.appearance.bands = self->Bands;
  TableLayer.reset();
  for (pixelexact::LayerRequest& layer :
    self->GetScene().MakeLayers(self, ofAll, model, Drawer.Surfaces()))
  {
    if (vtkScalarsToColors* const table = pixelexact::TableOf(layer))
    {
      layer.appearance.range = this->RuleOf(self, table);
      TableLayer = table == self->GetLookupTable() ? view.scene.layers.size() : TableLayer;
    }
    pixelexact::AddLayer(layer, *model, view);
  }
  if (Given != nullptr)
  {
    if (Given->layers.size() != appearance.layers.size())
    {
      throw pixelexact::Error("the appearance is not of as many layers as there are");
    }
    appearance = *Given;
    TableLayer.reset();
  }
  if (appearance.HasContours() && appearance.contours.labels)
  {
    pixelexact::RequireLabelSize(*appearance.contours.labels);
  }
  return view;
}

//------------------------------------------------------------------------------
pixelexact::RangeRule vtkHighOrderMapper::Internals::RuleOf(
  vtkHighOrderMapper* self, vtkScalarsToColors* table) const
{
  using Of = pixelexact::RangeRule::Of;
  if (self->UseLookupTableScalarRange || table != self->GetLookupTable())
  {
    return { Of::Ends, { table->GetRange()[0], table->GetRange()[1] } };
  }
  switch (self->RangeMode)
  {
    case RANGE_OF_CUT:
      return { Of::Cut, {}, self->RangeSymmetric };
    case RANGE_OF_FIELD:
      return { Of::Field, {}, self->RangeSymmetric };
    case RANGE_OF_PERCENTILES:
    {
      const auto [lower, upper] = self->RangePercentiles;
      if (!(lower >= 0.0 && lower < upper && upper <= 100.0))
      {
        throw pixelexact::Error("RangePercentiles: two percentages from 0 to 100, ascending");
      }
      return { Of::Parts, { lower, upper }, self->RangeSymmetric };
    }
    default:
      return { Of::Ends, { self->ScalarRange[0], self->ScalarRange[1] } };
  }
}

//------------------------------------------------------------------------------
pixelexact::ValueRange vtkHighOrderMapper::Internals::RangeIn(
  const pixelexact::Renderer& frames) const
{
  const std::vector<pixelexact::ResolvedLayer>& layers = frames.LastResolved().layers;
  return TableLayer && *TableLayer < layers.size() ? layers[*TableLayer].range : std::nullopt;
}

//------------------------------------------------------------------------------
pixelexact::ContourCounters vtkHighOrderMapper::Internals::CountContours()
{
  pixelexact::Renderer* frames = Drawer.LastRenderer();
  const pixelexact::ContourCertifier* contours =
    frames != nullptr ? frames->LastContours() : nullptr;
  return contours != nullptr ? contours->Counters() : pixelexact::ContourCounters{};
}

//------------------------------------------------------------------------------
vtkHighOrderMapper::vtkHighOrderMapper()
  : Data(std::make_unique<Internals>())
{
  // No component is chosen; 0 would be a choice.
  this->ArrayComponent = -1;
}

//------------------------------------------------------------------------------
vtkHighOrderMapper::~vtkHighOrderMapper() = default;

//------------------------------------------------------------------------------
int vtkHighOrderMapper::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
vtkExecutive* vtkHighOrderMapper::CreateDefaultExecutive()
{
  return pixelexact::MapperExecutive::New();
}

//------------------------------------------------------------------------------
void vtkHighOrderMapper::SetInputData(vtkDataObject* data)
{
  this->SetInputDataInternal(0, data);
}

//------------------------------------------------------------------------------
vtkUnstructuredGrid* vtkHighOrderMapper::GetInput()
{
  return vtkUnstructuredGrid::SafeDownCast(pixelexact::MapperExecutive::InputOf(this));
}

//------------------------------------------------------------------------------
vtkCompositeDataSet* vtkHighOrderMapper::GetCompositeInput()
{
  return vtkCompositeDataSet::SafeDownCast(pixelexact::MapperExecutive::InputOf(this));
}

//------------------------------------------------------------------------------
void vtkHighOrderMapper::SetFieldName(const char* name)
{
  // In VTK 9.1, vtkSetStdStringFromCharMacro calls Modified also for an unchanged name.
  const std::string wanted = name != nullptr ? name : "";
  if (this->FieldName != wanted)
  {
    this->FieldName = wanted;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkHighOrderMapper::GetNumberOfNumericHits()
{
  pixelexact::Renderer* frames = this->Data->Drawer.LastRenderer();
  const pixelexact::Frame* frame = frames != nullptr ? frames->LastFrame() : nullptr;
  return frame != nullptr ? frame->counters.numericHits : 0;
}

//------------------------------------------------------------------------------
bool vtkHighOrderMapper::IsFrameComplete()
{
  const pixelexact::Renderer* frames = this->Data->Drawer.LastRenderer();
  return frames != nullptr && frames->IsComplete();
}

//------------------------------------------------------------------------------
vtkIdType vtkHighOrderMapper::GetNumberOfUnknownPixels()
{
  pixelexact::Renderer* frames = this->Data->Drawer.LastRenderer();
  const pixelexact::Frame* frame = frames != nullptr ? frames->LastFrame() : nullptr;
  return frame != nullptr ? frame->counters.unknown : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkHighOrderMapper::GetNumberOfContourPixels()
{
  return this->Data->CountContours().in;
}

//------------------------------------------------------------------------------
vtkIdType vtkHighOrderMapper::GetNumberOfContourJumpPixels()
{
  return this->Data->CountContours().jumps;
}

//------------------------------------------------------------------------------
vtkIdType vtkHighOrderMapper::GetNumberOfContourLoopPixels()
{
  return this->Data->CountContours().loops;
}

//------------------------------------------------------------------------------
vtkIdType vtkHighOrderMapper::GetNumberOfUndecidedContourPixels()
{
  return this->Data->CountContours().undecided;
}

//------------------------------------------------------------------------------
void vtkHighOrderMapper::SetRangeMode(int mode)
{
  mode = std::clamp<int>(mode, RANGE_AS_SET, RANGE_OF_PERCENTILES);
  if (this->RangeMode != mode)
  {
    this->RangeMode = mode;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHighOrderMapper::SetScalarRange(double lower, double upper)
{
  this->SetRangeMode(RANGE_AS_SET);
  this->Superclass::SetScalarRange(lower, upper);
}

//------------------------------------------------------------------------------
double* vtkHighOrderMapper::GetSeenRange()
{
  const pixelexact::Renderer* frames = this->Data->Drawer.LastRenderer();
  const pixelexact::Frame* frame = frames != nullptr ? frames->LastFrame() : nullptr;
  const std::optional<std::size_t> layer = this->Data->TableLayer;
  const bool any =
    frame != nullptr && layer && *layer < frames->LastView().appearance.layers.size();
  this->Data->SeenRange =
    (any ? pixelexact::RangeSeen(frames->LastView(), *frame, *layer) : std::nullopt)
      .value_or(std::array{ 1.0, -1.0 });
  return this->Data->SeenRange.data();
}

//------------------------------------------------------------------------------
void vtkHighOrderMapper::SetColorMap(const std::string& name)
{
  try
  {
    const auto table = pixelexact::MakeColorMap(name, { 0.0, 1.0 });
    table->SetVectorModeToMagnitude();
    this->SetLookupTable(table);
  }
  catch (const pixelexact::Error& error)
  {
    vtkErrorMacro("SetColorMap: " << pixelexact::Worded(error.what()));
  }
}

//------------------------------------------------------------------------------
double* vtkHighOrderMapper::GetBounds()
{
  vtkMath::UninitializeBounds(this->Bounds);
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    return this->Bounds;
  }
  if (!this->Static)
  {
    this->Update();
  }
  vtkDataObject* data = pixelexact::MapperExecutive::InputOf(this);
  if (data == nullptr)
  {
    return this->Bounds;
  }
  try
  {
    const pixelexact::Box3& box = this->Data->Drawer.ModelOf(data)->GetLocator().Bounds();
    for (int i = 0; i < 3 && box.lower.x <= box.upper.x; ++i)
    {
      this->Bounds[2 * i] = box.lower[i];
      this->Bounds[2 * i + 1] = box.upper[i];
    }
  }
  catch (const pixelexact::Error&)
  {
    // Render reports the error; until then the points' box allows a camera to be placed.
    if (vtkUnstructuredGrid* grid = this->GetInput())
    {
      grid->GetBounds(this->Bounds);
    }
    else if (vtkCompositeDataSet* composite = this->GetCompositeInput())
    {
      composite->GetBounds(this->Bounds);
    }
  }
  return this->Bounds;
}

//------------------------------------------------------------------------------
void vtkHighOrderMapper::SetAppearance(std::shared_ptr<const pixelexact::Appearance> appearance)
{
  this->Data->Given = std::move(appearance);
  this->Modified();
}

//------------------------------------------------------------------------------
vtkImageData* vtkHighOrderMapper::GetBuffers()
{
  Internals& data = *this->Data;
  pixelexact::Renderer* frames = data.Drawer.LastRenderer();
  const pixelexact::Frame* frame = nullptr;
  try
  {
    frame = frames != nullptr ? frames->FrameWithAllBuffers() : nullptr;
  }
  catch (const pixelexact::Error& error)
  {
    vtkErrorMacro(<< pixelexact::Worded(error.what()));
  }
  if (frame == nullptr)
  {
    data.Buffers = nullptr;
    return nullptr;
  }
  if (data.Buffers == nullptr || data.BuffersVersion != frames->Version())
  {
    data.Buffers = pixelexact::ToImageData(*frames, *data.Drawer.LastModel(), *frame);
    data.BuffersVersion = frames->Version();
  }
  return data.Buffers;
}

//------------------------------------------------------------------------------
vtkIdType vtkHighOrderMapper::GetNumberOfModelBuilds()
{
  return this->Data->Drawer.ModelBuilds();
}

//------------------------------------------------------------------------------
vtkIdType vtkHighOrderMapper::GetNumberOfSurfaceBuilds()
{
  return this->Data->Drawer.Surfaces().Builds();
}

//------------------------------------------------------------------------------
vtkIdType vtkHighOrderMapper::GetNumberOfTraces()
{
  return this->Data->Drawer.Counters().traces;
}

//------------------------------------------------------------------------------
vtkIdType vtkHighOrderMapper::GetNumberOfColorings()
{
  return this->Data->Drawer.Counters().colorings;
}

//------------------------------------------------------------------------------
void vtkHighOrderMapper::Render(vtkRenderer* renderer, vtkActor* actor)
{
  const bool late = actor->IsRenderingTranslucentPolygonalGeometry();
  auto part = late ? pixelexact::FramePart::Translucent : pixelexact::FramePart::Opaque;
  // In this case there is no other phase.
  if (late ? actor->GetForceTranslucent() : actor->GetForceOpaque())
  {
    part = pixelexact::FramePart::All;
  }
  this->RenderPart(static_cast<int>(part), renderer, actor);
}

//------------------------------------------------------------------------------
void vtkHighOrderMapper::RenderAll(vtkRenderer* renderer, vtkActor* actor)
{
  this->RenderPart(static_cast<int>(pixelexact::FramePart::All), renderer, actor);
}

//------------------------------------------------------------------------------
void vtkHighOrderMapper::RenderPart(int part, vtkRenderer* renderer, vtkActor* actor)
{
  const auto drawn = static_cast<pixelexact::FramePart>(part);
  this->InvokeEvent(vtkCommand::StartEvent, nullptr);
  if (!this->Static && this->GetNumberOfInputConnections(0) > 0)
  {
    this->Update();
  }
  this->InvokeEvent(vtkCommand::EndEvent, nullptr);
  this->SetAbortExecute(0);
  pixelexact::MapperExecutive::WarnAgain(this);
  vtkRenderWindow* window = renderer->GetRenderWindow();
  const vtkIdType traces = this->GetNumberOfTraces();
  pixelexact::AbortCheck check(window);
  const pixelexact::Progress progress = [this, &check](double done)
  {
    this->UpdateProgress(done);
    return !this->GetAbortExecute() && !check.IsAborted();
  };
  pixelexact::FrameDrawer& drawer = this->Data->Drawer;
  try
  {
    if (this->GetScene().IsEmpty())
    {
      throw pixelexact::Error("nothing to cut with: call SetCutFunction, SetSurface or AddLayer");
    }
    const pixelexact::View view = this->Data->ViewOf(this, actor);
    if (view.scene.layers.empty())
    {
      drawer.DropFrame(renderer, actor);
      return;
    }
    pixelexact::RenderWork work{ .ranges = drawer.Ranges() };
    if (renderer->GetSelector() != nullptr)
    {
      drawer.Select(view, work, renderer, actor, this, progress);
      return;
    }
    // The opaque phase of the same picture, where there is one, has refined the frame.
    work.refine = drawn != pixelexact::FramePart::Translucent || actor->HasOpaqueGeometry() == 0;
    work.seconds = this->SecondsToTrace(window);
    drawer.Draw(view, work, drawn, renderer, actor, this, progress);
    this->TakeRange(*drawer.LastRenderer());
    this->TakeContours(*drawer.LastRenderer());
    this->Warn(renderer, actor);
    if (this->GetNumberOfTraces() != traces)
    {
      this->UpdateProgress(1.0);
      this->TimeToDraw = drawer.LastRenderer()->LastFrame()->counters.seconds;
    }
    if (this->StillSeconds > 0.0 && window->GetDesiredUpdateRate() < 1.0 &&
      !this->IsFrameComplete())
    {
      this->Data->Later.Ask(window->GetInteractor());
    }
  }
  catch (const pixelexact::Error& error)
  {
    drawer.DropFrame(renderer, actor);
    for (const std::string& text : drawer.Complain(renderer, actor, { error.what() }))
    {
      vtkErrorMacro(<< pixelexact::Worded(text));
    }
  }
}

//------------------------------------------------------------------------------
double vtkHighOrderMapper::SecondsToTrace(vtkRenderWindow* window)
{
  const double rate = window->GetDesiredUpdateRate();
  const double seconds = rate >= 1.0 ? 1.0 / rate : this->StillSeconds;
  return this->Progressive && window->GetInteractor() != nullptr && seconds > 0.0
    ? seconds
    : std::numeric_limits<double>::infinity();
}

//------------------------------------------------------------------------------
void vtkHighOrderMapper::TakeRange(const pixelexact::Renderer& frames)
{
  // Does not call Modified, because the range follows from earlier changes.
  if (const pixelexact::ValueRange range = this->Data->RangeIn(frames))
  {
    std::copy(range->begin(), range->end(), this->ScalarRange);
  }
}

//------------------------------------------------------------------------------
void vtkHighOrderMapper::TakeContours(const pixelexact::Renderer& frames)
{
  const pixelexact::ContourCertifier* contours = frames.LastContours();
  this->Superclass::TakeContours(
    contours != nullptr ? contours->Values() : std::vector<std::vector<double>>{});
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkHighOrderMapper::Complaints(
  const pixelexact::Renderer& frames, vtkActor* actor)
{
  // Windows draw translucent layers sheet by sheet.
  const bool bySheets =
    frames.LastView().appearance.bySheets && pixelexact::HasTranslucent(frames.LastView().scene);
  const bool mapped =
    this->ScalarVisibility || (this->ContourScalarVisibility && frames.LastContours() != nullptr);
  std::vector<std::string> texts = pixelexact::SettingsWithoutEffect(this, actor, mapped);
  // A single translucent plane has nothing behind it.
  if (this->ContourLabels && bySheets)
  {
    texts.emplace_back("ContourLabels: they are not written where a layer is seen through");
  }
  if (frames.LastFrame()->counters.cutOff > 0)
  {
    texts.push_back("at some pixels more than " + std::to_string(pixelexact::Sheets::kMax) +
      " translucent surfaces lie one behind the other, and what is behind these is not drawn: make "
      "some opaque or invisible");
  }
  return texts;
}

//------------------------------------------------------------------------------
void vtkHighOrderMapper::Warn(vtkRenderer* renderer, vtkActor* actor)
{
  pixelexact::FrameDrawer& drawer = this->Data->Drawer;
  for (const std::string& text :
    drawer.Complain(renderer, actor, this->Complaints(*drawer.LastRenderer(), actor)))
  {
    vtkWarningMacro(<< pixelexact::Worded(text));
  }
}

//------------------------------------------------------------------------------
std::optional<pixelexact::PickedSample> vtkHighOrderMapper::PickSample(
  const pixelexact::PickRay& ray, vtkActor* actor)
{
  const pixelexact::View view = this->Data->ViewOf(this, actor);
  if (view.scene.layers.empty())
  {
    return std::nullopt;
  }
  return pixelexact::Pick(this->Data->Picks, view, *this->Data->Drawer.LatestModel(),
    this->Data->Drawer.Ranges(), ray, this);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> vtkHighOrderMapper::TracePicture(pixelexact::Renderer& frames,
  const pixelexact::CameraSight& sight, bool allBuffers,
  const std::function<bool(double)>& progress)
{
  if (!this->Static && this->GetNumberOfInputConnections(0) > 0)
  {
    this->Update();
  }
  pixelexact::View view = this->Data->ViewOf(this, sight.actor);
  if (view.scene.layers.empty())
  {
    throw pixelexact::Error(
      "nothing to cut with, or no layer is visible: call SetCutFunction, SetSurface or AddLayer");
  }
  pixelexact::Complete(sight, view);
  auto picture = pixelexact::TracePicture(frames, view, { .ranges = this->Data->Drawer.Ranges() },
    *this->Data->Drawer.LatestModel(), allBuffers, progress);
  this->TakeRange(frames);
  this->TakeContours(frames);
  return picture;
}

//------------------------------------------------------------------------------
std::vector<std::array<double, 3>> vtkHighOrderMapper::SeenPoints(
  const pixelexact::CameraSight& sight)
{
  std::vector<std::array<double, 3>> points;
  try
  {
    pixelexact::View view = this->Data->ViewOf(this, sight.actor);
    if (view.scene.layers.empty())
    {
      return points;
    }
    pixelexact::Complete(sight, view);
    for (const pixelexact::Vec3& x : pixelexact::SeenPoints(view.scene, view.camera))
    {
      const double local[4] = { x.x, x.y, x.z, 1.0 };
      double world[4];
      sight.actor->GetMatrix()->MultiplyPoint(local, world);
      points.push_back({ world[0], world[1], world[2] });
    }
  }
  catch (const pixelexact::Error&)
  {
    points.clear();
  }
  return points;
}

//------------------------------------------------------------------------------
void vtkHighOrderMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Data->Drawer.ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkHighOrderMapper::CreateDefaultLookupTable()
{
  // The superclass would search texts among the arrays of its input, which is the empty
  // vtkPolyData.
  if (this->LookupTable != nullptr)
  {
    this->LookupTable->UnRegister(this);
  }
  const auto table = pixelexact::MakeColorMap("viridis", { 0.0, 1.0 });
  table->SetVectorModeToMagnitude();
  table->Register(this);
  this->LookupTable = table;
}

//------------------------------------------------------------------------------
void vtkHighOrderMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  this->Superclass::ShallowCopy(mapper);
  if (auto* other = vtkHighOrderMapper::SafeDownCast(mapper))
  {
    this->SetInputConnection(
      other->GetNumberOfInputConnections(0) > 0 ? other->GetInputConnection(0, 0) : nullptr);
    this->FieldName = other->FieldName;
    this->SetComponent(other->Component);
    this->SetUnknownColor(other->UnknownColor);
    this->SetBands(other->Bands);
    this->SetShowUndecided(other->ShowUndecided);
    this->SetUndecidedColor(other->UndecidedColor);
    this->SetProgressive(other->Progressive);
    this->SetStillSeconds(other->StillSeconds);
    this->SetRangeMode(other->RangeMode);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHighOrderMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FieldName: " << (this->FieldName.empty() ? "(first)" : this->FieldName) << "\n";
  os << indent << "Component: " << this->Component << "\n";
  os << indent << "RangeMode: "
     << (this->RangeMode == RANGE_AS_SET        ? "as set"
            : this->RangeMode == RANGE_OF_FIELD ? "of the field"
                                                : "of the cut")
     << "\n";
  os << indent << "UnknownColor: " << int{ this->UnknownColor[0] } << ", "
     << int{ this->UnknownColor[1] } << ", " << int{ this->UnknownColor[2] } << ", "
     << int{ this->UnknownColor[3] } << "\n";
  os << indent << "Bands: " << this->Bands << "\n";
  os << indent << "ShowUndecided: " << (this->ShowUndecided ? "on" : "off") << "\n";
  os << indent << "UndecidedColor: " << this->UndecidedColor[0] << ", " << this->UndecidedColor[1]
     << ", " << this->UndecidedColor[2] << "\n";
  os << indent << "Progressive: " << (this->Progressive ? "on" : "off") << "\n";
  os << indent << "StillSeconds: " << this->StillSeconds << "\n";
  os << indent << "Models: " << this->GetNumberOfModelBuilds()
     << ", surfaces: " << this->GetNumberOfSurfaceBuilds()
     << ", traces: " << this->GetNumberOfTraces() << ", colorings: " << this->GetNumberOfColorings()
     << "\n";
}
