// SPDX-License-Identifier: BSD-3-Clause
// The study in full: every sweep, as tables.
//
//   StabilityStudy DIRECTORY   writes rows.csv, location.csv, evaluation.csv and table.md
//
// Exits with 1 where a verdict is wrong or an error above its bound.
#include "Stability/EvaluationStudy.h"
#include "Stability/LocationStudy.h"
#include "Stability/NodeStudy.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace pixelexact::testing
{
namespace
{
struct Results
{
  std::vector<Row> rows;
  std::vector<ScatterPoint> location;
  std::vector<ScatterPoint> evaluation;
};

/// A point costs the cube of the order and more, in the reference and on the careful path.
int PointsAt(int order, int atOnce)
{
  return std::clamp(36 * atOnce / (order * order), atOnce / 20, atOnce);
}

void RunLocation(Results& results)
{
  constexpr int kPoints = 200;
  for (const auto& sweep : LocationSweeps())
  {
    std::cout << "location: " << sweep.name << std::endl;
    std::vector<LocationCase> cases;
    sweep.add(Extent::Full, cases);
    for (const LocationCase& subject : cases)
    {
      const bool thin = subject.sweep == "spiral";
      const int points = thin ? kPoints : PointsAt(subject.order, kPoints);
      results.rows.push_back(StudyLocation(subject, points, points, &results.location));
    }
  }
}

void RunEvaluation(Results& results)
{
  for (const int order : AllOrders())
  {
    std::cout << "evaluation: order " << order << std::endl;
    for (const Space& space : EvaluationSpaces(order))
    {
      for (const Coefficients kind : kAllCoefficients)
      {
        results.rows.push_back(
          StudyEvaluation(space, kind, PointsAt(order, 80), &results.evaluation));
      }
    }
  }
}

void RunNodes(Results& results)
{
  constexpr int kPoints = 60;
  constexpr int kMaxTetrahedron = 14;
  for (int order = 1; order <= kMaxOrder; ++order)
  {
    std::cout << "nodes: order " << order << std::endl;
    auto& rows = results.rows;
    rows.push_back(StudyNodes(Shape::Hexahedron, Nodes::Equispaced, order, kPoints));
    rows.push_back(StudyNodes(Shape::Hexahedron, Nodes::GaussLobatto, order, kPoints));
    // Its matrix is dense.
    if (order <= kMaxTetrahedron)
    {
      rows.push_back(StudyNodes(Shape::Tetrahedron, Nodes::Equispaced, order, kPoints));
    }
  }
}

bool IsRight(const Row& row)
{
  return row.inside.wrong == 0 && row.outside.wrong == 0 && row.xiOverBound <= 1.0 &&
    row.backwardOverBound <= 1.0 && row.value.overBound <= 1.0 && row.gradient.overBound <= 1.0;
}

int Run(const std::filesystem::path& directory)
{
  std::filesystem::create_directories(directory);
  Results results;
  RunEvaluation(results);
  RunNodes(results);
  RunLocation(results);
  std::ofstream rows(directory / "rows.csv");
  WriteRows(results.rows, rows);
  std::ofstream location(directory / "location.csv");
  WriteScatter(results.location, location);
  std::ofstream evaluation(directory / "evaluation.csv");
  WriteScatter(results.evaluation, evaluation);
  std::ofstream table(directory / "table.md");
  WriteSummary(results.rows, table);
  int wrong = 0;
  for (const Row& row : results.rows)
  {
    if (!IsRight(row))
    {
      ++wrong;
      std::cout << "wrong: " << row.sweep << ", " << row.shape << ", " << row.parameter << ' '
                << row.at << std::endl;
    }
  }
  std::cout << results.rows.size() - wrong << " right, " << wrong << " wrong" << std::endl;
  return wrong == 0 ? 0 : 1;
}
} // namespace
} // namespace pixelexact::testing

int main(int argc, char** argv)
{
  if (argc != 2)
  {
    std::cerr << "usage: StabilityStudy DIRECTORY\n";
    return 2;
  }
  try
  {
    return pixelexact::testing::Run(argv[1]);
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
