// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/Image.h"

#include <cstdio>
#include <string>

namespace pixelexact
{
/// A video that ffmpeg, a program of its own, makes of pictures as they come: H.264 (.mp4) or VP9
/// (.webm), with colours at half the resolution and an even number of pixels.
class Video
{
public:
  /// Throws Error where there is no ffmpeg.
  static void RequireProgram();

  /// The file is there when the video is whole. Throws Error as RequireProgram.
  Video(const std::string& file, int width, int height, double framesPerSecond);
  ~Video();
  Video(const Video&) = delete;
  Video& operator=(const Video&) = delete;

  /// Of three channels. Throws Error where ffmpeg takes no more.
  void Add(const Image& picture);
  /// Throws Error where ffmpeg failed.
  void Close();

private:
  /// What ffmpeg told; empty: nothing.
  int Wait();

  std::string File;
  std::string Beside; ///< while it is made
  int Process = -1;
  std::FILE* Pipe = nullptr;
};
} // namespace pixelexact
