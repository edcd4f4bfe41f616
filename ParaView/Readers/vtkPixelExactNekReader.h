// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPixelExactNekReader
 * @brief   opens fields of Nek5000, nekRS and neko in ParaView
 *
 * One file lists the steps (.nek5000), or the files are steps (.f00000). See vtkNekReader.
 */

#ifndef vtkPixelExactNekReader_h
#define vtkPixelExactNekReader_h

#include "vtkPixelExactReader.h"

class vtkNekReader;

class PIXELEXACTPARAVIEWREADERS_EXPORT vtkPixelExactNekReader : public vtkPixelExactReader
{
public:
  static vtkPixelExactNekReader* New();
  vtkTypeMacro(vtkPixelExactNekReader, vtkPixelExactReader);

  int CanReadFile(const char* name) override;

protected:
  vtkPixelExactNekReader();
  ~vtkPixelExactNekReader() override;

  vtkAlgorithm* GetSource() override;
  void Prepare() override;

private:
  vtkPixelExactNekReader(const vtkPixelExactNekReader&) = delete;
  void operator=(const vtkPixelExactNekReader&) = delete;

  vtkNew<vtkNekReader> Reader;
};

#endif
