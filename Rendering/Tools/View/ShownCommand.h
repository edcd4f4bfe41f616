// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Report.h"
#include "Picture/RenderOptions.h"
#include "Picture/ShownWords.h"
#include "Scene/Shot.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pixelexact
{
/// Stores what a window shows: the words of its command line, and what differs from them.
struct ShownState
{
  std::vector<std::string> words;
  ShownNow now;

  /// Replaces the first word of the option, or adds one; removes all of them where there is no
  /// value.
  void Set(const std::string& option, const std::optional<std::string>& value);
  /// Removes a range of colours that was given or found, but not a rule as `field`.
  void ForgetRange();
};

/// The command line that a window shows, parsed and ready to be drawn. All fields of the input are
/// in the model.
class ShownCommand
{
public:
  /// Number of contours where the command line gives none.
  static constexpr int kDefaultContours = 10;

  /// `words`: of view, from PrepareWords; `largest`: size of a figure without --size. Without
  /// options of a camera the view is oblique and contains the mesh's box. Throws as Prepare, and
  /// UsageError for animations and --stride.
  ShownCommand(std::vector<std::string> words, const ImageSize& largest);
  ~ShownCommand();
  ShownCommand(const ShownCommand&) = delete;
  ShownCommand& operator=(const ShownCommand&) = delete;

  [[nodiscard]] const RenderOptions& Options() const;
  /// The shot of the picture in the figure.
  [[nodiscard]] Shot& GetShot() { return shot_; }
  [[nodiscard]] const Shot& GetShot() const { return shot_; }
  /// The state of the last Take. Members of `now` may be changed as the picture changes.
  [[nodiscard]] ShownState& State() { return State_; }

  /// Parses and prepares another state. Throws as Prepare and changes nothing then.
  void Take(ShownState state);
  /// Changes the size of the figure, in pixels.
  void Resize(int width, int height);
  /// Divides the figure for the view of the shot, which may have changed. Returns whether the
  /// picture in it changes.
  bool LayOut();

  /// The words of render for the figure, which it writes to a file.
  [[nodiscard]] std::vector<std::string> FigureWords(const std::string& output) const;
  /// The file of the next figure: --output, with a number after the first figure; without --output
  /// a name that no file has.
  [[nodiscard]] std::string NextName();
  /// A figure was saved under the next name.
  void CountFigure() { ++Saved; }

private:
  struct Parsed;
  [[nodiscard]] std::unique_ptr<Parsed> Parse(const std::vector<std::string>& words) const;
  [[nodiscard]] std::string NameOfFile(int number) const;

  Stopwatch Watch;
  std::string Output; ///< as given
  int Saved = 0;      ///< number of the next figure
  std::unique_ptr<Parsed> Parsed_;
  Shot shot_;
  ShownState State_;
};
} // namespace pixelexact
