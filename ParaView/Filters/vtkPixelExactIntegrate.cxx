// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPixelExactIntegrate.h"

#include "Cuts/IntegralPieces.h"
#include "InputCut.h"

#include "Core/Base/Error.h"

#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

vtkStandardNewMacro(vtkPixelExactIntegrate);

namespace
{
using namespace pixelexact;

QuadraticPolynomial Negated(QuadraticPolynomial form)
{
  std::ranges::transform(form.q, form.q.begin(), std::negate());
  form.g = -form.g;
  form.c = -form.c;
  return form;
}

/// The polynomials of a clip, which keeps the points where none is positive.
std::vector<ImplicitPolynomial> PolynomialsOf(const DescribedCut& clip)
{
  std::vector<ImplicitPolynomial> polynomials = IntegralClipsOf(clip.function);
  if (clip.inverted)
  {
    if (polynomials.size() != 1 || polynomials.front().b)
    {
      throw Unsupported("integrals do not cover what lies outside of a box or torus; switch Invert "
                        "of PixelExact Clip on.");
    }
    polynomials.front().a = Negated(polynomials.front().a);
  }
  return polynomials;
}

/// Appends the polynomials of all clips but one.
void AddClips(const std::vector<DescribedCut>& clips, const DescribedCut* except,
  std::vector<ImplicitPolynomial>& to)
{
  for (const DescribedCut& clip : clips)
  {
    if (&clip != except)
    {
      std::ranges::copy(PolynomialsOf(clip), std::back_inserter(to));
    }
  }
}
} // namespace

//------------------------------------------------------------------------------
vtkPixelExactIntegrate::vtkPixelExactIntegrate()
  : Cut(std::make_unique<pixelexact::InputCut>())
{
}

//------------------------------------------------------------------------------
vtkPixelExactIntegrate::~vtkPixelExactIntegrate() = default;

//------------------------------------------------------------------------------
void vtkPixelExactIntegrate::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "UseInputCut: " << this->Cut->ofInput << "\n";
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPixelExactIntegrate::GetMTime()
{
  return this->Cut->Latest(this->Superclass::GetMTime());
}

//------------------------------------------------------------------------------
void vtkPixelExactIntegrate::SetCutFunction(vtkImplicitFunction* function)
{
  this->Cut->chosen = function;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPixelExactIntegrate::SetUseInputCut(bool use)
{
  if (this->Cut->ofInput != use)
  {
    this->Cut->ofInput = use;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkPixelExactIntegrate::Make(vtkDataObject* mesh, Output* output)
{
  this->Superclass::SetCutFunction(this->Cut->chosen);
  return this->Superclass::Make(mesh, output);
}

//------------------------------------------------------------------------------
std::vector<ImplicitPolynomial> vtkPixelExactIntegrate::ClipsFor(vtkDataObject* mesh)
{
  std::vector<ImplicitPolynomial> clips = this->Superclass::ClipsFor(mesh);
  if (this->Cut->ofInput)
  {
    AddClips(CutsOf(mesh, kClips), nullptr, clips);
  }
  return clips;
}

//------------------------------------------------------------------------------
std::vector<SurfacePatch> vtkPixelExactIntegrate::PatchesFor(vtkDataObject* mesh)
{
  if (!this->Cut->ofInput)
  {
    return this->Superclass::PatchesFor(mesh);
  }
  const auto slices = CutsOf(mesh, kSlices);
  const auto clips = CutsOf(mesh, kClips);
  RequireCuts(slices, clips);
  std::vector<SurfacePatch> all;
  for (const DescribedCut& cut : slices.empty() ? clips : slices)
  {
    for (SurfacePatch& patch : IntegralPatchesOf(cut.function))
    {
      AddClips(clips, &cut, patch.clips);
      all.push_back(std::move(patch));
    }
  }
  return all;
}
