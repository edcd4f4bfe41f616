// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Support.h"

#include "Core/Location/Sample.h"
#include "HighOrderModel.h"

#include "vtkHighOrderProbe.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

// Solvers' files against values, gradients and world points that the solvers' own libraries
// computed at given reference points.
namespace pixelexact::testing
{
/// Points of an element, in xi.
inline std::vector<Vec3> PlacesIn(Shape shape)
{
  std::vector<Vec3> xi;
  for (const Vec3& eta : { Vec3(0.0), Vec3(-0.7, 0.3, 0.1), Vec3(0.9, -0.8, -0.95),
         Vec3(0.2, 0.6, 0.7), Vec3(-0.99, -0.99, 0.5) })
  {
    xi.push_back(TensorToReference(shape, eta));
  }
  return xi;
}

/// Largest errors: value by the field's range, gradient by range over the element's size, point
/// (Phi(xi) against x) by the element's size.
struct OracleErrors
{
  double value = 0.0;
  double gradient = 0.0;
  double point = 0.0;
  int outside = 0;      ///< points that were not found inside
  int otherElement = 0; ///< points found in another element than the oracle's
};

/// A file of Data/, or of the larger cases.
inline std::filesystem::path FindData(const std::string& file)
{
  const std::filesystem::path own = std::filesystem::path(PIXELEXACT_DATA_DIR) / file;
  return std::filesystem::exists(own) ? own
                                      : std::filesystem::path(PIXELEXACT_SHARED_DATA_DIR) / file;
}

/// The oracle's table. Under the sanitizers, where the plain build has compared all of it, every
/// tenth row.
inline Table ReadOracle(const std::filesystem::path& file)
{
  Table table = ReadTable(file);
#ifdef __SANITIZE_ADDRESS__
  for (auto& [name, column] : table)
  {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < column.size(); i += 10)
    {
      column[kept++] = column[i];
    }
    column.resize(kept);
  }
#endif
  return table;
}

/// The oracle's column of a component: MFEM's and DOLFINx's value columns are called u whatever the
/// field.
inline const std::vector<double>& OracleColumn(
  const Table& table, const std::string& field, int components, int k)
{
  const std::string name = components > 1 ? "u" + std::to_string(k) : "u";
  return table.contains(field) ? table.at(field) : table.at(name);
}

/// Our reference coordinates from the oracle's: Nektar++'s are ours, others are those of the unit
/// elements.
inline Vec3 OracleXi(const Table& table, Shape shape, std::size_t i)
{
  if (table.contains("xi1"))
  {
    return { table.at("xi1")[i], table.at("xi2")[i], table.at("xi3")[i] };
  }
  const double r = 2 * table.at("r")[i] - 1;
  const double s = 2 * table.at("s")[i] - 1;
  const double t = 2 * table.at("t")[i] - 1;
  return shape == Shape::Prism ? Vec3(r, -t, s) : Vec3(r, s, t);
}

/// Probes `grid` at the oracle's points.
inline void MeasureValues(
  vtkUnstructuredGrid* grid, const Table& table, const std::string& field, OracleErrors& errors)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const auto& x = table.at("x");
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    points->InsertNextPoint(x[i], table.at("y")[i], table.at("z")[i]);
  }
  vtkNew<vtkPolyData> where;
  where->SetPoints(points);
  vtkNew<vtkHighOrderProbe> probe;
  probe->SetInputData(where);
  probe->SetSourceData(grid);
  probe->AddField(field);
  probe->ComputeGradientsOn();
  probe->Update();
  vtkPointData* found = vtkDataSet::SafeDownCast(probe->GetOutputDataObject(0))->GetPointData();
  vtkDataArray* values = found->GetArray(field.c_str());
  vtkDataArray* gradients = found->GetArray((field + "_Gradient").c_str());
  ASSERT_NE(values, nullptr);
  const auto model = HighOrderModel::From(grid);
  std::map<std::int64_t, double> sizeOf;
  for (int e = 0; e < model->GetMesh().Elements(); ++e)
  {
    sizeOf[model->SourceCells()[e]] = model->GetMesh().size[e];
  }
  for (int k = 0; k < values->GetNumberOfComponents(); ++k)
  {
    const auto& expected = OracleColumn(table, field, values->GetNumberOfComponents(), k);
    const auto [low, high] = std::ranges::minmax(expected);
    const double range = high > low ? high - low : 1.0;
    for (std::size_t i = 0; i < x.size(); ++i)
    {
      const auto at = static_cast<vtkIdType>(i);
      const double element = found->GetArray("Element")->GetComponent(at, 0);
      if (found->GetArray("Verdict")->GetComponent(at, 0) != 1.0)
      {
        errors.outside += k == 0 ? 1 : 0;
        continue;
      }
      errors.otherElement += k == 0 && element != table.at("element")[i] ? 1 : 0;
      const double error = std::fabs(values->GetComponent(at, k) - expected[i]) / range;
      ASSERT_FALSE(std::isnan(error)) << "point " << i;
      errors.value = std::max(errors.value, error);
      for (int d = 0; table.contains("dudx") && d < 3; ++d)
      {
        const double slope = table.at(std::string("dud") + "xyz"[d])[i];
        const double difference = std::fabs(gradients->GetComponent(at, 3 * k + d) - slope);
        const double size = sizeOf.at(static_cast<std::int64_t>(element));
        errors.gradient = std::max(errors.gradient, difference * size / range);
      }
    }
  }
}

/// Maps the oracle's reference points forward, without any inversion.
inline void MeasurePoints(vtkUnstructuredGrid* grid, const Table& table, OracleErrors& errors)
{
  const auto model = HighOrderModel::From(grid);
  const Mesh& mesh = model->GetMesh();
  std::map<std::int64_t, int> elementOf;
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    elementOf[model->SourceCells()[e]] = e;
  }
  for (std::size_t i = 0; i < table.at("x").size(); ++i)
  {
    const auto known = elementOf.find(static_cast<std::int64_t>(table.at("element")[i]));
    ASSERT_NE(known, elementOf.end()) << "element " << table.at("element")[i];
    const int e = known->second;
    const Vec3 xi = OracleXi(table, mesh.ShapeOf(e), i);
    Vec3 y;
    MapForward(mesh, e, std::span(&xi, 1), std::span(&y, 1));
    const Vec3 x(table.at("x")[i], table.at("y")[i], table.at("z")[i]);
    for (int d = 0; d < 3; ++d)
    {
      errors.point = std::max(errors.point, std::fabs(y[d] - x[d]) / mesh.size[e]);
    }
  }
}

inline void PrintErrors(const std::string& name, const OracleErrors& errors)
{
  std::printf("[ measured ] %-58s value %.1e gradient %.1e point %.1e outside %d other %d\n",
    name.c_str(), errors.value, errors.gradient, errors.point, errors.outside, errors.otherElement);
}
} // namespace pixelexact::testing
