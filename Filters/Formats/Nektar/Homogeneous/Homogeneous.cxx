// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Homogeneous/Homogeneous.h"

#include "Formats/Nektar/Homogeneous/HomogeneousAccuracy.h"
#include "Formats/Nektar/Homogeneous/HomogeneousLift.h"

#include <algorithm>
#include <charconv>
#include <functional>

namespace pixelexact::nektar
{
namespace
{
/// Half modes: the field that is the imaginary part, and the functions of the parts among
/// Fourier's.
constexpr const char* kImaginaryField = "w";
constexpr int kFirstCosine = 2;
constexpr int kFirstSine = 3;

/// A number as people read it.
std::string Short(double number)
{
  constexpr int kDigits = 3;
  char text[32];
  const auto end =
    std::to_chars(text, text + sizeof(text), number, std::chars_format::general, kDigits);
  return { text, end.ptr };
}

FourierLayers LayersAlongZ(const Homogeneous& along, bool imaginary)
{
  return FourierLayers(along.half == HalfMode::None
      ? along.z
      : Periodic{ along.z.length, { imaginary ? kFirstSine : kFirstCosine } });
}

/// The planes of a field in layers along y, those of one function of z after the other.
std::vector<SolverExpansion> LiftAlongY(
  std::vector<SolverExpansion> planes, const FourierLayers& layers, int order)
{
  std::vector<SolverExpansion> lifted;
  for (std::size_t at = 0; at < planes.size(); at += layers.Functions())
  {
    lifted.push_back(
      LiftField(std::span(planes).subspan(at, layers.Functions()), layers, Along::Y, order));
  }
  return lifted;
}

std::string Counts(const FourierLayers* y, const std::string& z, const std::string& ofY)
{
  return y != nullptr ? ofY + " x " + z : z;
}

void AddNotes(const Homogeneous& along, const std::vector<double>& begin, const FourierLayers* y,
  const FourierLayers& z, const std::string& end, std::vector<std::string>& notes)
{
  notes.push_back(std::string("homogeneous along ") + (y != nullptr ? "y and z" : "z") +
    ": periodic with the length" + (y != nullptr ? "s " : " ") +
    Counts(y, Short(along.z.length), y != nullptr ? Short(along.y->length) : "") + ", " +
    Counts(y, std::to_string(along.z.functions.size()),
      y != nullptr ? std::to_string(y->Functions()) : "") +
    " Fourier functions; they are polynomials in " +
    Counts(y, std::to_string(z.Layers()), y != nullptr ? std::to_string(y->Layers()) : "") +
    " layers of elements, of order " + end);
  if (along.strips)
  {
    notes.push_back(std::to_string(begin.size()) + " strips, from z = " + Short(begin.front()) +
      " to " + Short(begin.back() + along.z.length) +
      ", where DistStrip puts them; between them there is nothing, and in each the field has the "
      "period.");
  }
  if (along.half != HalfMode::None)
  {
    notes.emplace_back(std::string("half mode: fields are ") +
      (along.half == HalfMode::Real ? "cosines of z, and w, as Nektar++'s solvers take it, a sine"
                                    : "sines of z, with the sign of Nektar++'s derivatives") +
      "; where others are imaginary, convert the file (FieldConvert -m "
      "halfmodetofourier:realmodetoimag=2 in.xml in.fld out.fld, with the numbers of these "
      "fields).");
  }
}
} // namespace

void LiftHomogeneous(const Homogeneous& along, const std::vector<double>& begin,
  std::vector<HomogeneousField> fields, SolverModel& model)
{
  const FourierLayers cosines = LayersAlongZ(along, false);
  const FourierLayers sines = LayersAlongZ(along, true);
  std::optional<FourierLayers> alongY;
  if (along.y)
  {
    alongY.emplace(*along.y);
    LiftMesh(*alongY, Along::Y, { 0.0 }, model.mesh);
  }
  const FourierLayers* y = alongY ? &*alongY : nullptr;
  LiftMesh(cosines, Along::Z, begin, model.mesh);
  std::string orders;
  double worst = 0.0;
  for (HomogeneousField& field : fields)
  {
    const bool isImaginary = along.half == HalfMode::Imaginary || field.name == kImaginaryField;
    const FourierLayers& z = isImaginary ? sines : cosines;
    const Accuracy accuracy = AccuracyOf(field, y, z);
    SolverField lifted;
    lifted.name = field.name;
    lifted.basis = field.basis + " x " + std::to_string(along.Functions()) + " Fourier functions";
    if (y != nullptr)
    {
      field.planes = LiftAlongY(std::move(field.planes), *y, accuracy.orderY);
    }
    lifted.values = LiftField(field.planes, z, Along::Z, accuracy.orderZ);
    field.planes.clear();
    if (along.half != HalfMode::None && !isImaginary)
    {
      CoefficientBlock& block = lifted.values.coefficients;
      std::transform(
        block.data.get(), block.data.get() + block.size, block.data.get(), std::negate<>());
    }
    model.fields.push_back(std::move(lifted));
    orders += (orders.empty() ? "" : ", ") +
      Counts(y, std::to_string(accuracy.orderZ), std::to_string(accuracy.orderY)) + " (" +
      field.name + ")";
    worst = std::max(worst, accuracy.range > 0.0 ? accuracy.loss / accuracy.range : 0.0);
  }
  AddNotes(along, begin, y, cosines,
    orders + ", which are off by at most " + Short(worst) + " of a field's range.", model.notes);
}
} // namespace pixelexact::nektar
