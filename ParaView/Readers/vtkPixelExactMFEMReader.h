// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPixelExactMFEMReader
 * @brief   opens MFEM meshes in ParaView, with the grid functions beside them
 *
 * Offers the grid functions (.gf) in the folder of the mesh. They are chosen where no other mesh
 * lies there, else those whose names begin with the mesh's. Of a mesh `x.000000`, all pieces of
 * which are read, these are files of that number. Root files of VisIt collections (.mfem_root) are
 * time steps, with their own grid functions. See vtkMFEMReader.
 */

#ifndef vtkPixelExactMFEMReader_h
#define vtkPixelExactMFEMReader_h

#include "vtkPixelExactReader.h"

class vtkMFEMReader;

class PIXELEXACTPARAVIEWREADERS_EXPORT vtkPixelExactMFEMReader : public vtkPixelExactReader
{
public:
  static vtkPixelExactMFEMReader* New();
  vtkTypeMacro(vtkPixelExactMFEMReader, vtkPixelExactReader);

  ///@{
  /**
   * Grid functions that lie elsewhere.
   */
  void AddGridFunctionFileName(const char* name);
  void RemoveAllGridFunctionFileNames();
  ///@}

  int CanReadFile(const char* name) override;

protected:
  vtkPixelExactMFEMReader();
  ~vtkPixelExactMFEMReader() override;

  vtkAlgorithm* GetSource() override;
  void Prepare() override;

private:
  vtkPixelExactMFEMReader(const vtkPixelExactMFEMReader&) = delete;
  void operator=(const vtkPixelExactMFEMReader&) = delete;

  std::vector<std::string> GridFunctions;
  vtkNew<vtkMFEMReader> Reader;
};

#endif
