// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/FieldDots.h"

#include "Base/Report.h"
#include "Input/SolverFacts.h"
#include "Picture/ExtremeMarks.h"
#include "Scene/Shot.h"
#include "Scene/ShotAppearance.h"

#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"
#include "Core/Basis/LineFunctions.h"
#include "Core/Location/Locator.h"
#include "Core/Location/Sample.h"
#include "Core/Shape/ShapeFace.h"
#include "Trace/Projection.h"

#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <span>
#include <utility>

namespace pixelexact
{
namespace
{
/// Radius of a dot, in heights of the picture, and its least in pixels.
constexpr double kRadius = 0.006;
constexpr double kMinRadius = 2.0;
/// The basis of a quadrature function contains this text.
constexpr const char* kQuadrature = "Gauss-Legendre point";

/// The points of an element, xi, at which a field of this space has its values. Those of elements
/// of surfaces are on the surface, and those of plane elements in their plane.
std::vector<Vec3> PointsOf(const Mesh& mesh, int element, const Space& space)
{
  std::array<std::vector<long double>, 3> along;
  for (std::size_t d = 0; d < 3; ++d)
  {
    along[d] = GaussPoints(space.order[d] + 1);
  }
  if (mesh.isShell)
  {
    const Shape shape = mesh.ShapeOf(element);
    const bool isUpper = FacesOf(shape)[static_cast<std::size_t>(ShellFace(shape))].upper;
    along[static_cast<std::size_t>(AcrossSlab(shape))] = { isUpper ? 1.0L : -1.0L };
  }
  std::vector<Vec3> points;
  points.reserve(along[0].size() * along[1].size() * along[2].size());
  for (const long double z : along[2])
  {
    for (const long double y : along[1])
    {
      for (const long double x : along[0])
      {
        points.emplace_back(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
      }
    }
  }
  return points;
}

/// The shown component of a field's values at a point.
double ValueOf(std::span<const double> values, int component)
{
  if (component != kMagnitude || values.size() == 1)
  {
    return values[static_cast<std::size_t>(component == kMagnitude ? 0 : component)];
  }
  double length = 0.0;
  for (const double value : values)
  {
    length = std::hypot(length, value);
  }
  return length;
}

bool IsKept(const Scene& scene, const Vec3& x)
{
  return std::ranges::all_of(scene.kept,
    [&x](const KeptHalfSpace& half)
    { return half[0] * x.x + half[1] * x.y + half[2] * x.z + half[3] >= 0.0; });
}
} // namespace

FoundDots FieldDots::Find(const Shot& shot, const Frame& frame, const ShotAppearance& appearance)
{
  const auto& layers = shot.scene.layers;
  const auto layer = std::ranges::find_if(layers,
    [&shot](const Layer& one)
    {
      return one.field != nullptr && one.field->function == nullptr &&
        BasisOf(*shot.input.grid, one.field->name).find(kQuadrature) != std::string::npos;
    });
  if (layer == layers.end())
  {
    throw Error("--dots: no surface shows a quadrature function of MFEM, which has values at "
                "points; name one with --field, or leave the option out");
  }
  const Field& field = *layer->field;
  const Mesh& mesh = shot.input.model->GetMesh();
  const Projection projection(shot.view, frame.width, frame.height);
  const auto place = static_cast<std::size_t>(layer - layers.begin());
  const ColorMap& colors = appearance.Maps()[place];
  FoundDots found;
  found.field = field.name;
  std::vector<std::pair<double, FoundDots::Dot>> dots;
  std::map<Space, std::vector<Vec3>> pointsOf;
  std::vector<Vec3> places;
  std::vector<double> values;
  const auto components = static_cast<std::size_t>(field.values.components);
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    const Space& space = field.values.SpaceOf(e);
    std::vector<Vec3>& xi = pointsOf[space];
    xi = xi.empty() ? PointsOf(mesh, e, space) : std::move(xi);
    places.resize(xi.size());
    values.resize(components * xi.size());
    MapForward(mesh, e, xi, places);
    EvaluateAt(mesh, field, e, xi, values, {});
    found.points += xi.size();
    for (std::size_t k = 0; k < xi.size(); ++k)
    {
      const auto at = projection.Of(places[k]);
      if (!at || !IsKept(shot.scene, places[k]) || IsHidden(frame, *at, projection))
      {
        continue;
      }
      FoundDots::Dot dot{ at->at,
        ValueOf(std::span(values).subspan(components * k, components), layer->component), {} };
      colors({ &dot.value, 1 }, dot.color.data());
      dot.color[3] = 255;
      dots.emplace_back(at->depth, dot);
    }
  }
  std::ranges::stable_sort(dots, std::greater<>(), &std::pair<double, FoundDots::Dot>::first);
  if (const ValueRange& range = appearance.Ranges()[place])
  {
    const auto beyond = std::ranges::count_if(dots,
      [&range](const std::pair<double, FoundDots::Dot>& dot)
      { return dot.second.value < (*range)[0] || dot.second.value > (*range)[1]; });
    if (beyond > 0)
    {
      Note(Counted(beyond, "dot") +
        " with values beyond the range of colours; --range field holds all values");
    }
  }
  found.dots.reserve(dots.size());
  for (const auto& [depth, dot] : dots)
  {
    found.dots.push_back(dot);
  }
  return found;
}

void FieldDots::Draw(Canvas& canvas, const FoundDots& found, int height)
{
  const double size = 2.0 * std::max(kMinRadius, kRadius * height);
  for (const FoundDots::Dot& dot : found.dots)
  {
    canvas.Line(dot.at, dot.at, 1.4 * size, { 0, 0, 0, 255 });
    canvas.Line(dot.at, dot.at, size, dot.color);
  }
}
} // namespace pixelexact
