// SPDX-License-Identifier: BSD-3-Clause
#include "VtkMessages.h"

#include <vtkLogger.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <string_view>

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
  void DisplayWarningText(const char* text) override { Keep(FirstWarning, text); }
  void DisplayGenericWarningText(const char* text) override { Keep(FirstWarning, text); }

  std::string FirstError;
  std::string FirstWarning;

private:
  static void Keep(std::string& first, const char* text)
  {
    if (first.empty() && text != nullptr)
    {
      first = text;
    }
  }
};
vtkStandardNewMacro(RecordingWindow);

/// "ERROR: In x.cxx, line 7\nvtkReader (0x5581): Cannot read." becomes "Cannot read.", on one line.
std::string Essence(std::string_view text)
{
  if (const auto line = text.find('\n'); line != std::string_view::npos)
  {
    text.remove_prefix(line + 1);
  }
  if (const auto object = text.find("): "); object != std::string_view::npos)
  {
    text.remove_prefix(object + 3);
  }
  std::string essence;
  for (const char c : text)
  {
    const bool space = c == '\n' || c == '\r' || c == '\t' || c == ' ';
    if (!space)
    {
      essence += c;
    }
    else if (!essence.empty() && essence.back() != ' ')
    {
      essence += ' ';
    }
  }
  while (!essence.empty() && (essence.back() == ' ' || essence.back() == '.'))
  {
    essence.pop_back();
  }
  return essence;
}
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
  return Essence(static_cast<RecordingWindow*>(Recorder.Get())->FirstError);
}

std::string VtkMessages::FirstWarning() const
{
  return Essence(static_cast<RecordingWindow*>(Recorder.Get())->FirstWarning);
}
} // namespace pixelexact
