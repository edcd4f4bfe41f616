// SPDX-License-Identifier: BSD-3-Clause
#include "View/RunTool.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>

namespace pixelexact
{
bool RunTool(const std::vector<std::string>& words)
{
  std::error_code ignored;
  const std::filesystem::path beside =
    std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path() / "pixelexact";
  std::vector<std::string> copies{ "pixelexact" };
  copies.insert(copies.end(), words.begin(), words.end());
  std::vector<char*> arguments;
  arguments.reserve(copies.size() + 1);
  for (std::string& word : copies)
  {
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);
  // Not --quiet, which the picture's file would name among the words of its command.
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t process = -1;
  int status = 0;
  const int failure =
    posix_spawnp(&process, std::filesystem::exists(beside) ? beside.c_str() : "pixelexact",
      &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return failure == 0 && waitpid(process, &status, 0) == process && WIFEXITED(status) &&
    WEXITSTATUS(status) == 0;
}
} // namespace pixelexact
