// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/ContourFile.h"

#include "Base/Numbers.h"
#include "Base/Options.h"
#include "Base/Report.h"
#include "Drawing/Picture.h"
#include "Scene/Shot.h"

#include "Core/Base/Error.h"
#include "Core/Contour/Contour.h"
#include "Core/Contour/SurfaceAbilities.h"
#include "Core/Location/Locator.h"
#include "Trace/Surfaces/Triangles.h"

#include "Cuts/ContourPolyData.h"

#include <glm/geometric.hpp>
#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <cmath>

namespace pixelexact
{
namespace
{
static_assert(kMagnitude == -1, "that of a ContourQuestion");

constexpr const char* kOption = "--contours-output";
} // namespace

void ContourFileOptions::AddTo(CLI::App& added)
{
  Bind(added, "--contours-output", file);
  Bind(added, "--contours-tolerance",
    [this](const std::string& text)
    {
      double length = 0.0;
      if (!ParseNumber(text, length) || !(length > 0.0 && std::isfinite(length)))
      {
        Refuse("--contours-tolerance", text, "a length greater than 0");
      }
      tolerance = length;
    });
}

void CheckContourSurfaces(const Shot& shot)
{
  for (const Layer& layer : shot.scene.layers)
  {
    if (layer.field == nullptr)
    {
      throw Error(std::string(kOption) + ": there is no field to contour; leave it out");
    }
    const bool isTriangles = dynamic_cast<const Triangles*>(layer.surface.get()) != nullptr;
    if (isTriangles || layer.surface->Implicit().empty())
    {
      throw Unsupported(std::string(kOption) + ": " + DescribeSurfacesWith(SurfaceUse::Lines));
    }
  }
}

ContourSet ContoursOfLayer(
  const Shot& shot, std::size_t layer, const std::vector<double>& values, double tolerance)
{
  const HighOrderModel& model = *shot.input.model;
  const Layer& of = shot.scene.layers[layer];
  return TraceContours({ model.GetMesh(), of.field, of.component }, of.surface->Implicit(),
    *shot.scene.locator, model.Faces(), { values, tolerance });
}

void WriteContours(const ContourFileOptions& options, const Shot& shot,
  const std::vector<std::vector<double>>& values)
{
  const HighOrderModel& model = *shot.input.model;
  const Box3 box = shot.scene.locator->Bounds();
  const double diagonal = glm::length(box.upper - box.lower);
  ContourSet all;
  std::vector<double> allValues;
  vtkNew<vtkIntArray> layers;
  layers->SetName("Layer");
  std::string name;
  for (std::size_t k = 0; k < shot.scene.layers.size(); ++k)
  {
    const Layer& layer = shot.scene.layers[k];
    ContourSet set = ContoursOfLayer(
      shot, k, values[k], options.tolerance.value_or(1e-4 * (diagonal > 0 ? diagonal : 1)));
    if (const std::string doubts = DescribeDoubts(set.report); !doubts.empty())
    {
      Warn(std::string(kOption) + ": " + doubts.substr(0, doubts.size() - 1));
    }
    for (std::size_t line = 0; line < set.lines.size(); ++line)
    {
      layers->InsertNextValue(static_cast<int>(k));
    }
    Append(std::move(set), allValues.size(), all);
    allValues.insert(allValues.end(), values[k].begin(), values[k].end());
    name = k == 0 || name == layer.field->name ? layer.field->name : "Value";
  }
  vtkNew<vtkPolyData> lines;
  ToPolyData(all, model, name, allValues, lines);
  lines->GetCellData()->AddArray(layers);
  WriteLines(options.file, lines);
}
} // namespace pixelexact
