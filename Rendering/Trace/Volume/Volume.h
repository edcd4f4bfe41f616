// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Mesh.h"
#include "Trace/Pipeline.h"
#include "Trace/Volume/TransferFunction.h"
#include "Trace/Volume/VolumeLeaves.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>

namespace pixelexact
{
struct Scene;

/// A field that fills the mesh as glowing, absorbing matter.
struct Volume
{
  const Field* field = nullptr;
  int component = 0; ///< or kMagnitude
  std::shared_ptr<const TransferFunction> transfer;

  bool operator==(const Volume& other) const
  {
    return field == other.field && component == other.component &&
      (transfer == other.transfer ||
        (transfer != nullptr && other.transfer != nullptr && *transfer == *other.transfer));
  }
};

/// Throws Error for a volume without field or transfer function, a component that the field does
/// not have, and a field that is no polynomial of each element.
void RequireTraceable(const Volume& volume);

/// Counts of a frame's pixels.
struct VolumeCounters
{
  std::int64_t proven = 0; ///< within kVolumeTolerance, pixels without matter included
  std::int64_t unproven = 0;
  double largest = 0.0; ///< bound of a proven pixel, in levels of a byte
};

/// Draws a volume in front of, between and behind the surfaces of a frame. Belongs after all other
/// modules. With translucent layers it blends the sheets a second time, so other modules must not
/// have drawn on the image. Without colours it does nothing.
class VolumeDrawing final : public FrameModule
{
public:
  /// Throws as RequireTraceable.
  explicit VolumeDrawing(Volume volume);
  ~VolumeDrawing() override;

  [[nodiscard]] SampleNeeds Needs() const override;
  void Begin(int width, int height) override;
  void Process(TileVisit& tile) override;

  /// The counts of the last frame.
  [[nodiscard]] VolumeCounters Counters() const;

private:
  [[nodiscard]] const VolumeLeaves& LeavesOf(const Scene& scene) const;

  Volume volume_;
  bool magnitude_ = false;
  mutable std::shared_ptr<const VolumeLeaves> leaves_;
  mutable std::mutex making_;
  std::atomic<std::int64_t> proven_{ 0 };
  std::atomic<std::int64_t> unproven_{ 0 };
  std::atomic<double> largest_{ 0.0 };
};
} // namespace pixelexact
