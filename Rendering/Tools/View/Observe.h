// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkCallbackCommand.h>
#include <vtkNew.h>

#include <utility>

namespace pixelexact
{
/// Calls a function at an event; what it holds lives as long as the object.
template <class Function>
void Observe(vtkObject* object, unsigned long event, Function function)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(new Function(std::move(function)));
  command->SetClientDataDeleteCallback([](void* client) { delete static_cast<Function*>(client); });
  command->SetCallback(
    [](vtkObject*, unsigned long, void* client, void*) { (*static_cast<Function*>(client))(); });
  object->AddObserver(event, command);
}
} // namespace pixelexact
