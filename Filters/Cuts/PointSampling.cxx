// SPDX-License-Identifier: BSD-3-Clause
#include "Cuts/PointSampling.h"

#include "Core/Base/Error.h"
#include "Core/Location/Owners.h"
#include "Core/Location/Sample.h"
#include "Grids/FilterInput.h"

#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <thread>

namespace pixelexact
{
namespace
{
constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

vtkSmartPointer<vtkDoubleArray> NewDoubles(
  const std::string& name, int components, std::size_t tuples)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
  array->Fill(kNothing);
  return array;
}

/// Throws where an array of that name exists, because VTK would replace it.
void Put(vtkPointData* output, vtkDataArray* array)
{
  const std::string name = array->GetName();
  if (output->HasArray(name.c_str()))
  {
    throw InvalidData("two arrays would be called '" + name +
      "', that of a field and what is found at its side; rename the field, or leave it out.");
  }
  output->AddArray(array);
}
} // namespace

std::vector<Vec3> PointsOf(vtkDataSet* data)
{
  std::vector<Vec3> points(data->GetNumberOfPoints());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    double x[3];
    data->GetPoint(static_cast<vtkIdType>(i), x);
    points[i] = { x[0], x[1], x[2] };
  }
  return points;
}

PointSampling::PointSampling(
  const HighOrderModel& model, std::vector<Vec3> points, const StepProgress& progress)
  : Model(model)
  , Points(std::move(points))
  , Element(Points.size())
  , Xi(Points.size())
  , verdicts_(Points.size())
  , Residual(Points.size())
{
  // Points share work where they are near each other, as a data set's are in its own order.
  constexpr std::size_t kStep = std::size_t{ 1 } << 17;
  for (std::size_t begin = 0; begin < Points.size(); begin += kStep)
  {
    const std::size_t count = std::min(kStep, Points.size() - begin);
    SampleTarget target;
    target.element = std::span(Element).subspan(begin, count);
    target.xi = std::span(Xi).subspan(begin, count);
    target.verdict = std::span(verdicts_).subspan(begin, count);
    target.residual = std::span(Residual).subspan(begin, count);
    Sample(model.GetLocator(), nullptr, std::span(Points).subspan(begin, count), target);
    if (progress &&
      !progress(static_cast<double>(begin + count) / static_cast<double>(Points.size())))
    {
      Aborted = true;
      return;
    }
  }

  for (int i = 0; i < static_cast<int>(Points.size()); ++i)
  {
    if (verdicts_[i] == Verdict::Inside)
    {
      Order.push_back(i);
    }
  }
  std::ranges::stable_sort(Order, {}, [this](int i) { return Element[i]; });
  for (int k = 0; k < static_cast<int>(Order.size()); ++k)
  {
    if (k == 0 || Element[Order[k]] != Element[Order[k - 1]])
    {
      Starts.push_back(k);
    }
  }
  Starts.push_back(static_cast<int>(Order.size()));
}

template <class Work>
bool PointSampling::ForRuns(const StepProgress& progress, const Work& work) const
{
  const std::size_t runs = Starts.size() - 1;
  const auto caller = std::this_thread::get_id();
  std::atomic<std::size_t> done = 0;
  std::atomic<bool> stop = false;
  tbb::parallel_for(std::size_t(0), runs,
    [&](std::size_t run)
    {
      if (stop)
      {
        return;
      }
      work(run);
      ++done;
      if (progress && std::this_thread::get_id() == caller &&
        !progress(static_cast<double>(done) / static_cast<double>(runs)))
      {
        stop = true;
      }
    });
  return !stop;
}

bool PointSampling::AddFields(
  const SamplingOptions& options, vtkPointData* output, const StepProgress& progress) const
{
  const std::vector<const Field*> fields = FieldsNamed(Model, options.fields);
  // An enclosure costs many values.
  const double ofValues = options.enclosures ? 0.05 : 1.0;
  const double share = 1.0 / static_cast<double>(std::max<std::size_t>(fields.size(), 1));
  double begin = 0.0;
  const auto next = [&](double part) -> StepProgress
  {
    const double from = begin;
    begin += part * share;
    if (!progress)
    {
      return {};
    }
    return [&progress, from, part, share](double done)
    { return progress(from + done * part * share); };
  };
  return std::ranges::all_of(fields,
    [&](const Field* field)
    {
      return AddField(*field, options.gradients, output, next(ofValues)) &&
        (!options.enclosures || AddEnclosures(*field, output, next(1.0 - ofValues)));
    });
}

