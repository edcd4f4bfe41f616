// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPixelExactGridReader.h"

#include "vtkHighOrderSeriesReader.h"
#include "vtkUnstructuredGridToHighOrderGrid.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPixelExactGridReader);

//------------------------------------------------------------------------------
vtkPixelExactGridReader::vtkPixelExactGridReader()
{
  this->Convert->SetInputConnection(this->Reader->GetOutputPort());
}

//------------------------------------------------------------------------------
vtkPixelExactGridReader::~vtkPixelExactGridReader() = default;

//------------------------------------------------------------------------------
void vtkPixelExactGridReader::SetNodePlacement(int placement)
{
  this->Convert->SetNodePlacement(placement);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPixelExactGridReader::SetMirroredWedges(bool mirrored)
{
  this->Convert->SetMirroredWedges(mirrored);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPixelExactGridReader::SetDiagnose(bool diagnose)
{
  this->Convert->SetDiagnose(diagnose);
  this->Modified();
}

//------------------------------------------------------------------------------
vtkAlgorithm* vtkPixelExactGridReader::GetSource()
{
  return this->Convert;
}

//------------------------------------------------------------------------------
void vtkPixelExactGridReader::Prepare()
{
  this->Reader->ClearFileNames();
  for (const std::string& file : this->FileNames)
  {
    this->Reader->AddFileName(file.c_str());
  }
}
