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
/// Counts of steps taken. Several renderers may share the counters.
struct RenderCounters
{
  std::int64_t traces = 0;
  std::int64_t colorings = 0;
};

/// Options of one call of Renderer::Render.
struct RenderWork
{
  /// Buffers of centres that the frame keeps in addition to those that drawing needs.
  Buffer buffers = Buffer::None;
  /// Time limit of tracing. A frame that takes longer is coarse, and each further call for the same
  /// rays refines it.
  double seconds = std::numeric_limits<double>::infinity();
  bool refine = true; ///< refines a coarse frame of the same rays
  /// The ranges of the fields, which stay valid while the object is the same; null: they are
  /// computed for each frame.
  std::shared_ptr<FieldRanges> ranges;
};

/// Draws frames of views. Keeps the last frame and takes only the steps whose inputs changed:
/// another colour table repaints, another camera or scene traces, an equal view does neither. An
/// object serves one thread at a time.
class Renderer
{
public:
  /// Draws the labels of contours on a frame; Painter::Labels has their height.
  using LabelWriter = std::function<void(Frame&, const Camera&, const Painter&)>;

  /// `counters` must outlive the object. `labels` null: no labels are drawn.
  explicit Renderer(RenderCounters& counters, LabelWriter labels = nullptr);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// The view's frame, valid until the next call. An aborted frame (see Progress) lacks tiles, and
  /// the next call traces it. A coarse frame (RenderWork::seconds) has every LastStep()-th pixel.
  /// Throws Error; then there is no frame.
  const Frame& Render(const View& view, const RenderWork& work = {}, const Progress& progress = {});

  /// Samples of the view at `positions`, with the usual buffers and colours. A sample at a pixel's
  /// centre equals the pixel's, bit for bit. Discards the last frame. Throws Error. `ranges`: as
  /// RenderWork::ranges.
  SampleBuffers Sample(const View& view, std::span<const ImagePosition> positions,
    std::shared_ptr<FieldRanges> ranges = nullptr);

  /// The last frame, complete and with all of its buffers. It is traced a second time if it lacks
  /// some. Null if there is none.
  const Frame* FrameWithAllBuffers();

  /// The last frame; null if there is none or it failed.
  [[nodiscard]] const Frame* LastFrame() const { return Shown ? &*Shown : nullptr; }

  /// Distance of the last frame's pixels in both directions; 1: the frame has all pixels.
  [[nodiscard]] int LastStep() const { return Step; }

  /// There is a last frame, and it is neither coarse nor aborted.
  [[nodiscard]] bool IsComplete() const { return Shown && Complete; }

  /// The contours of the last frame's pixels; null if there are none, or only a coarse frame.
  [[nodiscard]] const ContourCertifier* LastContours() const
  {
    return IsComplete() ? Paints->Contours() : nullptr;
  }
  /// The view of the last frame, and its colours and contours in numbers.
  [[nodiscard]] const View& LastView() const { return Current; }
  [[nodiscard]] const ResolvedAppearance& LastResolved() const { return Resolved; }

  /// Differs whenever pixels may differ from earlier frames of this renderer, or of another that
  /// shares the counters.
  [[nodiscard]] std::int64_t Version() const { return LastVersion; }
  /// Differs whenever positions of pixels may differ.
  [[nodiscard]] std::int64_t TraceVersion() const { return LastTraceVersion; }

  /// Discards view and frame.
  void DropFrame();

private:
  void Update(const View& view, const RenderWork& work, const Progress& progress);
  /// Resolves the view's appearance and creates its modules. `frame`: for rules that depend on its
  /// values; null: there is no frame yet.
  void MakePainter(const Frame* frame);
  /// The pipeline of a frame while it is traced: empty if ranges depend on the frame's values.
  [[nodiscard]] Pipeline TracingPipeline();
  /// Paints the complete or coarse frame with the view's appearance.
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
  bool HasRays = false; ///< the frame, or Passes, are traced for Current
  std::shared_ptr<FieldRanges> Ranges;
  std::shared_ptr<ContourBounds> Bounds; ///< of the view's fields, for contours
  Buffer Buffers = Buffer::None;         ///< that the frame is traced with
  ResolvedAppearance Resolved;
  std::unique_ptr<Painter> Paints;        ///< of Current.appearance; null: there is none
  std::optional<ProgressiveFrame> Passes; ///< of an incomplete frame
  std::optional<int> Previewed;           ///< step of Passes that Shown previews
  std::optional<Frame> Shown;
  Frame Spare; ///< the previous frame; the next one reuses its memory
  int Step = 1;
  bool Complete = false;
  FrameCost Cost;
  RenderCounters& Counters;
  LabelWriter Labels;
  std::int64_t LastVersion = -1;
  std::int64_t LastTraceVersion = -1;
};
} // namespace pixelexact
