// SPDX-License-Identifier: BSD-3-Clause
// The boundary as triangles: what elements cut into linear cells show of it.
#include "Base/PeakMemory.h"
#include "Bench/FrameTime.h"
#include "Trade/TrianglesRun.h"

#include "Core/Base/Counted.h"
#include "Grids/FilterWork.h"
#include "HighOrderModel.h"
#include "Trace/Compare/LinearFaces.h"
#include "Trace/Surfaces/ElementFaces.h"

namespace pixelexact
{
namespace
{
class FacesRun final : public TrianglesRun
{
public:
  FacesRun(const TradeScene& scene, int level)
    : TrianglesRun(scene)
    , Parts(1 << level)
  {
  }

  TradeTime Measure() override
  {
    const FreshModel fresh(*scene_.shot);
    const Mesh& mesh = fresh.model->GetMesh();
    const Layer& layer = scene_.shot->scene.layers.front();
    const Field& field = *fresh.model->FindField(layer.field->name);
    TradeTime time;
    const PeakMemory memory;
    const Timer first;
    const auto surface = scene_.surface(fresh.model);
    const auto& faces = dynamic_cast<const ElementFaces&>(*surface).Faces();
    const std::size_t triangles = CountTriangles(mesh, faces, Parts);
    RequireMemory(
      96.0 * static_cast<double>(triangles), Counted(triangles, "triangle"), "lower the level");
    Linear.emplace(TrianglesOfFaces(mesh, field, layer.component, faces, Parts));
    time.first = first.Seconds();
    const Timer next;
    Linear.emplace(TrianglesOfFaces(mesh, field, layer.component, faces, Parts));
    time.next = next.Seconds();
    time.bytes = memory.Bytes().value_or(-1.0);
    return time;
  }

private:
  int Parts;
};
} // namespace

bool IsOfFaces(const TradeScene& scene)
{
  return dynamic_cast<const ElementFaces*>(scene.shot->scene.layers.front().surface.get()) !=
    nullptr;
}

std::unique_ptr<TradeRun> MakeFacesRun(const TradeScene& scene, const TradeSetting& setting)
{
  return std::make_unique<FacesRun>(scene, setting.number);
}
} // namespace pixelexact
