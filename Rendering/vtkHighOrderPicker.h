// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderPicker
 * @brief   picks what a vtkHighOrderMapper shows, exactly
 *
 * A vtkCellPicker that knows cut-surfaces. Pick(x, y, 0, renderer) follows the ray through the
 * centre of the pixel that holds the display position: an actor with a vtkHighOrderMapper is met
 * where that ray meets its first visible surface, and what is then known is what that pixel shows,
 * bit for bit (vtkHighOrderMapper::GetBuffers); nothing is drawn for it, and no other pixel is
 * traced. All other props are picked as vtkCellPicker does, along the same ray; the nearest of all
 * is the one picked. Clipping planes and the camera's near and far plane cut off what they hide.
 * Pick3DRay and Pick3DPoint take any ray.
 *
 * Of a cut, beside PickPosition, PickNormal (the cut-surface's), MapperPosition, Mapper and Prop:
 * DataSet is the mapper's grid, or the leaf of its composite data that FlatBlockIndex names, CellId
 * the number of the cell there. SubId and PointId stay -1 and
 * PCoords are not set: xi is of PixelExact's reference shapes.
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
   * Picks at a display position; see the class's description. Not 0 where something was picked. The
   * window must have a size.
   */
  int Pick(double selectionX, double selectionY, double selectionZ, vtkRenderer* renderer) override;

  /**
   * Whether a cut was picked, and what is known of the point: 0 no cut, 1 exact, 2 the element
   * could not be decided (the pixel has the UnknownColor; there is a position, but no element and
   * no value).
   */
  vtkGetMacro(Verdict, int);

  /**
   * The cell of the source that holds the point, as in the mapper's buffers; of composite data, in
   * the block that GetFlatBlockIndex() names. -1 where there is none.
   */
  vtkGetMacro(Element, vtkIdType);

  /**
   * Reference coordinates in the element, of the shapes of Core/Shape/Shape.h; NaN where there are
   * none.
   */
  vtkGetVector3Macro(Xi, double);

  /**
   * The surface, numbered as in the mapper's buffers: the cut functions, then the layers that are
   * visible; -1 where no cut was picked.
   */
  vtkGetMacro(Layer, int);

  ///@{
  /**
   * The field that the surface shows, its value there, of the component that is shown, and the
   * values of all of its components as one tuple. NaN, and no tuple, where there is none.
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

  std::optional<std::array<double, 2>> Pixel; ///< while one is picked: its lower left corner

  int Verdict = 0;
  vtkIdType Element = -1;
  double Xi[3] = {};
  int Layer = -1;
  std::string FieldName;
  double Value = 0.0;
  vtkNew<vtkDoubleArray> FieldValues;
};

#endif
