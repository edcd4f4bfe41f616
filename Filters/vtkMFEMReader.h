// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMFEMReader
 * @brief   reads MFEM meshes and grid functions
 *
 * The mesh (SetFileName): MFEM mesh v1.0 to v1.3, NC mesh v1.0, NURBS mesh v1.0 and v1.1
 * (files.md), straight or with nodes of any order, tetrahedra, hexahedra, prisms and pyramids,
 * or in the plane triangles and quadrilaterals (files.md), conforming or not, periodic too. Grid
 * functions (AddGridFunctionFileName) become fields named after their files: H1, L2, H(curl),
 * H(div) of any order and basis type, NURBS. Files may be gzip-compressed. Files of parallel runs:
 * of a mesh `x.000000` all pieces that lie beside it are read, and of a grid function `u.000000` as
 * many. A root file of a VisIt collection (`x.mfem_root`) stands for its mesh and its grid
 * functions; several (AddStepFileName) are time steps, each with a mesh of its own.
 * Module/Documentation/files.md says what is refused.
 */

#ifndef vtkMFEMReader_h
#define vtkMFEMReader_h

#include "PixelExactFiltersModule.h"
#include "vtkHighOrderFileReader.h"

class PIXELEXACTFILTERS_EXPORT vtkMFEMReader : public vtkHighOrderFileReader
{
public:
  static vtkMFEMReader* New();
  vtkTypeMacro(vtkMFEMReader, vtkHighOrderFileReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Grid functions on the mesh, each a field that is named after its file (`u.gf`: `u`).
   */
  void AddGridFunctionFileName(const char* name);
  void ClearGridFunctionFileNames();
  ///@}

  ///@{
  /**
   * Root files of further cycles of a collection whose first one is the file.
   */
  void AddStepFileName(const char* name);
  void ClearStepFileNames();
  ///@}

protected:
  vtkMFEMReader();
  ~vtkMFEMReader() override;

  pixelexact::SolverModel ReadModel(int step, bool wantMesh) override;
  bool IsHead(const std::string& head) override;
  std::vector<double> ReadTimes() override;
  int StepOfMesh(int step) override { return step; }

private:
  vtkMFEMReader(const vtkMFEMReader&) = delete;
  void operator=(const vtkMFEMReader&) = delete;

  std::vector<std::string> GridFunctions;
  std::vector<std::string> Steps; ///< further root files
  std::vector<std::string> Order; ///< all root files, by time
};

#endif
