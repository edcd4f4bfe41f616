// SPDX-License-Identifier: BSD-3-Clause
#include "Base/VtkMessages.h"

#include "Files/GridFiles.h"

#include <vtkCallbackCommand.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

namespace pixelexact
{
namespace
{
class RecordingWindow final : public vtkOutputWindow
{
public:
  static RecordingWindow* New();
  vtkTypeMacro(RecordingWindow, vtkOutputWindow);

  void DisplayText(const char* /*text*/) override {}
  void DisplayDebugText(const char* /*text*/) override {}
  void DisplayErrorText(const char* text) override { Keep(FirstError, text); }
  void DisplayGenericWarningText(const char* text) override { Keep(FirstGenericWarning, text); }
  void DisplayWarningText(const char* text) override
  {
    AddWarning(Warnings, text != nullptr ? text : "");
  }

  std::string FirstError;
  std::string FirstGenericWarning;
  std::vector<std::string> Warnings;

private:
  static void Keep(std::string& first, const char* text)
  {
    if (first.empty() && text != nullptr)
    {
      first = MessageEssence(text);
    }
  }
};
vtkStandardNewMacro(RecordingWindow);
} // namespace

VtkMessages::VtkMessages()
  : Before(vtkOutputWindow::GetInstance())
  , Recorder(vtkSmartPointer<RecordingWindow>::New())
{
  vtkOutputWindow::SetInstance(Recorder);
  // The same messages go to VTK's log as well, which prints them on stderr.
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

VtkMessages::~VtkMessages()
{
  vtkOutputWindow::SetInstance(Before);
}

std::string VtkMessages::FirstError() const
{
  return static_cast<RecordingWindow*>(Recorder.Get())->FirstError;
}

std::string VtkMessages::FirstGenericWarning() const
{
  return static_cast<RecordingWindow*>(Recorder.Get())->FirstGenericWarning;
}

std::vector<std::string> VtkMessages::Warnings() const
{
  return static_cast<RecordingWindow*>(Recorder.Get())->Warnings;
}

ErrorsOfObject::ErrorsOfObject(vtkObject& object)
  : Object(&object)
{
  vtkNew<vtkCallbackCommand> onError;
  onError->SetClientData(this);
  onError->SetCallback([](vtkObject*, unsigned long, void* self, void* text)
    { static_cast<ErrorsOfObject*>(self)->Keep(text); });
  Observer = Object->AddObserver(vtkCommand::ErrorEvent, onError);
}

ErrorsOfObject::~ErrorsOfObject()
{
  Object->RemoveObserver(Observer);
}

void ErrorsOfObject::Keep(void* text)
{
  if (first_.empty() && text != nullptr)
  {
    first_ = MessageEssence(static_cast<const char*>(text));
  }
}
} // namespace pixelexact
