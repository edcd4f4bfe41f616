// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/Image.h"

#include <cstdio>
#include <string>

namespace pixelexact
{
/// A video that the program ffmpeg encodes from pictures as they are added: H.264 (.mp4) or VP9
/// (.webm), with colours at half the resolution and even numbers of pixels.
class Video
{
public:
  /// Throws Error where there is no ffmpeg.
  static void RequireProgram();

  /// The file appears when the video is complete. Throws Error as RequireProgram.
  Video(const std::string& file, int width, int height, double framesPerSecond);
  ~Video();
  Video(const Video&) = delete;
  Video& operator=(const Video&) = delete;

  /// Adds a picture of three channels. Throws Error where ffmpeg accepts no more.
  void Add(const Image& picture);
  /// Throws Error where ffmpeg failed.
  void Close();

private:
  /// Closes the pipe and waits for ffmpeg. Returns its exit status, -1 where it did not exit.
  int Wait();

  std::string File;
  std::string Beside; ///< temporary file until the video is complete
  int Process = -1;
  std::FILE* Pipe = nullptr;
};
} // namespace pixelexact
