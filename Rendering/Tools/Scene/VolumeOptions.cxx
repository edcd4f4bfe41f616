// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/VolumeOptions.h"

#include "Base/Command.h"
#include "Base/Processes.h"
#include "Base/Report.h"
#include "Input/ColorMapFile.h"
#include "Scene/ColorOptions.h"
#include "Scene/MeshSurfaceOptions.h"
#include "Scene/Model.h"

#include "Core/Base/Error.h"
#include "Trace/Appearance/FieldRange.h"
#include "Views/VtkColorMap.h"

#include <glm/geometric.hpp>
#include <vtkLookupTable.h>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

namespace pixelexact
{
namespace
{
/// Linear parts of a map by name.
constexpr int kMapParts = 32;
/// The default unit distance is this part of the diagonal of the mesh's box.
constexpr double kUnitShare = 0.1;

/// A map by name over a range, with opacities from 0 to 1.
TransferFunction RampOf(const std::string& map, const std::array<double, 2>& range, double unit)
{
  const auto table = MakeColorMap(map, range);
  std::vector<TransferFunction::ColorPoint> colors;
  colors.reserve(kMapParts + 1);
  for (int i = 0; i <= kMapParts; ++i)
  {
    const double share = static_cast<double>(i) / kMapParts;
    TransferFunction::ColorPoint point{ range[0] + share * (range[1] - range[0]), {} };
    const auto entry = static_cast<vtkIdType>(
      std::min<double>(share * static_cast<double>(table->GetNumberOfTableValues()),
        static_cast<double>(table->GetNumberOfTableValues()) - 1.0));
    std::array<double, 4> rgba{};
    table->GetTableValue(entry, rgba.data());
    std::copy_n(rgba.begin(), 3, point.rgb.begin());
    colors.push_back(point);
  }
  return { std::move(colors), { { range[0], 0.0 }, { range[1], 1.0 } }, unit, "--transfer" };
}
} // namespace

void VolumeOptions::AddTo(CLI::App& command)
{
  Command = &command;
  Bind(command, "--volume", name_);
  Bind(command, "--transfer", transfer_);
  Bind(command, "--opacity-unit", unit_);
}

void VolumeOptions::Check(bool alone) const
{
  if (!IsAsked())
  {
    return;
  }
  for (const char* option : { "--samples", "--stride", "--figure", "--sweep", "--turn", "--owners",
         "--show", "--show-undecided", "--contours-only" })
  {
    if (IsGiven(*Command, option))
    {
      throw UsageError(std::string("--volume: ") + option +
        " is not available for pictures with a volume; leave it out");
    }
  }
  for (const char* option :
    { "--field", "--component", "--precision", "--layer", "--contours", "--edges", "--outlines",
      "--color", "--colormap", "--bands", "--log", "--nan-color", "--lights", "--enclosures" })
  {
    if (alone && IsGiven(*Command, option))
    {
      throw UsageError(std::string(option) +
        " has no effect: it is about surfaces, and there are none; add a surface or leave it out");
    }
  }
  if (AreSeveralProcesses())
  {
    throw UsageError("--volume: is not shared by several processes; start one, without mpirun");
  }
  if (!NamesColorMapFile(transfer_))
  {
    CheckMap("--transfer", transfer_);
    return;
  }
  (void)ReadTransferFile(transfer_, 1.0);
  if (alone && IsGiven(*Command, "--range"))
  {
    throw UsageError(
      "--range has no effect: the file of --transfer gives the values; leave out one "
      "of both");
  }
}

Volume VolumeOptions::Make(
  const HighOrderModel& model, const ColorOptions& colors, bool alone) const
{
  const RangeRule& rule = colors.Range();
  if (alone && IsGiven(*Command, "--range") &&
    (rule.symmetric || (rule.of != RangeRule::Of::Ends && rule.of != RangeRule::Of::Field)))
  {
    throw UsageError("--range: the colours of a volume span a,b or the range of the field (field); "
                     "choose one of them");
  }
  const IsoChoice choice = Resolve(IsoText{ name_, 0.0 }, model);
  Volume volume;
  volume.field = &model.GetField(choice.field);
  volume.component = volume.field->values.components == 1 ? 0 : choice.component;
  const Box3 box = BoxOf(model);
  const double diagonal = glm::length(box.upper - box.lower);
  const double unit = unit_.value_or(diagonal > 0.0 ? kUnitShare * diagonal : 1.0);
  if (NamesColorMapFile(transfer_))
  {
    volume.transfer = std::make_shared<TransferFunction>(ReadTransferFile(transfer_, unit));
  }
  else
  {
    std::array<double, 2> range{ 0.0, 1.0 };
    if (rule.of == RangeRule::Of::Ends)
    {
      range = rule.ends;
    }
    else if (const auto found = FieldRange(model.GetMesh(), *volume.field, volume.component))
    {
      range = BeyondRounding(*volume.field, *found);
    }
    if (!(range[0] < range[1]))
    {
      range[1] = range[0] + 1.0;
    }
    volume.transfer = std::make_shared<TransferFunction>(RampOf(transfer_, range, unit));
  }
  RequireTraceable(volume);
  return volume;
}
} // namespace pixelexact
