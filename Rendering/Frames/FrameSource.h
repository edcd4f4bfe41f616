// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Frames/FrameRequest.h"
#include "PixelExactRenderingModule.h"
#include "Trace/Appearance/Painter.h"
#include "Trace/FrameCost.h"
#include "Trace/ProgressiveFrame.h"
#include "Trace/TileSamples.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

namespace pixelexact
{
class HighOrderModel;

/// How often each step was taken.
struct FrameSourceCounters
{
  std::int64_t traces = 0;
  std::int64_t colorings = 0;
};

/// Frames of one view for whoever draws them: mapper, render pass. Keeps the last frame, and takes
/// only the steps whose inputs changed: another lookup table recolours, another camera or model
/// traces. Not for use by several threads at once.
class PIXELEXACTRENDERING_EXPORT FrameSource
{
public:
  /// Counts in `counters`, which others may share and which must outlive this.
  explicit FrameSource(FrameSourceCounters& counters);
  ~FrameSource();
  FrameSource(const FrameSource&) = delete;
  FrameSource& operator=(const FrameSource&) = delete;

  /// The frame asked for, of a model that is not null; valid until the next call. An aborted frame
  /// (see Progress) lacks tiles and is traced anew by the next call; a coarse one (see
  /// FrameRequest::seconds) has only some of the pixels (LastStep). Throws Error, after which there
  /// is no frame.
  const Frame& Render(const FrameRequest& request, const Progress& progress = {});

  /// Samples of the frame asked for at `positions` alone, with the usual buffers and colours; those
  /// of a pixel's centre are the pixel's, bit for bit. There is no frame afterwards. Throws Error.
  SampleBuffers Sample(const FrameRequest& request, std::span<const ImagePosition> positions);

  /// The last frame, complete and with all of its buffers, traced once more where some were not
  /// asked for.
  /// Null when there is none.
  const Frame* FrameWithAllBuffers();

  /// The last frame, null when there is none or it failed.
  [[nodiscard]] const Frame* LastFrame() const;

  /// Pixels between those of the last frame, which has only every so many-th of each row and
  /// column; 1: all of them.
  [[nodiscard]] int LastStep() const { return TheStep; }

  /// Whether there is one, neither coarse nor aborted.
  [[nodiscard]] bool IsComplete() const { return TheFrame && Complete; }

  /// What is known of the last frame's pixels and its contours; null where there are none, or only
  /// a coarse frame.
  [[nodiscard]] const ContourCertifier* LastContours() const
  {
    return TheFrame && Complete ? ThePainter->Contours() : nullptr;
  }
  /// How the last frame is shown, and its colours and contours in numbers.
  [[nodiscard]] const Appearance& LastAppearance() const { return TheAppearance; }
  [[nodiscard]] const ResolvedAppearance& LastResolved() const { return Resolved; }

  /// The model of the last frame; null when there is none.
  [[nodiscard]] const HighOrderModel* Model() const { return TheModel.get(); }
  /// Of the last frame.
  [[nodiscard]] const Scene& LastScene() const { return TheScene; }

  /// Differs whenever pixels may differ from those seen before, in this view or another that counts
  /// in the same counters.
  [[nodiscard]] std::int64_t Version() const { return TheVersion; }
  /// Differs whenever positions may.
  [[nodiscard]] std::int64_t TraceVersion() const { return TheTraceVersion; }

  /// Forgets model and frame.
  void DropFrame();

private:
  void Update(const FrameRequest& request, const Progress& progress);
  void MakeScene(const FrameRequest& request);
  /// Ranges, iso-values and modules of TheAppearance. `frame`: of its values; null: there is none
  /// yet.
  void MakePainter(const Frame* frame);
  /// Of a frame that is being traced: without what follows from its values.
  [[nodiscard]] Pipeline TracingPipeline();
  /// What is there in the appearance's colours: the complete frame, or a coarse one.
  void Paint();
  void BeginFrame(Buffer buffers);
  void TraceFrame(double seconds, const Progress& progress);
  void TraceBlocks(Buffer buffers, const Progress& progress);
  void ShowPreview();
  void WriteLabels();
  void Count(bool traced);
  void Forget();
  [[nodiscard]] Buffer AllBuffers() const;

  std::shared_ptr<HighOrderModel> TheModel;
  std::shared_ptr<FieldRanges> Ranges;
  std::shared_ptr<ContourBounds> Bounds; ///< what contours know of the model's fields
  Scene TheScene;
  Buffer TheBuffers = Buffer::None; ///< that the frame was traced with
  std::optional<TraceKey> Traced;   ///< of TheScene; none: nothing to show
  Appearance TheAppearance;
  ResolvedAppearance Resolved;
  std::unique_ptr<Painter> ThePainter;    ///< of TheAppearance; null: of none
  std::optional<ProgressiveFrame> Passes; ///< of a frame that is not complete
  std::optional<int> Shown;               ///< the passes' step, of which TheFrame is the preview
  std::optional<Frame> TheFrame;
  Frame Spare; ///< what was shown before: the next one is made in its memory
  int TheStep = 1;
  bool Complete = false;
  FrameCost Cost;
  FrameSourceCounters& TheCounters;
  std::int64_t TheVersion = -1;
  std::int64_t TheTraceVersion = -1;
};
} // namespace pixelexact
