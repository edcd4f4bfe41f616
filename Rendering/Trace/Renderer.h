// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Appearance/Painter.h"
#include "Trace/FrameCost.h"
#include "Trace/ProgressiveFrame.h"
#include "Trace/TraceTile.h"
#include "Trace/View.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>

namespace pixelexact
{
/// How often each step was taken. Several renderers may count in the same counters.
struct RenderCounters
{
  std::int64_t traces = 0;
  std::int64_t colorings = 0;
};

/// The work of one call of Renderer::Render.
struct RenderWork
{
  /// Buffers of centres that the frame keeps beside those that drawing needs.
  Buffer buffers = Buffer::None;
  /// Time limit of tracing. A frame that takes longer is coarse, and each further call for the same
  /// rays refines it.
  double seconds = std::numeric_limits<double>::infinity();
  bool refine = true; ///< whether a coarse frame of the same rays is refined
  /// The ranges of the fields, kept as long as these stay the same; null: they are found for each
  /// frame.
  std::shared_ptr<FieldRanges> ranges;
};

/// Frames of views for whoever shows them. Keeps the last frame and takes only the steps whose
/// inputs changed: another colour table repaints, another camera or scene traces, an equal view
/// does neither. Not for use by several threads at once.
class Renderer
{
public:
  /// Draws the labels of contours on a frame; Painter::Labels has their height.
  using LabelWriter = std::function<void(Frame&, const Camera&, const Painter&)>;

  /// `counters` must outlive this. `labels`: null: no labels are drawn.
  explicit Renderer(RenderCounters& counters, LabelWriter labels = nullptr);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// The view's frame, valid until the next call. An aborted frame (see Progress) lacks tiles and
  /// is traced by the next call; a coarse one (RenderWork::seconds) has only some of the pixels
  /// (LastStep). Throws Error, after which there is no frame.
  const Frame& Render(const View& view, const RenderWork& work = {}, const Progress& progress = {});

  /// Samples of the view at `positions` alone, with the usual buffers and colours; those of a
  /// pixel's centre are the pixel's, bit for bit. There is no frame afterwards. Throws Error.
  /// `ranges`: as RenderWork::ranges.
  SampleBuffers Sample(const View& view, std::span<const ImagePosition> positions,
    std::shared_ptr<FieldRanges> ranges = nullptr);

  /// The last frame, complete and with all of its buffers: traced once more where it lacks some.
  /// Null when there is none.
  const Frame* FrameWithAllBuffers();

  /// The last frame, null when there is none or it failed.
  [[nodiscard]] const Frame* LastFrame() const { return Shown ? &*Shown : nullptr; }

  /// Pixels between those of the last frame, which has only every so many-th of each row and
  /// column; 1: all of them.
  [[nodiscard]] int LastStep() const { return Step; }

  /// Whether there is one, neither coarse nor aborted.
  [[nodiscard]] bool IsComplete() const { return Shown && Complete; }

  /// The contours of the last frame's pixels; null where there are none, or only a coarse frame.
  [[nodiscard]] const ContourCertifier* LastContours() const
  {
    return IsComplete() ? Paints->Contours() : nullptr;
  }
  /// The view of the last frame, and its colours and contours in numbers.
  [[nodiscard]] const View& LastView() const { return Current; }
  [[nodiscard]] const ResolvedAppearance& LastResolved() const { return Resolved; }

  /// Differs whenever pixels may differ from those seen before, of this renderer or another that
  /// counts in the same counters.
  [[nodiscard]] std::int64_t Version() const { return LastVersion; }
  /// Differs whenever positions may.
  [[nodiscard]] std::int64_t TraceVersion() const { return LastTraceVersion; }

  /// Forgets view and frame.
  void DropFrame();

private:
  void Update(const View& view, const RenderWork& work, const Progress& progress);
  /// Ranges, iso-values and modules of the view's appearance. `frame`: of its values; null: there
  /// is none yet.
  void MakePainter(const Frame* frame);
  /// The pipeline of a frame while it is traced: without ranges that follow from its values.
  [[nodiscard]] Pipeline TracingPipeline();
  /// Paints what is there, the complete frame or a coarse one, in the view's appearance.
  void Paint();
  void BeginFrame(Buffer buffers);
  void TraceFrame(double seconds, const Progress& progress);
  void TraceBlocks(Buffer buffers, const Progress& progress);
  void ShowPreview();
  void WriteLabels();
  void Count(bool traced);
  void Forget();
  [[nodiscard]] Buffer AllBuffers() const;

  View Current;
  bool HasRays = false; ///< whether Current is what the frame, or Passes, are traced for
  std::shared_ptr<FieldRanges> Ranges;
  std::shared_ptr<ContourBounds> Bounds; ///< of the view's fields, for contours
  Buffer Buffers = Buffer::None;         ///< that the frame is traced with
  ResolvedAppearance Resolved;
  std::unique_ptr<Painter> Paints;        ///< of Current.appearance; null: of none
  std::optional<ProgressiveFrame> Passes; ///< of a frame that is not complete
  std::optional<int> Previewed;           ///< the step of Passes that Shown is a preview of
  std::optional<Frame> Shown;
  Frame Spare; ///< the frame before, whose memory the next one takes
  int Step = 1;
  bool Complete = false;
  FrameCost Cost;
  RenderCounters& Counters;
  LabelWriter Labels;
  std::int64_t LastVersion = -1;
  std::int64_t LastTraceVersion = -1;
};
} // namespace pixelexact
