// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGmshReader
 * @brief   reads Gmsh meshes and the views on them
 *
 * The mesh (SetFileName): Gmsh's `.msh`, version 2.0 to 2.2 or 4.1, text or binary, with
 * tetrahedra, hexahedra, prisms and pyramids of any order. Views in the same file, or in further
 * ones (AddViewFileName) that hold no mesh, become fields of their names. Their steps are time
 * steps. Files may be gzip-compressed. Module/Documentation/files.md says what is refused.
 */

#ifndef vtkGmshReader_h
#define vtkGmshReader_h

#include "PixelExactFiltersModule.h"
#include "vtkHighOrderFileReader.h"

class PIXELEXACTFILTERS_EXPORT vtkGmshReader : public vtkHighOrderFileReader
{
public:
  static vtkGmshReader* New();
  vtkTypeMacro(vtkGmshReader, vtkHighOrderFileReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Files of views on the mesh.
   */
  void AddViewFileName(const char* name);
  void ClearViewFileNames();
  ///@}

  ///@{
  /**
   * Whether the elements are the triangles and quadrilaterals of a file that has solids as well.
   * Off by default. It is an error where there are none.
   */
  vtkSetMacro(SurfaceElements, bool);
  vtkGetMacro(SurfaceElements, bool);
  vtkBooleanMacro(SurfaceElements, bool);
  ///@}

protected:
  vtkGmshReader();
  ~vtkGmshReader() override;

  pixelexact::SolverModel ReadModel(int step, bool wantMesh) override;
  bool IsHead(const std::string& head) override;
  std::vector<double> ReadTimes() override;

private:
  vtkGmshReader(const vtkGmshReader&) = delete;
  void operator=(const vtkGmshReader&) = delete;

  /** The mesh, as many files as `pieces` says, and the views. */
  std::vector<std::string> Files(std::size_t& pieces) const;

  std::vector<std::string> ViewFiles;
  bool SurfaceElements = false;
};

#endif
