// SPDX-License-Identifier: BSD-3-Clause
#include "Serve/Drawer.h"

#include "Serve/ServedInput.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace pixelexact
{
namespace
{
class ViewClient final : public PageClient
{
public:
  explicit ViewClient(std::shared_ptr<ServedView> view)
    : View(std::move(view))
  {
  }
  ~ViewClient() override { View->Leave(); }
  ViewClient(const ViewClient&) = delete;
  ViewClient& operator=(const ViewClient&) = delete;

  bool Receive(const std::string& text) override { return View->Post(text); }

private:
  std::shared_ptr<ServedView> View;
};
} // namespace

Drawer::Drawer(ServedInput& input)
  : Input(input)
  , Files([this] { Wake(); })
  , Thread([this] { Run(); })
{
}

Drawer::~Drawer()
{
  {
    const std::lock_guard lock(Mutex);
    Ends = true;
    // Ends what is being traced.
    std::ranges::for_each(Views, [](const auto& view) { view->Leave(); });
  }
  Condition.notify_all();
  Thread.join();
}

std::unique_ptr<PageClient> Drawer::Open(
  const std::vector<std::string>& words, std::shared_ptr<Outbox> outbox)
{
  auto opened = std::make_shared<ServedView>(words, std::move(outbox), [this] { Wake(); });
  {
    const std::lock_guard lock(Mutex);
    Views.push_back(opened);
  }
  return std::make_unique<ViewClient>(std::move(opened));
}

void Drawer::Wake()
{
  {
    const std::lock_guard lock(Mutex);
    Woken = true;
  }
  Condition.notify_all();
}

std::shared_ptr<ServedView> Drawer::Next()
{
  std::unique_lock lock(Mutex);
  Woken = false;
  std::erase_if(Views, [](const auto& view) { return view->HasLeft(); });
  std::shared_ptr<ServedView> chosen;
  const std::size_t first = Turn;
  auto best = std::pair{ ServedView::Work::Nothing, ServedView::Clock::time_point::max() };
  for (std::size_t k = 0; k < Views.size(); ++k)
  {
    const auto& view = Views[(first + k) % Views.size()];
    if (const auto next = view->Next(Files); next < best)
    {
      best = next;
      chosen = view;
      Turn = (first + k + 1) % Views.size();
    }
  }
  if (chosen && best.second <= ServedView::Clock::now())
  {
    return chosen;
  }
  const auto isWoken = [this] { return Woken || Ends; };
  if (chosen)
  {
    Condition.wait_until(lock, best.second, isWoken);
  }
  else
  {
    // Without work, views of browsers that left are removed soon, and files follow that were sent.
    Condition.wait_for(lock, std::chrono::seconds(1), isWoken);
  }
  return nullptr;
}

bool Drawer::AreOthersChanged(const ServedView* view)
{
  const std::lock_guard lock(Mutex);
  return std::ranges::any_of(Views,
    [this, view](const auto& other)
    { return other.get() != view && other->Next(Files).first == ServedView::Work::Change; });
}

void Drawer::Run()
{
  while (true)
  {
    {
      const std::lock_guard lock(Mutex);
      if (Ends)
      {
        return;
      }
    }
    if (const std::shared_ptr<ServedView> view = Next())
    {
      view->Perform(Input, Files, [this, &view] { return AreOthersChanged(view.get()); });
    }
  }
}
} // namespace pixelexact
