// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGmshReader.h"

#include "Formats/FileText.h"
#include "Formats/Gmsh/MeshPieces.h"
#include "Formats/Gmsh/Reader.h"

#include "vtkObjectFactory.h"

#include <deque>

vtkStandardNewMacro(vtkGmshReader);

using namespace pixelexact;

vtkGmshReader::vtkGmshReader() = default;
vtkGmshReader::~vtkGmshReader() = default;

void vtkGmshReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SurfaceElements: " << this->SurfaceElements << "\n";
  for (const auto& name : this->ViewFiles)
  {
    os << indent << "ViewFile: " << name << "\n";
  }
}

void vtkGmshReader::AddViewFileName(const char* name)
{
  this->ViewFiles.emplace_back(name ? name : "");
  this->Modified();
}

void vtkGmshReader::ClearViewFileNames()
{
  this->ViewFiles.clear();
  this->Modified();
}

std::vector<std::string> vtkGmshReader::Files(std::size_t& pieces) const
{
  std::vector<std::string> files = gmsh::PiecesOf(this->FileName);
  pieces = files.size();
  files.insert(files.end(), this->ViewFiles.begin(), this->ViewFiles.end());
  return files;
}

std::vector<double> vtkGmshReader::ReadTimes()
{
  if (this->FileName.empty())
  {
    return {}; // RequestData says so
  }
  std::size_t pieces = 1;
  const FileTexts texts(this->Files(pieces));
  return gmsh::ReadTimes(texts.Named, pieces);
}

bool vtkGmshReader::IsHead(const std::string& head)
{
  // Version 1, which is refused by name, begins with its nodes.
  return head.find("$MeshFormat") != std::string::npos || head.find("$NOD") != std::string::npos;
}

SolverModel vtkGmshReader::ReadModel(int step, bool wantMesh)
{
  std::size_t pieces = 1;
  const FileTexts texts(this->Files(pieces));
  return gmsh::Read(texts.Named, step, wantMesh, pieces, this->SurfaceElements);
}
