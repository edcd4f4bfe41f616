// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

class vtkUnstructuredGrid;

namespace pixelexact
{
class HighOrderModel;
class Table;

/// Data of a solver's own file in addition to mesh and coefficients.
struct SolverFacts
{
  struct Group
  {
    int id = 0;
    bool boundary = false;
    std::string name;
  };
  std::map<int, std::int64_t> attributes;         ///< elements by attribute or composite
  std::map<int, std::int64_t> boundaryAttributes; ///< elements' faces, both of a pair
  std::vector<Group> groups;                      ///< those with names
};

SolverFacts GatherSolverFacts(vtkUnstructuredGrid& grid, const HighOrderModel& model);

/// The basis that the solver's file names for a field; empty where it names none.
std::string BasisOf(vtkUnstructuredGrid& grid, const std::string& field);

void AddTo(Table& table, const SolverFacts& facts);
void AddTo(nlohmann::ordered_json& summary, const SolverFacts& facts);
} // namespace pixelexact
