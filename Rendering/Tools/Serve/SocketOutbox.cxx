// SPDX-License-Identifier: BSD-3-Clause
#include "Serve/SocketOutbox.h"

#include <libwebsockets.h>

#include <utility>

namespace pixelexact
{
SocketOutbox::SocketOutbox(lws_context* context)
  : Context(context)
{
}

void SocketOutbox::SendText(std::string text)
{
  const std::lock_guard lock(Mutex);
  Overfull = Overfull || Texts.size() >= kMaxTexts;
  Append(Texts, std::move(text));
}

void SocketOutbox::SendFrame(std::string bytes)
{
  const std::lock_guard lock(Mutex);
  Frames.clear();
  Append(Frames, std::move(bytes));
}

void SocketOutbox::SendFile(std::string bytes)
{
  const std::lock_guard lock(Mutex);
  Overfull = Overfull || !Files.empty();
  Append(Files, std::move(bytes));
}

bool SocketOutbox::HoldsFile()
{
  const std::lock_guard lock(Mutex);
  return !Files.empty();
}

std::optional<OutgoingMessage> SocketOutbox::Take()
{
  const std::lock_guard lock(Mutex);
  for (std::deque<std::string>* queue : { &Texts, &Files, &Frames })
  {
    if (!queue->empty())
    {
      OutgoingMessage next{ std::move(queue->front()), queue != &Texts };
      queue->pop_front();
      return next;
    }
  }
  return std::nullopt;
}

bool SocketOutbox::IsOverfull()
{
  const std::lock_guard lock(Mutex);
  return Overfull;
}

void SocketOutbox::Detach()
{
  const std::lock_guard lock(Mutex);
  Context = nullptr;
  Texts.clear();
  Frames.clear();
  Files.clear();
}

void SocketOutbox::Append(std::deque<std::string>& queue, std::string bytes)
{
  if (Context == nullptr)
  {
    return;
  }
  if (!Overfull)
  {
    queue.push_back(std::move(bytes));
  }
  lws_cancel_service(Context);
}
} // namespace pixelexact
