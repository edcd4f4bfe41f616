// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNektarReader.h"

#include "Formats/FileText.h"
#include "Formats/Nektar/Files/FileParts.h"
#include "Formats/Nektar/Reader.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <deque>
#include <numeric>

vtkStandardNewMacro(vtkNektarReader);

using namespace pixelexact;

vtkNektarReader::vtkNektarReader() = default;
vtkNektarReader::~vtkNektarReader() = default;

void vtkNektarReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const auto& name : this->Sessions)
  {
    os << indent << "Session: " << name << "\n";
  }
  for (const auto& name : this->FieldFiles)
  {
    os << indent << "FieldFile: " << name << "\n";
  }
}

void vtkNektarReader::AddSessionFileName(const char* name)
{
  this->Sessions.emplace_back(name ? name : "");
  this->Modified();
}

void vtkNektarReader::ClearSessionFileNames()
{
  this->Sessions.clear();
  this->Modified();
}

void vtkNektarReader::AddFieldFileName(const char* name)
{
  this->FieldFiles.emplace_back(name ? name : "");
  this->Modified();
}

void vtkNektarReader::ClearFieldFileNames()
{
  this->FieldFiles.clear();
  this->Modified();
}

std::vector<double> vtkNektarReader::ReadTimes()
{
  std::vector<double> times;
  for (const auto& file : this->FieldFiles)
  {
    const auto time = nektar::FieldTime(file);
    if (!time)
    {
      times.clear();
      break;
    }
    times.push_back(*time);
  }
  this->FileOfStep.resize(this->FieldFiles.size());
  std::iota(this->FileOfStep.begin(), this->FileOfStep.end(), 0);
  if (times.empty() && this->FieldFiles.size() > 1)
  {
    times.assign(this->FileOfStep.begin(), this->FileOfStep.end());
  }
  if (!times.empty())
  {
    std::ranges::stable_sort(this->FileOfStep, {}, [&](int file) { return times[file]; });
  }
  std::ranges::stable_sort(times);
  return times;
}

bool vtkNektarReader::IsHead(const std::string& head)
{
  return head.find("<NEKTAR") != std::string::npos || head.starts_with("\x89HDF");
}

SolverModel vtkNektarReader::ReadModel(int step, bool wantMesh)
{
  const bool isKnown = !wantMesh && this->Outline;
  nektar::SessionMesh mesh = isKnown ? nektar::OutlineOf(*this->Outline) : this->ReadSession();
  if (!isKnown)
  {
    this->Outline = this->FieldFiles.size() > 1
      ? std::make_unique<nektar::SessionMesh>(nektar::OutlineOf(mesh))
      : nullptr;
  }
  if (this->FieldFiles.empty())
  {
    nektar::RequireFields(mesh);
  }
  else
  {
    const FileTexts fields(nektar::FileParts(this->FieldFiles[this->FileOfStep[step]]));
    nektar::AddFields(fields.Named, mesh);
  }
  return std::move(mesh.model);
}

nektar::SessionMesh vtkNektarReader::ReadSession()
{
  std::vector<std::string> sessions = nektar::FileParts(this->FileName);
  for (const auto& name : this->Sessions)
  {
    const auto parts = nektar::FileParts(name);
    sessions.insert(sessions.end(), parts.begin(), parts.end());
  }
  FileTexts session(sessions);
  session.Add(nektar::MissingMeshes(session.Named));
  return nektar::ReadMesh(session.Named);
}
