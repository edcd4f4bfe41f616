// SPDX-License-Identifier: BSD-3-Clause
#include "Serve/Serving.h"

#include "Base/Command.h"
#include "Base/Report.h"
#include "Picture/ShownWords.h"
#include "Serve/Access.h"
#include "Serve/Drawer.h"
#include "Serve/PageServer.h"
#include "Serve/PageWords.h"
#include "Serve/ServedInput.h"
#include "Serve/ServedScene.h"

#include "Core/Base/Error.h"

#include <csignal>
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <mutex>
#include <thread>
#include <utility>

namespace pixelexact
{
namespace
{
constexpr const char* kPage =
#include "Page.inc"
  ;

void CheckServed(const RenderOptions& options)
{
  if (options.animation.IsAsked(options.shot.input))
  {
    throw UsageError("serve shows one picture; leave out --sweep, --turn and --time-step all");
  }
  if (options.quality.Stride() > 1)
  {
    throw UsageError("serve draws coarse pictures while one is moved, and then all pixels; leave "
                     "out --stride");
  }
  if (!options.buffers.File().empty() || !options.lines.file.empty())
  {
    throw UsageError("serve writes no files: pages save what they show; leave out --buffers and "
                     "--contours-output");
  }
}

/// The words of the picture, with what the program chose.
std::vector<std::string> WholeWords(const std::vector<std::string>& words, ServedInput& input)
{
  std::vector<std::string> whole = WordsOfPicture(words);
  const ServedScene first(WithoutFigure(whole), "view.png", input);
  const std::vector<std::string>& chosen = first.GetShot().chosen;
  std::vector<std::string> added;
  for (const std::string& word : chosen)
  {
    // An option's value may follow it.
    if (!added.empty() && OptionOf(word).empty())
    {
      added.back() += "=" + word;
    }
    else
    {
      added.push_back(word);
    }
  }
  whole.insert(std::ranges::find(whole, "--"), added.begin(), added.end());
  return whole;
}

/// Whether standard input has ended. Discards what it has.
bool HasInputEnded()
{
  pollfd input{ STDIN_FILENO, POLLIN, 0 };
  if (poll(&input, 1, 0) <= 0)
  {
    return false;
  }
  std::array<char, 256> discarded{};
  return read(STDIN_FILENO, discarded.data(), discarded.size()) <= 0;
}

/// SIGINT and SIGTERM, and where it is wanted the end of standard input, which is as SIGTERM. While
/// the input is read they end the process, with a message. Once there is a server they stop it; the
/// process ends at the latest kPatience later, or at the next signal.
class EndSignals
{
public:
  static constexpr std::chrono::seconds kPatience{ 3 };

  explicit EndSignals(bool withInput)
    : WithInput(withInput)
  {
    sigemptyset(&Set);
    sigaddset(&Set, SIGINT);
    sigaddset(&Set, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &Set, nullptr);
    Thread = std::thread([this] { Run(); });
  }
  ~EndSignals()
  {
    Ends = true;
    Thread.join();
  }
  EndSignals(const EndSignals&) = delete;
  EndSignals& operator=(const EndSignals&) = delete;

  /// Lets signals stop the server during its lifetime.
  class Stopping
  {
  public:
    Stopping(EndSignals& signals, PageServer& server)
      : Signals(signals)
    {
      Signals.SetServer(&server);
    }
    ~Stopping() { Signals.SetServer(nullptr); }
    Stopping(const Stopping&) = delete;
    Stopping& operator=(const Stopping&) = delete;

  private:
    EndSignals& Signals;
  };

private:
  using Clock = std::chrono::steady_clock;

  void SetServer(PageServer* server)
  {
    const std::lock_guard lock(Mutex);
    IsServing = true;
    Server = server;
  }

  /// Returns the signal, or 0 after a fifth of a second.
  int Wait()
  {
    constexpr timespec kWait{ 0, 200'000'000 };
    const int signal = std::max(0, sigtimedwait(&Set, nullptr, &kWait));
    return signal == 0 && WithInput && HasInputEnded() ? SIGTERM : signal;
  }

  void Run()
  {
    int signal = 0;
    while (signal == 0)
    {
      if (Ends)
      {
        return;
      }
      signal = Wait();
    }
    StopServing(signal);
    WithInput = false;
    const auto end = Clock::now() + kPatience;
    while (!Ends)
    {
      if (Wait() > 0 || Clock::now() >= end)
      {
        std::_Exit(EXIT_SUCCESS); // without the end of the picture that is drawn
      }
    }
  }

  void StopServing(int signal)
  {
    const std::lock_guard lock(Mutex);
    if (!IsServing)
    {
      std::cerr << fmt::format(
                     "pixelexact: serve: ended by {} while it read the input; no page was "
                     "served",
                     signal == SIGINT ? "SIGINT" : "SIGTERM")
                << std::endl;
      std::signal(signal, SIG_DFL);
      pthread_sigmask(SIG_UNBLOCK, &Set, nullptr);
      std::raise(signal);
    }
    if (Server != nullptr)
    {
      Server->Stop();
    }
  }

  bool WithInput;
  sigset_t Set{};
  std::atomic<bool> Ends = false;
  std::mutex Mutex; ///< of the next two members
  bool IsServing = false;
  PageServer* Server = nullptr; ///< null: not yet, or no longer
  std::thread Thread;
};
} // namespace

void Serve(
  RenderOptions options, const ServingOptions& serving, const std::vector<std::string>& words)
{
  CheckServed(options);
  EndSignals signals(serving.untilInputEnds);
  options.Check("view.png");
  ServedInput input(options.shot.input);
  const std::vector<std::string> whole = WholeWords(words, input);
  Drawer drawer(input);
  PageServer::Settings settings;
  const bool isLocal = serving.address.empty() || serving.address == "localhost";
  settings.address = isLocal ? "127.0.0.1" : serving.address;
  settings.port = serving.port;
  settings.clients = serving.views;
  settings.token = MakeToken();
  settings.page = kPage;
  settings.connect = [&](std::shared_ptr<Outbox> outbox)
  { return drawer.Open(whole, std::move(outbox)); };
  const std::string token = settings.token;
  const std::string address = settings.address;
  PageServer server(std::move(settings));
  const EndSignals::Stopping stopping(signals, server);
  const std::string host = address.find(':') != std::string::npos ? "[" + address + "]" : address;
  std::cout << fmt::format("http://{}:{}/?token={}", host, server.Port(), token) << std::endl;
  Note(IsLoopback(address)
      ? fmt::format("from another machine: ssh -L {0}:localhost:{0} THIS_MACHINE, then the same "
                    "address there; Ctrl+C ends it",
          server.Port())
      : "the address is reached from other machines, and what it sends is not encrypted; Ctrl+C "
        "ends it");
  BeQuiet(true); // of notes that each picture would repeat
  server.Run();
}
} // namespace pixelexact
