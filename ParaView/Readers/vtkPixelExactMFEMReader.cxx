// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPixelExactMFEMReader.h"

#include "FilesBeside.h"
#include "vtkMFEMReader.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPixelExactMFEMReader);

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
  const bool isAlone = pixelexact::FilesBeside(mesh, mesh.extension()).size() == 1;
  for (const auto& file : pixelexact::FilesBeside(mesh, ".gf"))
  {
    const std::string name = file.stem();
    this->Offer(name, isAlone || name.starts_with(mesh.stem().string()));
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
