// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPixelExactFlexiReader
 * @brief   opens states of FLEXI and meshes of HOPR in ParaView
 *
 * The files are states, which are time steps, or a mesh and its states. See vtkFlexiReader.
 */

#ifndef vtkPixelExactFlexiReader_h
#define vtkPixelExactFlexiReader_h

#include "vtkPixelExactReader.h"

class vtkFlexiReader;

class PIXELEXACTPARAVIEWREADERS_EXPORT vtkPixelExactFlexiReader : public vtkPixelExactReader
{
public:
  static vtkPixelExactFlexiReader* New();
  vtkTypeMacro(vtkPixelExactFlexiReader, vtkPixelExactReader);

  int CanReadFile(const char* name) override;

protected:
  vtkPixelExactFlexiReader();
  ~vtkPixelExactFlexiReader() override;

  vtkAlgorithm* GetSource() override;
  void Prepare() override;

private:
  vtkPixelExactFlexiReader(const vtkPixelExactFlexiReader&) = delete;
  void operator=(const vtkPixelExactFlexiReader&) = delete;

  vtkNew<vtkFlexiReader> Reader;
};

#endif
