// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/ReaderMessages.h"

#include "vtkXMLReader.h"

#include <algorithm>

namespace pixelexact
{
void ReaderMessages::Execute(vtkObject* /*caller*/, unsigned long event, void* data)
{
  const std::string_view message = data ? static_cast<const char*>(data) : "";
  if (event == vtkCommand::WarningEvent)
  {
    AddWarning(warnings, message);
  }
  else if (error.empty())
  {
    error = MessageEssence(message);
  }
}

void ReaderMessages::Watch(vtkXMLReader* reader)
{
  reader->SetReaderErrorObserver(this);
  reader->SetParserErrorObserver(this);
  reader->AddObserver(vtkCommand::WarningEvent, this);
}

std::string MessageEssence(std::string_view text)
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

void AddWarning(std::vector<std::string>& lines, std::string_view text)
{
  const std::string essence = MessageEssence(text);
  if (!essence.starts_with("Could not locate key vtkExodusIIReader::"))
  {
    AddOnce(lines, essence);
  }
}

void AddOnce(std::vector<std::string>& lines, const std::string& line)
{
  if (std::ranges::find(lines, line) == lines.end())
  {
    lines.push_back(line);
  }
}
} // namespace pixelexact
