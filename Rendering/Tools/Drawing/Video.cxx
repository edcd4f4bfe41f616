// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/Video.h"

#include "Core/Base/Error.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <vector>

namespace pixelexact
{
namespace
{
constexpr const char* kProgram = "ffmpeg";

bool IsThere(const std::string& program)
{
  const char* path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
  {
    if (access((std::filesystem::path(folder) / program).c_str(), X_OK) == 0)
    {
      return true;
    }
  }
  return false;
}
} // namespace

void Video::RequireProgram()
{
  if (!IsThere(kProgram))
  {
    throw Error("--output: a video needs the program ffmpeg, which is not there; install it, or "
                "number pictures, as cut_%04d.png");
  }
}

Video::Video(const std::string& file, int width, int height, double framesPerSecond)
  : File(file)
  , Beside((std::filesystem::path(file).parent_path() /
      (".part-" + std::filesystem::path(file).filename().string()))
             .string())
{
  RequireProgram();
  const bool webm = file.ends_with(".webm");
  std::vector<std::string> words{ kProgram, "-nostdin", "-hide_banner", "-loglevel", "error", "-y",
    "-f", "rawvideo", "-pix_fmt", "rgb24", "-s", fmt::format("{}x{}", width, height), "-r",
    fmt::format("{}", framesPerSecond), "-i", "pipe:0", "-vf",
    // These codecs have half the resolution for colours, so sides must be even.
    "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", "-c:v" };
  const std::vector<std::string> codec = webm
    ? std::vector<std::string>{ "libvpx-vp9", "-crf", "24", "-b:v", "0" }
    : std::vector<std::string>{ "libx264", "-crf", "16", "-movflags", "+faststart" };
  words.insert(words.end(), codec.begin(), codec.end());
  words.push_back(Beside);
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words)
  {
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);

  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0)
  {
    throw Error("cannot write '" + File + "': there is no pipe to ffmpeg");
  }
  // Without this, a write to an ffmpeg that ended would end this program.
  std::signal(SIGPIPE, SIG_IGN);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
  const int failure =
    posix_spawnp(&Process, kProgram, &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[0]);
  Pipe = fdopen(ends[1], "wb");
  if (failure != 0 || Pipe == nullptr)
  {
    throw Error("cannot write '" + File + "': ffmpeg does not start");
  }
}

Video::~Video()
{
  if (Pipe != nullptr)
  {
    (void)Wait();
    std::error_code ignored;
    std::filesystem::remove(Beside, ignored);
  }
}

int Video::Wait()
{
  std::fclose(Pipe);
  Pipe = nullptr;
  int status = 0;
  return waitpid(Process, &status, 0) == Process && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

void Video::Add(const Image& picture)
{
  const auto row = 3 * static_cast<std::size_t>(picture.width);
  for (int y = picture.height; y-- > 0;)
  {
    if (std::fwrite(&picture.pixels[row * static_cast<std::size_t>(y)], 1, row, Pipe) != row)
    {
      throw Error("cannot write '" + File + "': ffmpeg takes no more pictures; is there room?");
    }
  }
}

void Video::Close()
{
  const bool flushed = std::fflush(Pipe) == 0;
  const int status = Wait();
  std::error_code failure;
  if (flushed && status == 0)
  {
    std::filesystem::rename(Beside, File, failure);
  }
  if (!flushed || status != 0 || failure)
  {
    std::filesystem::remove(Beside, failure);
    throw Error(fmt::format(
      "cannot write '{}': ffmpeg ended with status {}; has it this codec, and is there room?", File,
      status));
  }
}
} // namespace pixelexact
