// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Modules/ColorMapping.h"
#include "Trace/Modules/ContourLines.h"
#include "Trace/Modules/ElementEdges.h"
#include "Trace/Modules/Lighting.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

// Rules for drawing a scene. Resolve converts the rules to numbers, and a Painter draws them. The
// tool, Python, the mappers and ParaView fill these structs.
namespace pixelexact
{
class FaceTable;

/// The values at the ends of a colour map.
struct RangeRule
{
  enum class Of
  {
    Cut,   ///< the exact values that the picture shows
    Field, ///< a proven enclosure of all values of the field over the mesh
    All,   ///< the exact values that all pictures of an animation show
    Parts, ///< percentiles of the picture's values, one value per pixel
    Ends   ///< given numbers
  };
  Of of = Of::Cut;
  std::array<double, 2> ends{}; ///< values, or percentages
  bool symmetric = false;       ///< extended to be symmetric about 0; not with Ends

  bool operator==(const RangeRule&) const = default;

  /// The range depends on the values of a frame.
  [[nodiscard]] bool IsOfFrame() const { return of != Of::Field && of != Of::Ends; }
};

/// The iso-values of a layer's contours, and their colours.
struct ContourRule
{
  /// Number of round values strictly inside the range of the layer's colours (RoundValues); 0:
  /// `values` is used.
  int count = 0;
  std::vector<double> values = {}; ///< in any order
  /// One for each of `values`, in their order, or one for all; empty: the layer's colour map gives
  /// the colours of the values.
  std::vector<Rgba> colors = {};

  [[nodiscard]] bool Any() const { return Count() > 0; }
  [[nodiscard]] std::size_t Count() const
  {
    return count > 0 ? static_cast<std::size_t>(count) : values.size();
  }
  bool operator==(const ContourRule&) const = default;
};

/// Rules for drawing one layer of a scene.
struct LayerAppearance
{
  /// Null: the layer has no field, or no colour depends on a value.
  std::shared_ptr<const ColorTable> table;
  /// Number of steps of one colour over the table's range (InBands); 0: the table's own colours.
  int bands = 0;
  RangeRule range;
  /// Layers with the same number share one range, if it depends on the values of a frame.
  std::size_t rangeGroup = 0;
  std::optional<Rgba> solid; ///< the colour of all exact pixels; replaces the table's
  Rgba unknown{ 255, 0, 255, 255 };
  double opacity = 1.0;             ///< 0 to 1
  std::optional<Material> material; ///< none: not lit
  ContourRule contours;

  /// The surface's colours, the contours' colours or their values depend on the table.
  [[nodiscard]] bool ReadsTable() const;
  /// Nothing behind the layer is visible.
  [[nodiscard]] bool IsOpaque() const;
  bool operator==(const LayerAppearance& other) const;
};

/// Classification and drawing of the contours of all layers.
struct ContourAppearance
{
  ContourStyle style; ///< `curved`, `keepBeneath` and `onSheet` are set by the Painter
  ContourMethod method;
  std::optional<int> labels; ///< the height of labels in pixels; none: no labels
  std::optional<Rgba> only;  ///< surfaces get this colour, that of the background

  bool operator==(const ContourAppearance&) const = default;
};

/// Rules for drawing a scene.
struct Appearance
{
  std::vector<LayerAppearance> layers; ///< as many as the scene has
  std::vector<Light> lights;
  LitView lit;
  int samples = 1;                  ///< per pixel that has several colours
  std::optional<EdgeStyle> edges;   ///< of elements; none: no edges
  const FaceTable* faces = nullptr; ///< of the mesh, if edges are classified by FaceKind
  std::optional<Rgba> outlines;     ///< of elements and layers; none: no outlines
  /// The colour of pixels whose colour or contours are not proven. Values then have enclosures,
  /// which single precision excludes. None: such pixels are drawn like the others.
  std::optional<Rgba> undecided;
  ContourAppearance contours; ///< if layers have contours
  /// A window draws the sheets of translucent layers one by one. Contours are then on the nearest
  /// sheet, and labels are omitted.
  bool bySheets = false;

  [[nodiscard]] bool HasContours() const;
  /// Contours are drawn on surfaces of one colour, `contours.only`.
  [[nodiscard]] bool HasContoursOnly() const { return contours.only && HasContours(); }
  /// Some surface's colours depend on values.
  [[nodiscard]] bool IsByValue() const;
  [[nodiscard]] bool IsLit() const;
  /// Ranges or iso-values depend on the values of a frame.
  [[nodiscard]] bool NeedsFrame() const;
  bool operator==(const Appearance&) const = default;
};
} // namespace pixelexact
