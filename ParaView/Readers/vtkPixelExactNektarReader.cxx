// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPixelExactNektarReader.h"

#include "FilesBeside.h"
#include "vtkNektarReader.h"

#include "Core/Base/Error.h"
#include "Formats/Nektar/Files/FileParts.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <iterator>
#include <system_error>

vtkStandardNewMacro(vtkPixelExactNektarReader);

namespace
{
bool Exists(const std::filesystem::path& file)
{
  std::error_code failure;
  return std::filesystem::exists(file, failure);
}

/// Throws pixelexact::InvalidData.
std::string SessionOf(const std::filesystem::path& fields)
{
  std::filesystem::path session = fields;
  session.replace_filename(pixelexact::WithoutNumber(fields.stem()) + ".xml");
  if (!Exists(session))
  {
    throw pixelexact::InvalidData(fields.string() + ": its session is looked for in " +
      session.string() + ", which is not there; name it under Session Files");
  }
  return session;
}

std::vector<std::string> FieldsOf(const std::filesystem::path& session)
{
  std::filesystem::path fields = session;
  if (Exists(fields.replace_extension(".fld")))
  {
    return { fields };
  }
  const std::string stem = session.stem();
  std::vector<std::filesystem::path> steps;
  std::ranges::copy_if(pixelexact::FilesBeside(session, ".chk"), std::back_inserter(steps),
    [&](const auto& file) { return pixelexact::NumberBehind(file.stem(), stem) >= 0; });
  std::ranges::sort(
    steps, {}, [&](const auto& file) { return pixelexact::NumberBehind(file.stem(), stem); });
  if (steps.empty() && Exists(fields.replace_extension(".rst")))
  {
    steps.push_back(fields);
  }
  return { steps.begin(), steps.end() };
}

void Append(std::vector<std::string>& names, const char* name)
{
  if (name != nullptr && name[0] != '\0')
  {
    names.emplace_back(name);
  }
}
} // namespace

//------------------------------------------------------------------------------
vtkPixelExactNektarReader::vtkPixelExactNektarReader() = default;

//------------------------------------------------------------------------------
vtkPixelExactNektarReader::~vtkPixelExactNektarReader() = default;

//------------------------------------------------------------------------------
void vtkPixelExactNektarReader::AddSessionFileName(const char* name)
{
  Append(this->Sessions, name);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPixelExactNektarReader::RemoveAllSessionFileNames()
{
  this->Sessions.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPixelExactNektarReader::AddFieldFileName(const char* name)
{
  Append(this->FieldFiles, name);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPixelExactNektarReader::RemoveAllFieldFileNames()
{
  this->FieldFiles.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkPixelExactNektarReader::CanReadFile(const char* name)
{
  return this->Reader->CanReadFile(name);
}

//------------------------------------------------------------------------------
vtkAlgorithm* vtkPixelExactNektarReader::GetSource()
{
  return this->Reader;
}

//------------------------------------------------------------------------------
void vtkPixelExactNektarReader::Prepare()
{
  std::vector<std::string> sessions = this->Sessions;
  std::vector<std::string> fields = this->FieldFiles;
  for (const std::string& file : this->FileNames)
  {
    const bool isSession = std::filesystem::path(file).extension() == ".xml";
    std::vector<std::string>& files = isSession ? sessions : fields;
    if ((isSession ? this->Sessions : this->FieldFiles).empty())
    {
      files.push_back(file);
    }
  }
  if (sessions.empty())
  {
    sessions.push_back(SessionOf(fields.front()));
  }
  if (fields.empty())
  {
    fields = FieldsOf(sessions.front());
  }

  this->Reader->SetFileName(sessions.front().c_str());
  this->Reader->ClearSessionFileNames();
  std::for_each(sessions.begin() + 1, sessions.end(),
    [&](const auto& file) { this->Reader->AddSessionFileName(file.c_str()); });
  this->Reader->ClearFieldFileNames();
  for (const std::string& file : fields)
  {
    this->Reader->AddFieldFileName(file.c_str());
  }
  if (!fields.empty())
  {
    for (const std::string& name : pixelexact::nektar::FieldNames(fields.front()))
    {
      this->Offer(name, true);
    }
  }
}
