// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGLVisReader
 * @brief   reads GLVis stream files (`.saved`)
 *
 * A stream file holds an MFEM mesh and a grid function one after the other, as a solver sends them
 * to GLVis, or those of all processes of a parallel run (`parallel n i`). The field is named
 * `solution`. See vtkMFEMReader for what meshes and grid functions may
 * be.
 */

#ifndef vtkGLVisReader_h
#define vtkGLVisReader_h

#include "PixelExactFiltersModule.h"
#include "vtkHighOrderFileReader.h"

class PIXELEXACTFILTERS_EXPORT vtkGLVisReader : public vtkHighOrderFileReader
{
public:
  static vtkGLVisReader* New();
  vtkTypeMacro(vtkGLVisReader, vtkHighOrderFileReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkGLVisReader();
  ~vtkGLVisReader() override;

  pixelexact::SolverModel ReadModel(int step, bool wantMesh) override;
  bool IsHead(const std::string& head) override;

private:
  vtkGLVisReader(const vtkGLVisReader&) = delete;
  void operator=(const vtkGLVisReader&) = delete;
};

#endif
