// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPixelExactMFEMReader.h"

#include "FilesBeside.h"
#include "vtkMFEMReader.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <fstream>
#include <iterator>

vtkStandardNewMacro(vtkPixelExactMFEMReader);

namespace
{
constexpr const char* kFirstPiece = ".000000";

/// Pieces of meshes and of grid functions have names of one kind; their first words differ.
bool IsGridFunction(const std::filesystem::path& file)
{
  std::error_code failure;
  if (!std::filesystem::is_regular_file(file, failure))
  {
    return false; // a pipe may be waited for without an end
  }
  std::ifstream stream(file);
  std::string first;
  std::string second;
  stream >> first >> second;
  return first == "FiniteElementSpace" || (first == "MFEM" && second == "FiniteElementSpace");
}

/// The grid functions in a mesh's folder, and whether there are other meshes.
struct Companions
{
  std::vector<std::filesystem::path> functions;
  bool isAlone = false;
};

Companions CompanionsOf(const std::filesystem::path& mesh)
{
  const auto alike = pixelexact::FilesBeside(mesh, mesh.extension());
  if (mesh.extension() != kFirstPiece)
  {
    return { pixelexact::FilesBeside(mesh, ".gf"), alike.size() == 1 };
  }
  Companions companions;
  std::ranges::copy_if(alike, std::back_inserter(companions.functions), &IsGridFunction);
  companions.isAlone = alike.size() == companions.functions.size() + 1;
  return companions;
}
} // namespace

//------------------------------------------------------------------------------
vtkPixelExactMFEMReader::vtkPixelExactMFEMReader() = default;

//------------------------------------------------------------------------------
vtkPixelExactMFEMReader::~vtkPixelExactMFEMReader() = default;

//------------------------------------------------------------------------------
void vtkPixelExactMFEMReader::AddGridFunctionFileName(const char* name)
{
  if (name != nullptr && name[0] != '\0')
  {
    this->GridFunctions.emplace_back(name);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkPixelExactMFEMReader::RemoveAllGridFunctionFileNames()
{
  this->GridFunctions.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkPixelExactMFEMReader::CanReadFile(const char* name)
{
  return this->Reader->CanReadFile(name);
}

//------------------------------------------------------------------------------
vtkAlgorithm* vtkPixelExactMFEMReader::GetSource()
{
  return this->Reader;
}

//------------------------------------------------------------------------------
void vtkPixelExactMFEMReader::Prepare()
{
  const std::filesystem::path mesh = this->FileNames.front();
  this->Reader->SetFileName(mesh.c_str());
  this->Reader->ClearGridFunctionFileNames();
  this->Reader->ClearStepFileNames();
  if (mesh.extension() == ".mfem_root")
  {
    std::for_each(this->FileNames.begin() + 1, this->FileNames.end(),
      [this](const std::string& step) { this->Reader->AddStepFileName(step.c_str()); });
    return; // a collection knows its grid functions
  }
  const Companions companions = CompanionsOf(mesh);
  for (const auto& file : companions.functions)
  {
    const std::string name = file.stem();
    this->Offer(name, companions.isAlone || name.starts_with(mesh.stem().string()));
    if (this->IsChosen(name))
    {
      this->Reader->AddGridFunctionFileName(file.c_str());
    }
  }
  for (const std::string& file : this->GridFunctions)
  {
    const std::string name = std::filesystem::path(file).stem();
    this->Offer(name, true);
    if (this->IsChosen(name))
    {
      this->Reader->AddGridFunctionFileName(file.c_str());
    }
  }
}
