// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Options.h"
#include "Input/Input.h"
#include "Scene/CameraOptions.h"
#include "Scene/ColorOptions.h"
#include "Scene/LayerOptions.h"
#include "Scene/Model.h"
#include "Scene/QualitySettings.h"
#include "Scene/SurfaceOptions.h"
#include "Scene/VolumeOptions.h"

#include "Trace/Appearance/Appearance.h"
#include "Trace/Camera.h"
#include "Trace/Scene.h"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pixelexact
{
class Stopwatch;
struct Shot;

/// Surfaces that lights shine on, where a layer has no setting of its own.
enum class Lit
{
  Curved, ///< all but flat ones
  On,
  Off
};

/// The rectangles of a figure, in pixels.
struct FigureLayout
{
  ImageSize size; ///< of the figure
  ImageSize picture;
  std::array<int, 2> corner{}; ///< the picture's lower left one, from that of the figure
  int font = 0;                ///< height of letters
  bool legendBelow = false;    ///< the legend is below the picture, else on its right
  /// Coordinates stand along the picture's left and lower sides; else the axes' directions are
  /// part of the legend.
  bool hasCoordinates = false;
  /// The figure is one of several with the same layout, which keep room for what others have.
  bool isOfSeries = false;
};

/// Options of surfaces, colours and camera that render and bench share.
struct ShotOptions
{
  const CLI::App* command = nullptr; ///< that they belong to
  InputRequest input;
  std::string field;            ///< empty: the first one, where there is one
  std::optional<int> component; ///< none: the value of a scalar, the magnitude of a vector
  SurfaceOptions surfaces;
  bool meshChanges = false; ///< between pictures; 2-D meshes may bend, so they have no common plane
  LayerOptions layers;
  CameraOptions camera;
  ColorOptions colors;
  ImageSize size;
  Precision precision = Precision::Double;
  Lit lights = Lit::Curved;
  int samples = 1;
  std::optional<PixelLength> edgeWidth; ///< none: no edges
  std::vector<double> edgeColor{ 0.4, 0.4, 0.4 };
  bool edgesByKind = false;
  bool outlines = false;
  /// Planes: a point and a normal, which points to the side that is kept.
  std::vector<std::vector<double>> clip;
  VolumeOptions volume;
  std::vector<std::string> otherFields; ///< of what is drawn over the surfaces
  std::vector<double> outlineColor{ 0.0, 0.0, 0.0 };
  /// Points that a camera which was not placed must see beside the cut, with the view so far;
  /// empty: none.
  std::function<std::vector<Vec3>(const Shot&)> alsoSeen;
  /// The layout of a figure around the picture of a scene, whose view has the direction of the
  /// final one; empty: the picture has `size`.
  std::function<FigureLayout(const Shot&)> layout;

  void AddTo(CLI::App& added);

  /// Throws UsageError where a range is that of all pictures, and there is one.
  void CheckRangeOfOne() const;
  /// The picture has a volume and no surface.
  [[nodiscard]] bool HasVolumeAlone() const;
  /// Whether a range is that of all pictures of an animation.
  [[nodiscard]] bool SpansAllPictures() const;

  /// The settings of each surface. Throws UsageError.
  [[nodiscard]] std::vector<LayerSettings> MakeLayers() const;
};

/// A scene that is ready to be traced. Where the input has no field, no layer has one.
struct Shot
{
  LoadedModel input;
  Scene scene;
  std::vector<LayerSettings> settings; ///< by layer
  CameraView view;
  ImageSize size;                     ///< of the picture
  std::optional<FigureLayout> layout; ///< of the figure around it, if there is one
  Lit lights = Lit::Curved;
  /// Samples, edges and outlines; ViewOf adds what depends on layers and camera.
  Appearance appearance;
  std::optional<Volume> volume;
  /// By layer, the range of the values in all pictures of an animation (RangeRule::Of::All).
  std::vector<std::optional<std::array<double, 2>>> valuesOfAll;
  std::vector<TruncatedField> truncated; ///< what is shown without its top modes
  std::vector<std::string> chosen; ///< words of a command line that were not given, and are so

  [[nodiscard]] Camera MakeCamera() const { return { view, size.width, size.height }; }
};

/// Points that a small picture of a scene shows.
std::vector<Vec3> SeenPoints(const Scene& scene, const CameraView& view, const ImageSize& size);

/// The corners of the box around the mesh; bit d of a corner's number is set at the upper end along
/// axis d.
std::array<Vec3, 8> CornersOfBox(const Shot& shot);

/// Checks the options, reads, converts and locates, in the order in which mistakes show soonest.
Shot Prepare(const ShotOptions& options, Stopwatch& stopwatch);

/// The same of an input that was read, whose step, deformation and truncation are those of the
/// options. Notes about the input are not repeated.
Shot Prepare(const ShotOptions& options, LoadedModel input, Stopwatch& stopwatch);

/// The same of another time step or of another scale of --warp, with the view that was, of options
/// that Prepare took; where the mesh is the same it is shared. `before` is held until it returns.
Shot PrepareStep(const ShotOptions& options, int step, const Shot& before, Stopwatch& stopwatch);

/// "magnitude" or the component's number; "value" for a scalar. Of a layer with a field.
std::string ComponentName(const Layer& layer);
} // namespace pixelexact
