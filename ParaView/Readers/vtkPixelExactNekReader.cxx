// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPixelExactNekReader.h"

#include "vtkNekReader.h"

#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkPixelExactNekReader);

//------------------------------------------------------------------------------
vtkPixelExactNekReader::vtkPixelExactNekReader() = default;

//------------------------------------------------------------------------------
vtkPixelExactNekReader::~vtkPixelExactNekReader() = default;

//------------------------------------------------------------------------------
int vtkPixelExactNekReader::CanReadFile(const char* name)
{
  return this->Reader->CanReadFile(name);
}

//------------------------------------------------------------------------------
vtkAlgorithm* vtkPixelExactNekReader::GetSource()
{
  return this->Reader;
}

//------------------------------------------------------------------------------
void vtkPixelExactNekReader::Prepare()
{
  this->Reader->SetFileName(this->FileNames.front().c_str());
  this->Reader->ClearStepFileNames();
  std::for_each(this->FileNames.begin() + 1, this->FileNames.end(),
    [this](const std::string& step) { this->Reader->AddStepFileName(step.c_str()); });
  this->Reader->UpdateInformation();
  for (const std::string& field : this->Reader->GetFieldNames())
  {
    this->Offer(field, true);
  }
}
