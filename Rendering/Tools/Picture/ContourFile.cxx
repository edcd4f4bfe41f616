// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/ContourFile.h"

#include "Base/Numbers.h"
#include "Base/Options.h"
#include "Base/Report.h"
#include "Drawing/Picture.h"
#include "Scene/Shot.h"

#include "Core/Base/Error.h"
#include "Core/Contour/Contour.h"
#include "Core/Location/Locator.h"
#include "Trace/Surfaces/Plane.h"
#include "Trace/Surfaces/Quadric.h"
#include "Trace/Surfaces/Torus.h"

#include "Cuts/ContourPolyData.h"

#include <glm/geometric.hpp>
#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <cmath>
#include <iterator>
#include <memory>

namespace pixelexact
{
namespace
{
static_assert(kMagnitude == -1, "that of a ContourQuestion");

constexpr const char* kOption = "--contours-output";

/// Null for surfaces that have no polynomial.
std::unique_ptr<const CutFunction> CutOf(const Surface& surface)
{
  QuadricForm form;
  if (const auto* plane = dynamic_cast<const Plane*>(&surface))
  {
    form.origin = plane->Point();
    form.g = plane->Normal({});
    return std::make_unique<QuadricCut>(form);
  }
  if (const auto* quadric = dynamic_cast<const Quadric*>(&surface))
  {
    const QuadraticForm& given = quadric->GetForm();
    form.origin = given.centre;
    for (std::size_t i = 0; i < 6; ++i)
    {
      form.q[i] = (i < 3 ? 1.0 : 2.0) * given.Q[i].high;
    }
    form.g = 2.0 * Vec3(given.b[0].high, given.b[1].high, given.b[2].high);
    form.c = given.k.high;
    return std::make_unique<QuadricCut>(form);
  }
  if (const auto* torus = dynamic_cast<const Torus*>(&surface))
  {
    return std::make_unique<TorusCut>(
      torus->Centre(), torus->AxisDirection(), torus->Radius(), torus->Tube());
  }
  return nullptr;
}

void Append(ContourSet&& more, std::size_t valuesBefore, ContourSet& all)
{
  const auto before = static_cast<std::int64_t>(all.vertices.size());
  std::ranges::move(more.vertices, std::back_inserter(all.vertices));
  for (ContourLine& line : more.lines)
  {
    line.value += valuesBefore;
    for (std::int64_t& id : line.vertices)
    {
      id += before;
    }
    all.lines.push_back(std::move(line));
  }
}
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
    if (!CutOf(*layer.surface))
    {
      throw Unsupported(std::string(kOption) +
        ": contours are written for --plane, --sphere, --cylinder, --cone, --quadric and "
        "--torus; leave out other surfaces");
    }
  }
}

ContourSet ContoursOfLayer(
  const Shot& shot, std::size_t layer, const std::vector<double>& values, double tolerance)
{
  const HighOrderModel& model = *shot.input.model;
  const Layer& of = shot.scene.layers[layer];
  const auto cut = CutOf(*of.surface);
  return TraceContours({ model.GetMesh(), of.field, of.component, cut.get() }, *shot.scene.locator,
    model.Faces(), { values, tolerance });
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
