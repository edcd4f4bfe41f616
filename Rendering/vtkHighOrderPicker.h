// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderPicker
 * @brief   picks exactly the points that a vtkHighOrderMapper shows
 *
 * A vtkCellPicker for cut-surfaces. Pick(x, y, 0, renderer) follows the ray through the centre of
 * the pixel at the display position. An actor with a vtkHighOrderMapper is picked at the ray's
 * first visible surface, and the result equals that pixel's data, bit for bit
 * (vtkHighOrderMapper::GetBuffers). Nothing is drawn, and no other pixel is traced. All other props
 * are picked as vtkCellPicker does, along the same ray; the nearest prop is picked. Clipping planes
 * and the camera's near and far plane apply. Pick3DRay and Pick3DPoint take any ray.
 *
 * For a cut it sets PickPosition, PickNormal (the cut-surface's), MapperPosition, Mapper and Prop.
 * DataSet is the mapper's grid, or the leaf of its composite data with index FlatBlockIndex, and
 * CellId is the number of the cell in it. SubId and PointId stay -1, and PCoords are not set,
 * because xi refers to PixelExact's reference shapes.
 *
 * @sa vtkHighOrderMapper vtkCellPicker
 */

#ifndef vtkHighOrderPicker_h
#define vtkHighOrderPicker_h

#include "PixelExactRenderingModule.h"
#include "vtkCellPicker.h"
#include "vtkNew.h" // for the values

#include <array>    // for the pixel
#include <optional> // for the pixel
#include <string>   // for the field's name

class vtkDoubleArray;

class PIXELEXACTRENDERING_EXPORT vtkHighOrderPicker : public vtkCellPicker
{
public:
  static vtkHighOrderPicker* New();
  vtkTypeMacro(vtkHighOrderPicker, vtkCellPicker);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  using vtkPicker::Pick;
  /**
   * Picks at a display position; see the class's description. Returns 0 if nothing was picked. The
   * window must have a size.
   */
  int Pick(double selectionX, double selectionY, double selectionZ, vtkRenderer* renderer) override;

  /**
   * Verdict of the picked point: 0 no cut, 1 exact, 2 undecided element (the pixel has the
   * UnknownColor; there is a position, but neither element nor value).
   */
  vtkGetMacro(Verdict, int);

  /**
   * The source cell of the point, as in the mapper's buffers; for composite data, in the block with
   * index GetFlatBlockIndex(). -1 if there is none.
   */
  vtkGetMacro(Element, vtkIdType);

  /**
   * Reference coordinates in the element, in the shapes of Core/Shape/Shape.h; NaN if there are
   * none.
   */
  vtkGetVector3Macro(Xi, double);

  /**
   * The surface, numbered as in the mapper's buffers: the cut functions, then the visible layers;
   * -1 if no cut was picked.
   */
  vtkGetMacro(Layer, int);

  ///@{
  /**
   * The field of the surface, its value at the point (of the visible component), and the values of
   * all of its components as one tuple. NaN, and no tuple, if there is no value.
   */
  vtkGetCharFromStdStringMacro(FieldName);
  vtkGetMacro(Value, double);
  vtkDoubleArray* GetFieldValues();
  ///@}

protected:
  vtkHighOrderPicker();
  ~vtkHighOrderPicker() override;

  void ResetPickInfo() override;
  double IntersectWithLine(const double p1[3], const double p2[3], double tol,
    vtkAssemblyPath* path, vtkProp3D* prop, vtkAbstractMapper3D* mapper) override;

private:
  vtkHighOrderPicker(const vtkHighOrderPicker&) = delete;
  void operator=(const vtkHighOrderPicker&) = delete;

  void ForgetCut();

  std::optional<std::array<double, 2>> Pixel; ///< lower left corner of the pixel during a pick

  int Verdict = 0;
  vtkIdType Element = -1;
  double Xi[3] = {};
  int Layer = -1;
  std::string FieldName;
  double Value = 0.0;
  vtkNew<vtkDoubleArray> FieldValues;
};

#endif
