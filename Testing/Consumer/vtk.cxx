#include <vtkHighOrderGrid.h>
#include <vtkHighOrderMapper.h>
#include <vtkUnstructuredGridToHighOrderGrid.h>

#include <vtkCellType.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <cstdlib>
#include <iostream>

int main()
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(1.0, 0.0, 0.0);
  points->InsertNextPoint(0.0, 1.0, 0.0);
  points->InsertNextPoint(0.0, 0.0, 1.0);
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(points);
  const vtkIdType ids[4] = { 0, 1, 2, 3 };
  grid->InsertNextCell(VTK_TETRA, 4, ids);

  vtkNew<vtkUnstructuredGridToHighOrderGrid> convert;
  convert->SetInputData(grid);
  convert->Update();
  auto* output = vtkHighOrderGrid::SafeDownCast(convert->GetOutputDataObject(0));
  if (output == nullptr || output->GetNumberOfCells() != 1)
  {
    std::cerr << "no high-order grid of one cell\n";
    return EXIT_FAILURE;
  }

  vtkNew<vtkHighOrderMapper> mapper;
  mapper->SetInputDataObject(output);
  std::cout << mapper->GetClassName() << " over " << output->GetClassName() << '\n';
  return EXIT_SUCCESS;
}
