// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPixelExactWarp
 * @brief   vtkHighOrderWarp, whose field is chosen from a list or given as an expression
 */

#ifndef vtkPixelExactWarp_h
#define vtkPixelExactWarp_h

#include "PixelExactParaViewFiltersModule.h"
#include "vtkHighOrderWarp.h"

#include <string> // for names

class PIXELEXACTPARAVIEWFILTERS_EXPORT vtkPixelExactWarp : public vtkHighOrderWarp
{
public:
  static vtkPixelExactWarp* New();
  vtkTypeMacro(vtkPixelExactWarp, vtkHighOrderWarp);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The field, see vtkHighOrderWarp::SetFieldName. An expression that is not empty replaces the
   * displacement.
   */
  void SetDisplacement(const char* field);
  void SetExpression(const char* expression);
  ///@}

protected:
  vtkPixelExactWarp() = default;
  ~vtkPixelExactWarp() override = default;

private:
  vtkPixelExactWarp(const vtkPixelExactWarp&) = delete;
  void operator=(const vtkPixelExactWarp&) = delete;

  void ChooseField();

  std::string Displacement;
  std::string Expression;
};

#endif
