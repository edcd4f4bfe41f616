// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/Image.h"

#include <nlohmann/json.hpp>

#include <array>
#include <string>

// Messages to a page. A binary one has the length of its header in 4 bytes, the most significant
// first, the header in JSON, and the content.
namespace pixelexact
{
class DrawnShot;
struct RenderOptions;
struct SampleBuffers;
struct Shot;

/// NaN and infinity, which JSON does not have, become null.
[[nodiscard]] std::string TextMessage(const nlohmann::ordered_json& message);
[[nodiscard]] std::string BinaryMessage(
  const nlohmann::ordered_json& header, const std::string& content);

/// A picture, with its MIME type in the header. An exact one is a PNG, without loss. Another one is
/// a JPEG where it is large.
[[nodiscard]] std::string PictureMessage(
  const Image& image, bool isExact, nlohmann::ordered_json header);

/// The sample of a pixel: value, element (number in the file), xi, position and verdict. `pixel`
/// counts from the upper left.
[[nodiscard]] std::string HoverMessage(
  const std::array<int, 2>& pixel, const SampleBuffers& sample, const Shot& shot);

/// Adds to the header of an exact picture: counts of pixels, fields, time steps, whether there
/// are complex fields, colour bar, and the box of the mesh.
void AddExact(nlohmann::ordered_json& header, const RenderOptions& options, const Shot& shot,
  const DrawnShot& drawn);
} // namespace pixelexact
