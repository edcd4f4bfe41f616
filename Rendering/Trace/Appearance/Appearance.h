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

// How a scene is drawn, as rules. Resolve turns the rules into numbers, and a Painter draws them.
// The tool, Python, the mappers and ParaView fill in these structs.
namespace pixelexact
{
class FaceTable;

/// Which values the ends of a colour map have.
struct RangeRule
{
  enum class Of
  {
    Cut,   ///< the exact values that the picture shows
    Field, ///< a proven enclosure of all values of the field over the mesh
    All,   ///< the exact values that all pictures of an animation show
    Parts, ///< percentiles of the values that the picture shows, a pixel a value
    Ends   ///< as given
  };
  Of of = Of::Cut;
  std::array<double, 2> ends{}; ///< values, or percentages
  bool symmetric = false;       ///< made as wide to both sides of 0; not of Ends

  bool operator==(const RangeRule&) const = default;

  /// Whether it follows from the values of a frame.
  [[nodiscard]] bool IsOfFrame() const { return of != Of::Field && of != Of::Ends; }
};

/// Which iso-values are drawn as contours, and in which colours.
struct ContourRule
{
  /// So many round values strictly inside the range of the layer's colours (RoundValues); 0: those
  /// below.
  int count = 0;
  std::vector<double> values = {}; ///< in any order
  /// One for each value, in the order of the values, or one for all; empty: those that the layer's
  /// colour map gives the values.
  std::vector<Rgba> colors = {};

  [[nodiscard]] bool Any() const { return Count() > 0; }
  [[nodiscard]] std::size_t Count() const
  {
    return count > 0 ? static_cast<std::size_t>(count) : values.size();
  }
  bool operator==(const ContourRule&) const = default;
};

/// How one layer of a scene is drawn.
struct LayerAppearance
{
  /// Null: there is no field, or nothing asks for the colour of a value.
  std::shared_ptr<const ColorTable> table;
  /// Number of steps of one colour over the table's range (InBands); 0: the table's own colours.
  int bands = 0;
  RangeRule range;
  /// Layers with the same number have one range together, where it is of the values of a frame.
  std::size_t rangeGroup = 0;
  std::optional<Rgba> solid; ///< the colour of all exact pixels, in the place of the table's
  Rgba unknown{ 255, 0, 255, 255 };
  double opacity = 1.0;             ///< 0 to 1
  std::optional<Material> material; ///< none: not lit
  ContourRule contours;

  /// Whether the table is read: by the surface's colours, the contours' or their values.
  [[nodiscard]] bool ReadsTable() const;
  /// Whether nothing behind the layer can be seen.
  [[nodiscard]] bool IsOpaque() const;
  bool operator==(const LayerAppearance& other) const;
};

/// How contours of all layers are classified and drawn.
struct ContourAppearance
{
  ContourStyle style; ///< `curved`, `keepBeneath` and `onSheet` are the Painter's
  ContourMethod method;
  std::optional<int> labels; ///< the height of labels in pixels; none: no labels
  std::optional<Rgba> only;  ///< surfaces have this one colour, the background's

  bool operator==(const ContourAppearance&) const = default;
};

/// How a scene is drawn.
struct Appearance
{
  std::vector<LayerAppearance> layers; ///< as many as the scene has
  std::vector<Light> lights;
  LitView lit;
  int samples = 1;                  ///< in pixels that are not of one colour
  std::optional<EdgeStyle> edges;   ///< of elements; none: none
  const FaceTable* faces = nullptr; ///< where edges are told apart by what lies behind the face
  std::optional<Rgba> outlines;     ///< of elements and layers; none: none
  /// The colour of pixels whose colour, or whose contours, are not proven: values have enclosures
  /// then, which single precision does not have. None: such pixels are drawn like the others.
  std::optional<Rgba> undecided;
  ContourAppearance contours; ///< where layers have some
  /// The sheets of translucent layers are drawn one by one, by a window: contours are on the
  /// nearest one, and labels are left out.
  bool bySheets = false;

  [[nodiscard]] bool HasContours() const;
  /// Whether contours are drawn on surfaces of one colour, which `contours.only` is.
  [[nodiscard]] bool HasContoursOnly() const { return contours.only && HasContours(); }
  /// Whether some surface has the colours of values.
  [[nodiscard]] bool IsByValue() const;
  [[nodiscard]] bool IsLit() const;
  /// Whether ranges or iso-values follow from the values of a frame.
  [[nodiscard]] bool NeedsFrame() const;
  bool operator==(const Appearance&) const = default;
};
} // namespace pixelexact
