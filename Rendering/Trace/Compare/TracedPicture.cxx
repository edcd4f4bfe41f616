// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Compare/TracedPicture.h"

#include <optional>
#include <utility>

namespace pixelexact
{
Picture TracePicture(const Scene& scene, const Camera& camera,
  const std::vector<const SampleColors*>& colors, const std::vector<double>& isoValues,
  const ContourMethod& method, const Progress& progress)
{
  Pipeline pipeline{ colors, {} };
  std::optional<ContourCertifier> certifier;
  if (!isoValues.empty())
  {
    certifier.emplace(std::vector<std::vector<double>>{ isoValues }, method);
    pipeline.modules.push_back(&*certifier);
  }
  bool aborted = false;
  const Progress watched = [&](double part)
  {
    aborted = aborted || (progress && !progress(part));
    return !aborted;
  };
  const Frame frame =
    Trace(scene, camera, pipeline, { .centres = Buffer::Value | Buffer::Verdict }, watched);
  return aborted
    ? Picture()
    : PictureOf(frame, certifier ? certifier->Verdicts() : std::vector<std::uint8_t>());
}

Picture TracePicture(const LinearSurface& surface, const Camera& camera,
  const std::vector<double>& isoValues, const Progress& progress)
{
  std::vector<double> centres = surface.Trace(camera, false, progress);
  if (centres.empty())
  {
    return {};
  }
  std::vector<double> corners;
  if (!isoValues.empty())
  {
    corners = surface.Trace(camera, true, progress);
    if (corners.empty())
    {
      return {};
    }
  }
  return PictureOf(camera.Width(), camera.Height(), std::move(centres), corners, isoValues);
}
} // namespace pixelexact
