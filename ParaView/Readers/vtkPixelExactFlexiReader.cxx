// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPixelExactFlexiReader.h"

#include "vtkFlexiReader.h"

#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkPixelExactFlexiReader);

//------------------------------------------------------------------------------
vtkPixelExactFlexiReader::vtkPixelExactFlexiReader() = default;

//------------------------------------------------------------------------------
vtkPixelExactFlexiReader::~vtkPixelExactFlexiReader() = default;

//------------------------------------------------------------------------------
int vtkPixelExactFlexiReader::CanReadFile(const char* name)
{
  return this->Reader->CanReadFile(name);
}

//------------------------------------------------------------------------------
vtkAlgorithm* vtkPixelExactFlexiReader::GetSource()
{
  return this->Reader;
}

//------------------------------------------------------------------------------
void vtkPixelExactFlexiReader::Prepare()
{
  this->Reader->SetFileName(this->FileNames.front().c_str());
  this->Reader->ClearStateFileNames();
  std::for_each(this->FileNames.begin() + 1, this->FileNames.end(),
    [this](const std::string& state) { this->Reader->AddStateFileName(state.c_str()); });
  this->Reader->UpdateInformation();
  for (const std::string& field : this->Reader->GetFieldNames())
  {
    this->Offer(field, true);
  }
}
