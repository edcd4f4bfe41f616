// SPDX-License-Identifier: BSD-3-Clause
#include "FrameSource.h"

#include "HighOrderModel.h"
#include "VtkColorMap.h"
#include "VtkSurface.h"

#include "Core/Base/Error.h"
#include "Trace/ColorMapping.h"

#include "vtkImplicitFunction.h"
#include "vtkScalarsToColors.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace pixelexact
{
namespace
{
constexpr Buffer kDrawn = Buffer::Value | Buffer::Position | Buffer::Verdict;
constexpr Buffer kAll = kDrawn | Buffer::Normal | Buffer::Xi | Buffer::Element | Buffer::Depth;

bool Includes(Buffer set, Buffer wanted)
{
  return (set | wanted) == set;
}

ColorMap SolidColor(const std::array<std::uint8_t, 4>& color)
{
  return [color](std::span<const double> values, std::uint8_t* rgba)
  {
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      rgba = std::copy(color.begin(), color.end(), rgba);
    }
  };
}
} // namespace

FrameSource::FrameSource() = default;
FrameSource::~FrameSource() = default;

void FrameSource::DropFrame()
{
  TheFrame.reset();
  Passes.reset();
  Traced.reset();
  Colored.reset();
}

void FrameSource::Clear()
{
  DropFrame();
  TheScene = {};
  TheModel.reset();
}

const std::shared_ptr<HighOrderModel>& FrameSource::ModelOf(vtkUnstructuredGrid* grid)
{
  if (grid == nullptr)
  {
    Clear();
    throw Error("no input: connect a vtkUnstructuredGrid that carries high-order arrays");
  }
  if (!TheModel || !TheModel->IsCurrent(grid))
  {
    // Alive until the new one is made, which may share its locator.
    const std::shared_ptr<HighOrderModel> stale = TheModel;
    Clear();
    TheModel = HighOrderModel::From(grid);
    ++TheCounters.models;
  }
  return TheModel;
}

void FrameSource::MakeScene(const FrameRequest& request, const Field& field)
{
  TheScene = {};
  TheScene.locator = &TheModel->GetLocator();
  TheScene.field = &field;
  TheScene.component = ComponentOf(request.table, field.values.components);
  for (vtkImplicitFunction* cut : request.cuts)
  {
    std::shared_ptr<const Surface> surface = ToSurface(cut);
    if (!request.kept.empty())
    {
      surface = std::make_shared<ClippedSurface>(surface, request.kept);
    }
    TheScene.surfaces.push_back(std::move(surface));
  }
}

void FrameSource::BeginFrame(Buffer buffers)
{
  TheBuffers = buffers;
  Passes.emplace(TheScene, Traced->camera.Make(), buffers);
  Complete = false;
}

void FrameSource::TraceFrame(double seconds, const Progress& progress)
{
  const double pixels =
    static_cast<double>(Traced->camera.width) * static_cast<double>(Traced->camera.height);
  if (PixelSeconds * pixels <= seconds)
  {
    Passes->Complete(progress);
  }
  else
  {
    // The next pass takes three times what all before it have.
    while (Passes->Refine(progress) && Passes->Step() > 1 &&
      4.0 * Passes->Get().counters.seconds <= seconds)
    {
    }
  }
  Complete = Passes->Step() == 1;
  if (Complete)
  {
    TheFrame = Passes->Take();
    Passes.reset();
    PixelSeconds = TheFrame->counters.seconds / pixels;
  }
  else
  {
    TheFrame = Passes->Preview();
  }
  Colored.reset();
  ++TheCounters.traces;
}

void FrameSource::ColorFrame(ColorKey key)
{
  ColorMap map = key.table != nullptr ? ToColorMap(key.table) : SolidColor(key.solid);
  // After ToColorMap, which builds the table.
  key.state = key.table != nullptr ? key.table->GetMTime() : 0;
  if (Colored == key)
  {
    return;
  }
  ColorMapping(std::move(map), key.unknown).Process(*TheFrame);
  Colored = std::move(key);
  ++TheCounters.colorings;
}

const Frame& FrameSource::Render(const FrameRequest& request, const Progress& progress)
{
  try
  {
    Update(request, progress);
  }
  catch (...)
  {
    // A frame that is not the one asked for must not look like it.
    DropFrame();
    throw;
  }
  return *TheFrame;
}

void FrameSource::Update(const FrameRequest& request, const Progress& progress)
{
  const Field& field = request.field.In(*ModelOf(request.grid));
  TraceKey key;
  key.field = request.field;
  key.component = ComponentOf(request.table, field.values.components);
  for (vtkImplicitFunction* cut : request.cuts)
  {
    key.cuts.emplace_back(cut, cut != nullptr ? cut->GetMTime() : 0);
  }
  key.kept = request.kept;
  key.camera = request.camera;

  const Buffer wanted = kDrawn | request.buffers;
  const bool sameScene = Traced == key;
  if (!sameScene)
  {
    DropFrame();
    MakeScene(request, field);
    Traced = std::move(key);
  }
  if (!sameScene || !Includes(TheBuffers, wanted))
  {
    BeginFrame(wanted);
  }
  if (!Complete)
  {
    TraceFrame(request.seconds, progress);
  }
  ColorFrame({ request.table, 0, request.solidColor, request.unknownColor });
}

const Frame* FrameSource::FrameWithAllBuffers()
{
  if (!TheFrame)
  {
    return nullptr;
  }
  if (!Complete || !Includes(TheBuffers, kAll))
  {
    ColorKey colored = *Colored;
    BeginFrame(kAll);
    TraceFrame(std::numeric_limits<double>::infinity(), {});
    ColorFrame(std::move(colored));
  }
  return &*TheFrame;
}

const Frame* FrameSource::LastFrame() const
{
  return TheFrame ? &*TheFrame : nullptr;
}
} // namespace pixelexact