bool PointSampling::AddField(
  const Field& field, bool gradients, vtkPointData* output, const StepProgress& progress) const
{
  const int components = field.values.components;
  const auto values = NewDoubles(field.name, components, Points.size());
  const auto slopes =
    NewDoubles(field.name + "_Gradient", 3 * components, gradients ? Points.size() : 0);
  const bool done = ForRuns(progress,
    [&](std::size_t run)
    {
      const auto first = static_cast<std::size_t>(Starts[run]);
      const auto count = static_cast<std::size_t>(Starts[run + 1]) - first;
      std::vector<Vec3> xi(count);
      std::vector<Vec3> x(count);
      std::vector<double> value(count * components);
      std::vector<double> gradient(gradients ? 3 * value.size() : 0);
      for (std::size_t i = 0; i < count; ++i)
      {
        xi[i] = Xi[Order[first + i]];
        x[i] = Points[Order[first + i]];
      }
      EvaluateAt(Model.GetMesh(), field, Element[Order[first]], xi, value, gradient, { .x = x });
      for (std::size_t i = 0; i < count; ++i)
      {
        const int point = Order[first + i];
        std::copy_n(&value[i * components], components,
          values->GetPointer(static_cast<vtkIdType>(point) * components));
        if (gradients)
        {
          std::copy_n(&gradient[3 * i * components], 3 * components,
            slopes->GetPointer(3 * static_cast<vtkIdType>(point) * components));
        }
      }
    });
  Put(output, values);
  if (gradients)
  {
    Put(output, slopes);
  }
  return done;
}

bool PointSampling::AddEnclosures(
  const Field& field, vtkPointData* output, const StepProgress& progress) const
{
  const int components = field.values.components;
  const auto lower = NewDoubles(field.name + "_lower", components, Points.size());
  const auto upper = NewDoubles(field.name + "_upper", components, Points.size());
  const bool done = ForRuns(progress,
    [&](std::size_t run)
    {
      const auto first = static_cast<std::size_t>(Starts[run]);
      const auto count = static_cast<std::size_t>(Starts[run + 1]) - first;
      std::vector<Vec3> xi(count);
      std::vector<Vec3> x(count);
      std::vector<double> least(count * components);
      std::vector<double> most(least.size());
      for (std::size_t i = 0; i < count; ++i)
      {
        xi[i] = Xi[Order[first + i]];
        x[i] = Points[Order[first + i]];
      }
      EncloseAt(Model.GetMesh(), field, Element[Order[first]], xi, x, least, most);
      for (std::size_t i = 0; i < count; ++i)
      {
        const vtkIdType at = static_cast<vtkIdType>(Order[first + i]) * components;
        std::copy_n(&least[i * components], components, lower->GetPointer(at));
        std::copy_n(&most[i * components], components, upper->GetPointer(at));
      }
    });
  Put(output, lower);
  Put(output, upper);
  return done;
}

void PointSampling::AddBlocks(vtkPointData* output) const
{
  vtkNew<vtkTypeInt64Array> block;
  block->SetName("Block");
  for (const std::int32_t element : Element)
  {
    block->InsertNextValue(
      element < 0 ? -1 : HighOrderModel::BlockOf(element, Model.Blocks()).flatIndex);
  }
  Put(output, block);
}

void PointSampling::AddLocations(vtkPointData* output) const
{
  const auto count = static_cast<vtkIdType>(Points.size());
  const auto xi = NewDoubles("Xi", 3, Points.size());
  const auto residual = NewDoubles("Residual", 1, Points.size());
  vtkNew<vtkTypeInt64Array> element;
  element->SetName("Element");
  element->SetNumberOfValues(count);
  vtkNew<vtkUnsignedCharArray> verdict;
  verdict->SetName("Verdict");
  verdict->SetNumberOfValues(count);
  if (!Model.Blocks().empty())
  {
    AddBlocks(output);
  }
  const auto source = Model.SourceCells();
  for (vtkIdType i = 0; i < count; ++i)
  {
    for (int d = 0; d < 3; ++d)
    {
      xi->SetTypedComponent(i, d, Xi[i][d]);
    }
    residual->SetValue(i, Residual[i]);
    element->SetValue(i, Element[i] < 0 ? -1 : source[Element[i]]);
    verdict->SetValue(i, static_cast<unsigned char>(verdicts_[i]));
  }
  Put(output, xi);
  Put(output, element);
  Put(output, verdict);
  Put(output, residual);
}

void PointSampling::AddOwners(vtkPointData* output) const
{
  std::vector<Owners> found(Points.size());
  FindOwners(Model.GetLocator(), Points, found);
  vtkNew<vtkIntArray> owners;
  owners->SetName("Owners");
  owners->SetNumberOfValues(static_cast<vtkIdType>(found.size()));
  vtkNew<vtkUnsignedCharArray> coverage;
  coverage->SetName("Coverage");
  coverage->SetNumberOfValues(static_cast<vtkIdType>(found.size()));
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    owners->SetValue(static_cast<vtkIdType>(i), found[i].preimages);
    coverage->SetValue(static_cast<vtkIdType>(i), static_cast<unsigned char>(found[i].coverage));
  }
  Put(output, owners);
  Put(output, coverage);
}
} // namespace pixelexact
