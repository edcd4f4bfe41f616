// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CameraOptions.h"
#include "ColorOptions.h"
#include "Input.h"
#include "Model.h"
#include "Options.h"
#include "SurfaceOptions.h"

#include "Trace/Tracer.h"

#include <optional>
#include <string>

namespace pixelexact
{
class Stopwatch;

/// What is seen from where: the options that render and bench share.
struct ShotOptions
{
  InputRequest input;
  std::string field;
  std::optional<int> component; ///< none: the value of a scalar, the magnitude of a vector
  SurfaceOptions surfaces;
  CameraOptions camera;
  ColorOptions colors;
  ImageSize size;
  Precision precision = Precision::Double;

  /// `required`: INPUT and --field are.
  void AddTo(CLI::App& command, bool required = true);
};

/// A scene that is ready to be traced.
struct Shot
{
  LoadedModel input;
  Scene scene;
  CameraView view;
  ImageSize size;

  [[nodiscard]] Camera MakeCamera() const { return { view, size.width, size.height }; }
};

/// Checks the options, reads, converts and locates, in the order in which mistakes show soonest.
Shot Prepare(const ShotOptions& options, Stopwatch& stopwatch);

/// "magnitude" or the component's number; "value" for a scalar.
std::string ComponentName(const Scene& scene);
} // namespace pixelexact
