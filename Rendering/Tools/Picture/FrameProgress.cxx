// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/FrameProgress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <iostream>
#include <utility>

namespace pixelexact
{
FrameProgress::FrameProgress(std::string what, int frames)
  : What(std::move(what))
  , Frames(frames)
  , Terminal(isatty(STDERR_FILENO) != 0)
{
}

FrameProgress::~FrameProgress()
{
  if (Terminal)
  {
    std::cerr << "\r\033[K" << std::flush;
  }
}

void FrameProgress::Tell(int done, int made) const
{
  if (!Terminal)
  {
    return;
  }
  std::cerr << fmt::format("\r\033[K{} {} of {}", What, done + 1, Frames);
  if (made > 0)
  {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - Begin;
    const double left = passed.count() / made * (Frames - done);
    std::cerr << (left < 90.0 ? fmt::format(", {:.0f} s left", left)
                              : fmt::format(", {:.0f} min left", left / 60.0));
  }
  std::cerr << std::flush;
}
} // namespace pixelexact
