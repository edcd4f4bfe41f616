// SPDX-License-Identifier: BSD-3-Clause
#include "Cuts/IntegralRows.h"

#include "HighOrderModel.h"

#include "Core/Faces/AttributedFace.h"
#include "Core/Faces/FaceTable.h"
#include "Core/Shape/ShapeFace.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <sstream>

namespace pixelexact
{
namespace
{
std::string Counted(std::int64_t count, const std::string& thing)
{
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

} // namespace

std::vector<ElementFace> BoundaryOf(
  const HighOrderModel& model, std::span<const std::int32_t> attributes)
{
  std::vector<ElementFace> faces;
  for (const std::int32_t attribute : attributes)
  {
    std::ranges::copy(
      FacesOfAttribute(model.BoundaryFaces(), attribute), std::back_inserter(faces));
  }
  const Mesh& mesh = model.GetMesh();
  for (int e = 0; attributes.empty() && e < mesh.Elements(); ++e)
  {
    for (int f = 0; f < static_cast<int>(FacesOf(mesh.ShapeOf(e)).size()); ++f)
    {
      if (model.IsShell())
      {
        if (f == ShellFace(mesh.ShapeOf(e)))
        {
          faces.push_back({ e, f });
        }
        continue;
      }
      const FaceKind kind = model.Faces().KindOf(e, f);
      if (kind == FaceKind::Boundary || kind == FaceKind::Partly)
      {
        faces.push_back({ e, f });
      }
    }
  }
  std::ranges::sort(faces);
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

double IntegralRow::Middle() const
{
  return value.IsFinite() ? value.Middle() : std::numeric_limits<double>::quiet_NaN();
}

double IntegralRow::Error() const
{
  return value.IsFinite() ? value.RadiusAround(value.Middle())
                          : std::numeric_limits<double>::infinity();
}

std::vector<IntegralRow> RowsOf(const IntegralQuestion& question, const SurfaceIntegral& found)
{
  Interval area = found.sums[0];
  area.lower = std::max(area.lower, 0.0);
  std::vector<IntegralRow> rows{ { "Area", area } };
  const int components = question.Components();
  for (const bool mean : { false, true })
  {
    for (int c = 0; c < components; ++c)
    {
      const Interval& sum = found.sums[static_cast<std::size_t>(c) + 1];
      rows.push_back({ std::string(mean ? "Mean" : "Integral") +
          (components > 1 ? " " + std::to_string(c) : std::string()),
        // A field that is zero has the mean zero, exactly.
        mean && sum.Magnitude() > 0.0 ? sum / area : sum });
    }
  }
  if (question.HasFlux())
  {
    rows.push_back({ "Flux", found.sums.back() });
  }
  return rows;
}

std::vector<std::string> DoubtsOf(const SurfaceIntegral& found, double tolerance)
{
  std::vector<std::string> doubts;
  const auto add = [&doubts](std::int64_t count, const std::string& text)
  {
    if (count > 0)
    {
      doubts.push_back(Counted(count, "element") + " " + text);
    }
  };
  if (found.elements + found.faces + found.notFinite + found.tooHigh + found.flat == 0)
  {
    doubts.emplace_back("the surface meets no element of the mesh");
  }
  if (found.isNumeric)
  {
    doubts.emplace_back("the field has jumps or second derivatives: its integrals are numeric, "
                        "the errors are estimates");
  }
  if (!found.met)
  {
    std::ostringstream text;
    text << "the errors are above the tolerance, " << tolerance << " of the integrals of magnitudes"
         << (found.timeIsOver ? ": the time was over; give more"
                : found.rounded > 0
                ? ": rounding of the coordinates allows no smaller ones; give a larger tolerance"
                : "");
    doubts.push_back(text.str());
  }
  if (found.unresolved > 0.0 && !found.met)
  {
    std::ostringstream text;
    text << "an area of at most " << found.unresolved
         << " is not accounted for: the errors include it";
    doubts.push_back(text.str());
  }
  add(found.notFinite, "left out: coefficients are NaN or infinite");
  add(
    found.tooHigh, "left out: the order is too high for so curved a surface, or clip; use planes");
  add(found.flat, "left out: the field has the value of the iso-surface all over them");
  add(found.notValid,
    "not proven to have a map that does not fold: where it does the integrals count places several "
    "times");
  if (found.covered > 0)
  {
    doubts.push_back(Counted(found.covered, "face") +
      " with other elements behind a part of it: counted whole, where pictures show what is bare");
  }
  return doubts;
}

SurfaceIntegral IntegrateBoundary(const IntegralQuestion& question,
  std::span<const std::int32_t> attributes, const HighOrderModel& model,
  const IntegralEffort& effort)
{
  SurfaceIntegral found = IntegrateFaces(question, BoundaryOf(model, attributes), effort);
  // Faces that are selected by attribute count whole, also where they are partly covered.
  found.covered =
    attributes.empty() && !model.IsShell() ? model.Faces().CountOf(FaceKind::Partly) : 0;
  return found;
}
} // namespace pixelexact
