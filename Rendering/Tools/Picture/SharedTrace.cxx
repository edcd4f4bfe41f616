// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/SharedTrace.h"

#include "Base/Command.h"
#include "Base/Processes.h"
#include "Files/TimeSeries.h"
#include "Picture/RenderOptions.h"
#include "Trace/Appearance/Painter.h"
#include "Trace/BufferTable.h"
#include "Trace/FrameTiles.h"
#include "Trace/View.h"

#include <vtkCommunicator.h>
#include <vtkMultiProcessController.h>

#include <algorithm>
#include <array>
#include <cstring>

namespace pixelexact
{
void RefuseSeveralProcesses(const std::string& what)
{
  if (AreSeveralProcesses())
  {
    throw UsageError(what + ": is not shared by several processes; start one, without mpirun");
  }
}

void CheckForSeveralProcesses(const RenderOptions& options)
{
  const auto ofField = [](const RangeRule& range) { return range.of == RangeRule::Of::Field; };
  const auto layers = options.shot.MakeLayers();
  if (ofField(options.shot.colors.Range()) ||
    std::ranges::any_of(
      layers, [&](const LayerSettings& layer) { return layer.range && ofField(*layer.range); }))
  {
    RefuseSeveralProcesses("--range field, the range of all elements");
  }
  if (options.shot.edgesByKind)
  {
    RefuseSeveralProcesses("--edges-by-kind, which asks for all neighbours,");
  }
  if (options.outline.IsAsked())
  {
    RefuseSeveralProcesses("--mesh-outline, which draws all of the boundary,");
  }
  if (Has(options.debug.Needs(), Buffer::Jump))
  {
    RefuseSeveralProcesses("--show jumps, which asks for all neighbours,");
  }
  if (options.quality.Stride() > 1)
  {
    RefuseSeveralProcesses("--stride");
  }
  if (options.shot.input.truncateOrder)
  {
    RefuseSeveralProcesses("--truncate-order, whose bound is that of all elements,");
  }
  if (LowerSuffix(options.shot.input.files.front()) == ".vtk")
  {
    RefuseSeveralProcesses("a legacy .vtk file");
  }
}

namespace
{
constexpr int kTag = 7001;

/// The samples of a process as bytes: sheet by sheet, buffer by buffer, tile by tile.
using Bytes = std::vector<char>;

/// Calls visit(first sample, samples) for each row of each tile of a turn.
template <class Visit>
void ForEachRow(const TileTurn& turn, int width, int height, const Visit& visit)
{
  int tile = 0;
  for (int y0 = 0; y0 < height; y0 += kTileSize)
  {
    for (int x0 = 0; x0 < width; x0 += kTileSize, ++tile)
    {
      const auto samples = static_cast<std::size_t>(std::min(x0 + kTileSize, width) - x0);
      for (int y = y0; turn.Has(tile) && y < std::min(y0 + kTileSize, height); ++y)
      {
        visit(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
            static_cast<std::size_t>(x0),
          samples);
      }
    }
  }
}

/// Calls visit(values) for each buffer that the samples contain.
template <class Samples, class Visit>
void ForEachHeld(Samples& samples, const Visit& visit)
{
  ForEachBuffer(
    [&](const auto& row)
    {
      auto& values = samples.*row.member;
      if (!values.empty())
      {
        visit(values);
      }
    });
}

Bytes Taken(const SampleBuffers& samples, const TileTurn& turn)
{
  Bytes bytes;
  ForEachHeld(samples,
    [&](const auto& values)
    {
      ForEachRow(turn, samples.width, samples.height,
        [&](std::size_t first, std::size_t count)
        {
          const auto* begin = reinterpret_cast<const char*>(values.data() + first);
          bytes.insert(bytes.end(), begin, begin + count * sizeof(values[0]));
        });
    });
  return bytes;
}

void Put(const Bytes& bytes, const TileTurn& turn, SampleBuffers& samples)
{
  const char* next = bytes.data();
  ForEachHeld(samples,
    [&](auto& values)
    {
      ForEachRow(turn, samples.width, samples.height,
        [&](std::size_t first, std::size_t count)
        {
          std::memcpy(values.data() + first, next, count * sizeof(values[0]));
          next += count * sizeof(values[0]);
        });
    });
}

/// The samples of a sheet; sheet 0 is the nearest.
SampleBuffers& SheetOf(Frame& frame, int sheet)
{
  return sheet == 0 ? frame.centres : frame.centres.behind[static_cast<std::size_t>(sheet) - 1];
}

void AddTiles(Frame& frame, int sheets, int processes, vtkMultiProcessController& all)
{
  const int own = all.GetLocalProcessId();
  for (int sheet = 0; sheet < sheets; ++sheet)
  {
    SampleBuffers& samples = SheetOf(frame, sheet);
    if (own != 0)
    {
      const Bytes bytes = Taken(samples, { own, processes });
      all.Send(bytes.data(), static_cast<vtkIdType>(bytes.size()), 0, kTag);
      continue;
    }
    for (int other = 1; other < processes; ++other)
    {
      const TileTurn turn{ other, processes };
      Bytes bytes(Taken(samples, turn).size());
      all.Receive(bytes.data(), static_cast<vtkIdType>(bytes.size()), other, kTag);
      Put(bytes, turn, samples);
    }
  }
}

void AddCounters(Frame& frame, vtkMultiProcessController& all)
{
  FrameCounters& counted = frame.counters;
  std::array<std::int64_t*, 8> sums{ &counted.rays, &counted.surfaceHits, &counted.exact,
    &counted.unknown, &counted.nonFinite, &counted.numericHits, &counted.undecidedHits,
    &counted.cutOff };
  std::array<long long, 9> own{};
  std::ranges::transform(sums, own.begin(), [](const std::int64_t* sum) { return *sum; });
  own.back() = counted.floatCheck.points;
  std::array<long long, 9> total{};
  all.AllReduce(
    own.data(), total.data(), static_cast<vtkIdType>(own.size()), vtkCommunicator::SUM_OP);
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    *sums[i] = total[i];
  }
  counted.floatCheck.points = total.back();
  const double largest = counted.floatCheck.largest;
  all.AllReduce(&largest, &counted.floatCheck.largest, 1, vtkCommunicator::MAX_OP);
  counted.nothing =
    static_cast<std::int64_t>(frame.centres.Size()) - counted.exact - counted.unknown;
}
} // namespace

Frame TraceTogether(const View& view, Buffer centres, const Progress& progress)
{
  if (HasJumps(view.scene))
  {
    RefuseSeveralProcesses("jump(...), which asks for all neighbours,");
  }
  auto& all = *vtkMultiProcessController::GetGlobalController();
  const int processes = all.GetNumberOfProcesses();
  const Buffer wanted = centres | NeedsOf(view);
  Frame frame = Trace(view.scene, view.camera.Make(), {},
    { .centres = wanted, .tiles = { all.GetLocalProcessId(), processes } }, progress);
  // All processes get the largest number of sheets.
  const int own = 1 + static_cast<int>(frame.centres.behind.size());
  int sheets = own;
  all.AllReduce(&own, &sheets, 1, vtkCommunicator::MAX_OP);
  while (static_cast<int>(frame.centres.behind.size()) + 1 < sheets)
  {
    frame.centres.behind.emplace_back().Allocate(wanted, frame.width, frame.height);
  }
  AddTiles(frame, sheets, processes, all);
  AddCounters(frame, all);
  return frame;
}
} // namespace pixelexact
