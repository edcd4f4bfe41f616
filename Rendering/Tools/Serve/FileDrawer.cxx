// SPDX-License-Identifier: BSD-3-Clause
#include "Serve/FileDrawer.h"

#include "Base/Report.h"
#include "Picture/DrawnShot.h"
#include "Picture/PictureFile.h"
#include "Serve/PageServer.h"
#include "Serve/ServedMessages.h"

#include <sys/resource.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <exception>
#include <string_view>
#include <utility>

namespace pixelexact
{
bool IsSavedSuffix(const std::string& suffix)
{
  constexpr std::array<std::string_view, 6> kSuffixes{ "png", "tif", "jpg", "svg", "pdf", "vti" };
  return std::ranges::find(kSuffixes, suffix) != kSuffixes.end();
}

FileDrawer::FileDrawer(std::function<void()> done)
  : OnDone(std::move(done))
  , Thread([this] { Run(); })
{
}

FileDrawer::~FileDrawer()
{
  {
    const std::lock_guard lock(Mutex);
    Ends = true;
  }
  Condition.notify_all();
  Thread.join();
}

bool FileDrawer::IsIdle()
{
  const std::lock_guard lock(Mutex);
  return Current == nullptr;
}

void FileDrawer::Begin(FileRequest file, std::unique_ptr<ServedScene> scene,
  std::shared_ptr<Outbox> browser, std::function<bool()> hasLeft)
{
  {
    const std::lock_guard lock(Mutex);
    Current = std::make_unique<Job>(
      Job{ std::move(file), std::move(scene), std::move(browser), std::move(hasLeft) });
  }
  Condition.notify_all();
}

void FileDrawer::Run()
{
  // Linux has a priority of each thread. Stages that are not parallel give way by it.
  constexpr int kNice = 10;
  (void)setpriority(PRIO_PROCESS, 0, kNice);
  // Worker threads leave this arena when pictures need them.
  tbb::task_arena arena(tbb::task_arena::automatic, 1, tbb::task_arena::priority::low);
  while (true)
  {
    const Job* job = nullptr;
    {
      std::unique_lock lock(Mutex);
      Condition.wait(lock, [this] { return Ends || Current != nullptr; });
      if (Ends)
      {
        return;
      }
      job = Current.get();
    }
    try
    {
      arena.execute([this, job] { Draw(*job); });
    }
    catch (const Interrupted&)
    {
      // Nobody waits for the file.
    }
    catch (const std::exception& error)
    {
      // Without options, because those of the page are still drawn.
      job->browser->SendText(TextMessage({ { "kind", "failure" }, { "text", error.what() } }));
    }
    std::unique_ptr<Job> done;
    {
      const std::lock_guard lock(Mutex);
      done = std::move(Current);
    }
    done.reset(); // the scene may be large
    OnDone();
  }
}

void FileDrawer::Draw(const Job& job)
{
  const auto isWanted = [this, &job]
  {
    const std::lock_guard lock(Mutex);
    return !Ends && !job.hasLeft();
  };
  const FileRequest& file = job.file;
  const RenderOptions& options = job.scene->GetOptions();
  const Shot& shot = job.scene->GetShot();
  const bool paths = file.suffix == "svg" || file.suffix == "pdf";
  Frame traced = TraceShot(options, shot, [&](double) { return isWanted(); });
  if (!isWanted())
  {
    return;
  }
  const DrawnShot drawn(options, shot, std::move(traced), paths, isWanted);
  if (!isWanted())
  {
    return;
  }
  const RepeatedCommand command{ file.words, {} };
  const std::string name = file.stem + file.suffix;
  Stopwatch watch;
  nlohmann::ordered_json header{ { "kind", "file" }, { "name", name },
    { "command", command.Text() } };
  job.browser->SendFile(BinaryMessage(header,
    file.IsBuffers() ? EncodeBuffersOf(options, shot, drawn, name)
                     : EncodePicture(options, drawn, file.Picture(), command, watch)));
}
} // namespace pixelexact
