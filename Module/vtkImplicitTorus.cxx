// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImplicitTorus.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkImplicitTorus);

namespace
{
// A point relative to a torus: the height over its plane, and the components across its axis.
struct Place
{
  double axis[3];
  double height;
  double across[3];
  double rho;
};

Place PlaceOf(const double x[3], const double center[3], const double axis[3])
{
  Place place;
  std::copy_n(axis, 3, place.axis);
  vtkMath::Normalize(place.axis);
  double offset[3];
  vtkMath::Subtract(x, center, offset);
  place.height = vtkMath::Dot(offset, place.axis);
  for (int i = 0; i < 3; ++i)
  {
    place.across[i] = offset[i] - place.height * place.axis[i];
  }
  place.rho = vtkMath::Norm(place.across);
  return place;
}
} // namespace

//------------------------------------------------------------------------------
vtkImplicitTorus::vtkImplicitTorus() = default;

//------------------------------------------------------------------------------
vtkImplicitTorus::~vtkImplicitTorus() = default;

//------------------------------------------------------------------------------
double vtkImplicitTorus::EvaluateFunction(double x[3])
{
  const Place place = PlaceOf(x, this->Center, this->Axis);
  const double aside = place.rho - this->Radius;
  return aside * aside + place.height * place.height - this->TubeRadius * this->TubeRadius;
}

//------------------------------------------------------------------------------
void vtkImplicitTorus::EvaluateGradient(double x[3], double gradient[3])
{
  const Place place = PlaceOf(x, this->Center, this->Axis);
  const double outwards = place.rho > 0.0 ? (place.rho - this->Radius) / place.rho : 0.0;
  for (int i = 0; i < 3; ++i)
  {
    gradient[i] = 2.0 * (outwards * place.across[i] + place.height * place.axis[i]);
  }
}

//------------------------------------------------------------------------------
void vtkImplicitTorus::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Center: " << this->Center[0] << ", " << this->Center[1] << ", "
     << this->Center[2] << "\n";
  os << indent << "Axis: " << this->Axis[0] << ", " << this->Axis[1] << ", " << this->Axis[2]
     << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "TubeRadius: " << this->TubeRadius << "\n";
}
