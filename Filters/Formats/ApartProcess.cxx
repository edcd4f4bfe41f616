// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/ApartProcess.h"

#include "Core/Base/Error.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

namespace pixelexact
{
namespace
{
// The first letter of what the process reports.
constexpr char kDone = '+';
constexpr char kFailed = '-';
constexpr char kNoMemory = 'm';
/// Grace factor: waiting for a disk or for other processes does not end the process.
constexpr unsigned kPatience = 20; ///< seconds for one of processor time

/// Bytes of address space that this process has; 0: not known.
std::size_t AddressSpace()
{
  std::size_t pages = 0;
  if (std::FILE* file = std::fopen("/proc/self/statm", "re"))
  {
    if (std::fscanf(file, "%zu", &pages) != 1)
    {
      pages = 0;
    }
    std::fclose(file);
  }
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

void Restrict(int resource, rlim_t most)
{
  struct rlimit limit
  {
  };
  if (getrlimit(resource, &limit) == 0)
  {
    limit.rlim_cur =
      limit.rlim_max == RLIM_INFINITY || most < limit.rlim_max ? most : limit.rlim_max;
    setrlimit(resource, &limit);
  }
}

void Write(int pipe, char letter, const char* text)
{
  const std::string report = letter + std::string(text);
  std::size_t at = 0;
  while (at < report.size())
  {
    const ssize_t written = write(pipe, report.data() + at, report.size() - at);
    if (written < 0 && errno != EINTR)
    {
      return;
    }
    at += written > 0 ? static_cast<std::size_t>(written) : 0;
  }
}

/// Ends the copied process without the functions that libraries registered for the program's end.
void EndWithoutReport()
{
  _exit(1);
}

[[noreturn]] void RunInCopy(
  const ApartLimits& limits, std::size_t before, int pipe, const std::function<void()>& work)
{
  for (const int signal : { SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTERM, SIGXCPU, SIGPIPE })
  {
    std::signal(signal, SIG_DFL);
  }
  std::atexit(&EndWithoutReport);
  const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC);
  for (const int stream : { STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO })
  {
    dup2(nowhere, stream);
  }
  Restrict(RLIMIT_CORE, 0);
  Restrict(RLIMIT_CPU, limits.seconds);
  if (before > 0)
  {
    Restrict(RLIMIT_AS, before + limits.bytes);
  }
  try
  {
    work();
    Write(pipe, kDone, "");
  }
  catch (const std::bad_alloc&)
  {
    Write(pipe, kNoMemory, "");
  }
  catch (const std::exception& error)
  {
    Write(pipe, kFailed, error.what());
  }
  _exit(0);
}

/// Returns what the copied process wrote; empty where it did not end within `seconds`.
std::string ReadReport(int pipe, unsigned seconds)
{
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::seconds(seconds);
  std::string report;
  for (;;)
  {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now()).count();
    struct pollfd waited
    {
      pipe, POLLIN, 0
    };
    const int ready = left > 0 ? poll(&waited, 1, static_cast<int>(left)) : 0;
    if (ready < 0 && errno == EINTR)
    {
      continue;
    }
    if (ready <= 0)
    {
      return {};
    }
    std::array<char, 4096> some{};
    const ssize_t got = read(pipe, some.data(), some.size());
    if (got < 0 && errno == EINTR)
    {
      continue;
    }
    if (got <= 0)
    {
      return report;
    }
    report.append(some.data(), static_cast<std::size_t>(got));
  }
}
} // namespace

ApartLimits LimitsForFile(std::size_t bytes)
{
  // Room for 4-byte numbers that become 8-byte ones, for copies of arrays, and for the library's
  // own data.
  constexpr std::size_t kEach = 16;
  constexpr std::size_t kBytes = std::size_t{ 512 } << 20U;
  constexpr std::size_t kBytesInSecond = std::size_t{ 1 } << 22U;
  constexpr unsigned kSeconds = 10;
  return { kBytes + kEach * bytes, kSeconds + static_cast<unsigned>(bytes / kBytesInSecond) };
}

void RunApart(const ApartLimits& limits, const std::string& what, const std::function<void()>& work)
{
  const auto cannotStart = [&]
  {
    return Error("no process could be started in which " + what +
      " reads it: " + std::strerror(errno) + "; free memory, or raise the limit of processes");
  };
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0)
  {
    throw cannotStart();
  }
  const std::size_t before = AddressSpace();
  const pid_t process = fork();
  if (process < 0)
  {
    close(ends[0]);
    close(ends[1]);
    throw cannotStart();
  }
  if (process == 0)
  {
    close(ends[0]);
    RunInCopy(limits, before, ends[1], work);
  }
  close(ends[1]);
  const std::string report = ReadReport(ends[0], kPatience * limits.seconds);
  close(ends[0]);
  if (report.empty())
  {
    kill(process, SIGKILL);
  }
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR)
  {
  }
  if (report.empty())
  {
    throw InvalidData(what +
      " ended, crashed or did not come to an end; the file is damaged or cut "
      "short: copy it again");
  }
  if (report.front() == kNoMemory)
  {
    throw InvalidData(what +
      " asks for more memory than the file can hold; the file is damaged: "
      "copy it again");
  }
  if (report.front() == kFailed)
  {
    throw Error(report.substr(1));
  }
}
} // namespace pixelexact
