// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPixelExactGridReader
 * @brief   opens .vtu, .pvtu and .pvd files of high-order cells in ParaView, as exact polynomials
 *
 * vtkHighOrderSeriesReader, then vtkUnstructuredGridToHighOrderGrid: see there.
 */

#ifndef vtkPixelExactGridReader_h
#define vtkPixelExactGridReader_h

#include "vtkPixelExactReader.h"

class vtkHighOrderSeriesReader;
class vtkUnstructuredGridToHighOrderGrid;

class PIXELEXACTPARAVIEWREADERS_EXPORT vtkPixelExactGridReader : public vtkPixelExactReader
{
public:
  static vtkPixelExactGridReader* New();
  vtkTypeMacro(vtkPixelExactGridReader, vtkPixelExactReader);

  ///@{
  /**
   * See vtkUnstructuredGridToHighOrderGrid.
   */
  void SetNodePlacement(int placement);
  void SetMirroredWedges(bool mirrored);
  void SetSurfaceElements(bool surfaces);
  void SetDiagnose(bool diagnose);
  ///@}

  int CanReadFile(const char* name) override;

protected:
  vtkPixelExactGridReader();
  ~vtkPixelExactGridReader() override;

  vtkAlgorithm* GetSource() override;
  void Prepare() override;

private:
  vtkPixelExactGridReader(const vtkPixelExactGridReader&) = delete;
  void operator=(const vtkPixelExactGridReader&) = delete;

  vtkNew<vtkHighOrderSeriesReader> Reader;
  vtkNew<vtkUnstructuredGridToHighOrderGrid> Convert;
};

#endif
