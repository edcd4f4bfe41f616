// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Appearance/Resolve.h"
#include "Trace/Compare/PictureErrors.h"
#include "Trace/Surfaces/BezierPatch.h"
#include "Trace/View.h"

#include <vtkSmartPointer.h>

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class vtkImplicitFunction;
class vtkUnstructuredGrid;

namespace pixelexact
{
class HighOrderModel;
class Surface;
struct Shot;

/// What is compared: a shot of one layer.
struct TradeScene
{
  const Shot* shot = nullptr;
  /// The cut-surface of a model of the same mesh.
  std::function<std::shared_ptr<const Surface>(const std::shared_ptr<const HighOrderModel>&)>
    surface;
  // What VTK's filters make it of: a function, or a field's name, component (or kMagnitude) and
  // value.
  vtkSmartPointer<vtkImplicitFunction> function;
  std::string isoField;
  int isoComponent = 0;
  int isoComponents = 1; ///< that the field has
  double isoValue = 0.0;
  std::vector<BezierPatch> patches; ///< that the surface is made of
  std::vector<double> isoValues;    ///< of contours, ascending; none: no contours
  View view;                        ///< of the shot
  ResolvedAppearance resolved;      ///< of the view
  ColorMap map;
  std::array<double, 2> range{}; ///< of the colour map
};

/// Ways to make a picture.
enum class TradeFamily
{
  Exact,     ///< the ray tracer, with its knobs
  Cut,       ///< vtkHighOrderLinearCut
  Resample,  ///< vtkHighOrderLinearResample and vtkCutter; not of iso-surfaces, as Cut
  Subdivide, ///< vtkHighOrderSubdivide and vtkCutter or vtkContourFilter
  Cells,     ///< these on the file's own high-order cells
  // Of expressions with derivatives: what these have at their points, VTK's filters compute from
  // the fields at the points (NodalExpression.h).
  Gradient,     ///< as Subdivide
  GradientCells ///< as Cells
};
[[nodiscard]] const char* Name(TradeFamily family);
/// Whether a family's derivatives are vtkGradientFilter's.
[[nodiscard]] bool IsOfGradientFilter(TradeFamily family);
/// Describes these settings in tables.
inline constexpr const char* kGradientMethod =
  "VTK's Gradient filter and Calculator, from the fields at the nodes";

/// One of them.
struct TradeSetting
{
  std::string name;
  TradeFamily family = TradeFamily::Exact;
  int number = 0; ///< resolution, nodes along the longest side, level; of exact ones a stride or so
  /// Of the points between which is interpolated, but for a factor of the family's; 0: no spacing.
  double spacing = 0.0;
  std::optional<int> order = {}; ///< of an exact one, what its field is truncated to
};

/// What making a picture twice took.
struct TradeTime
{
  double first = 0.0;  ///< seconds, from a model in memory of which nothing is known but itself
  double next = 0.0;   ///< the same cut made again, with all that can be kept
  double bytes = -1.0; ///< at the peak, beyond the model; less than 0: not known
};

/// Makes pictures with one setting, and times itself.
class TradeRun
{
public:
  virtual ~TradeRun() = default;
  /// Throws Error, also where it would not fit into memory.
  virtual TradeTime Measure() = 0;
  /// The picture that the last Measure made.
  [[nodiscard]] virtual Picture Show() = 0;
  /// How far the values of the setting's picture are from the exact one's at most, anywhere in the
  /// mesh, by proof; none: nothing is known but what is measured. Takes a while.
  [[nodiscard]] virtual std::optional<double> ProvenChange() const { return std::nullopt; }
  /// Of the linear surface; 0: there is none.
  [[nodiscard]] virtual std::size_t Triangles() const { return 0; }
};

/// A copy of the shot's grid and its model, with neither bounds nor hierarchy yet.
struct FreshModel
{
  explicit FreshModel(const Shot& shot);
  vtkSmartPointer<vtkUnstructuredGrid> grid;
  std::shared_ptr<HighOrderModel> model;
};

/// What there is to try on the exact side: precision, stride, samples, the field truncated to these
/// orders and, with contours, how they are told.
[[nodiscard]] std::vector<TradeSetting> ExactSettings(
  bool contours, const std::vector<int>& orders);
/// Whether its values, and not the contours or colours alone, differ from the exact picture's, or
/// it is that.
[[nodiscard]] bool HasOwnValues(const TradeSetting& setting);
/// Whether the cut-surface is made of elements' faces.
[[nodiscard]] bool IsOfFaces(const TradeScene& scene);
/// Whether it is made of triangles of a file, or of Bezier patches.
[[nodiscard]] bool IsOfPieces(const TradeScene& scene);
/// Whether VTK's filters would cut other cells than linear ones, with the fields at their points
/// that the family, Cells or GradientCells, needs.
[[nodiscard]] bool HasHighOrderCells(const TradeScene& scene, TradeFamily family);
/// Whether the field, or that of the iso-surface, is an expression with derivatives.
[[nodiscard]] bool HasDerivatives(const TradeScene& scene);
/// Why no setting with VTK's Gradient filter can make these; empty: they can.
[[nodiscard]] std::string GradientObstacle(const TradeScene& scene);

/// Of a regular grid over the volume: as many nodes along the longest side, and about as far apart
/// along the others.
[[nodiscard]] std::array<int, 3> NodesAlong(vtkUnstructuredGrid* grid, int number);

[[nodiscard]] std::unique_ptr<TradeRun> MakeRun(
  const TradeScene& scene, const TradeSetting& setting);

// Of MakeRun, by family.
[[nodiscard]] std::unique_ptr<TradeRun> MakeExactRun(
  const TradeScene& scene, const TradeSetting& setting);
[[nodiscard]] std::unique_ptr<TradeRun> MakeLinearRun(
  const TradeScene& scene, const TradeSetting& setting);
/// Of scenes of faces, which have the family Subdivide alone, without VTK's filters.
[[nodiscard]] std::unique_ptr<TradeRun> MakeFacesRun(
  const TradeScene& scene, const TradeSetting& setting);
/// The same of scenes of triangles and patches: each edge in 16, 32, ... parts.
[[nodiscard]] std::unique_ptr<TradeRun> MakePiecesRun(
  const TradeScene& scene, const TradeSetting& setting);
} // namespace pixelexact
