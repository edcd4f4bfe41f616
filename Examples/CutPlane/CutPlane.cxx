// SPDX-License-Identifier: BSD-3-Clause
// A pixel-exact cut in a C++ pipeline. Usage: CutPlane MESH.vtu FIELD IMAGE.png
#include <vtkHighOrderMapper.h>
#include <vtkUnstructuredGridToHighOrderGrid.h>

#include <vtkActor.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnstructuredGrid.h>
#include <vtkWindowToImageFilter.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <cstdlib>
#include <iostream>

int main(int argc, char** argv)
{
  if (argc != 4)
  {
    std::cerr << "usage: CutPlane MESH.vtu FIELD IMAGE.png\n";
    return EXIT_FAILURE;
  }

  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(argv[1]);
  vtkNew<vtkUnstructuredGridToHighOrderGrid> convert;
  convert->SetInputConnection(reader->GetOutputPort());
  convert->Update();
  vtkDataArray* nodal = reader->GetOutput()->GetPointData()->GetArray(argv[2]);
  if (nodal == nullptr)
  {
    std::cerr << "there is no point data '" << argv[2] << "' in " << argv[1] << '\n';
    return EXIT_FAILURE;
  }

  vtkNew<vtkPlane> plane;
  plane->SetOrigin(convert->GetOutput()->GetCenter());
  plane->SetNormal(0.0, 0.0, 1.0);

  vtkNew<vtkHighOrderMapper> mapper;
  mapper->SetInputConnection(convert->GetOutputPort());
  mapper->SetCutFunction(plane);
  mapper->SelectColorArray(argv[2]);
  mapper->SetScalarRange(nodal->GetRange());

  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  renderer->AddActor(actor);
  renderer->ResetCamera();
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetSize(800, 800);
  window->AddRenderer(renderer);
  window->Render();

  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(argv[3]);
  writer->SetInputConnection(grab->GetOutputPort());
  writer->Write();
  return writer->GetErrorCode() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
