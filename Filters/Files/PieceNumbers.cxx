// SPDX-License-Identifier: BSD-3-Clause
#include "Files/PieceNumbers.h"

#include "Core/Base/Error.h"
#include "Parts/PartExchange.h"

#include "vtkCommunicator.h"
#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <numeric>

namespace pixelexact
{
vtkMultiProcessController* ProcessesOf(const PieceOf& part)
{
  auto* controller = vtkMultiProcessController::GetGlobalController();
  return !part.IsWhole() && controller != nullptr &&
      controller->GetNumberOfProcesses() == part.count &&
      controller->GetLocalProcessId() == part.piece
    ? controller
    : nullptr;
}

PieceOf PieceAskedFor(vtkInformation* asked)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (asked == nullptr || asked->Has(Pipeline::UPDATE_NUMBER_OF_PIECES()) == 0 ||
    asked->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) < 2)
  {
    return {};
  }
  return { asked->Get(Pipeline::UPDATE_PIECE_NUMBER()),
    asked->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) };
}

std::vector<std::int64_t> ElementsBefore(
  const PieceCounts& counts, const PieceOf& part, const std::string& problem)
{
  auto* processes = ProcessesOf(part);
  int pieces = counts.pieces;
  if (processes != nullptr)
  {
    AgreeThatAllIsWell(problem, processes);
    // Which some do not know: those without any.
    processes->AllReduce(&counts.pieces, &pieces, 1, vtkCommunicator::MAX_OP);
  }
  else if (!problem.empty())
  {
    throw Error(problem);
  }
  std::vector<long long> elements(static_cast<std::size_t>(pieces), 0);
  for (const auto& [piece, count] : counts.elements)
  {
    elements[static_cast<std::size_t>(piece)] = count;
  }
  if (processes != nullptr && !elements.empty())
  {
    const std::vector<long long> own = elements;
    processes->AllReduce(own.data(), elements.data(), static_cast<vtkIdType>(elements.size()),
      vtkCommunicator::SUM_OP);
  }
  std::vector<std::int64_t> before;
  for (const auto& [piece, count] : counts.elements)
  {
    before.push_back(std::accumulate(elements.begin(), elements.begin() + piece, 0LL));
  }
  return before;
}
} // namespace pixelexact
