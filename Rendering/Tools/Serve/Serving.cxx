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

#include <algorithm>
#include <atomic>
#include <iostream>
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

/// SIGINT and SIGTERM, which end the server instead of the process.
class EndSignals
{
public:
  EndSignals()
  {
    sigemptyset(&Set);
    sigaddset(&Set, SIGINT);
    sigaddset(&Set, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &Set, nullptr);
  }
  ~EndSignals()
  {
    Ends = true;
    if (Thread.joinable())
    {
      Thread.join();
    }
  }
  EndSignals(const EndSignals&) = delete;
  EndSignals& operator=(const EndSignals&) = delete;

  void StopWith(PageServer& server)
  {
    Thread = std::thread(
      [this, &server]
      {
        constexpr timespec kWait{ 0, 200'000'000 };
        while (!Ends)
        {
          if (sigtimedwait(&Set, nullptr, &kWait) > 0)
          {
            server.Stop();
            return;
          }
        }
      });
  }

private:
  sigset_t Set{};
  std::atomic<bool> Ends = false;
  std::thread Thread;
};
} // namespace

void Serve(
  RenderOptions options, const ServingOptions& serving, const std::vector<std::string>& words)
{
  CheckServed(options);
  EndSignals signals;
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
  signals.StopWith(server);
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
