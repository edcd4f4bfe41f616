// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Text/StreamCommands.h"

#include <algorithm>

namespace pixelexact::mfem
{
namespace
{
/// Of a process: its kind, a mesh's first lines.
constexpr std::size_t kShortestStream = 64;

/// Whether a line begins a mesh or a grid function.
bool BeginsData(std::string_view line)
{
  return line == "FiniteElementSpace" || line.starts_with("MFEM mesh v") ||
    line.starts_with("MFEM NC mesh v") || line.starts_with("MFEM NURBS mesh v") ||
    line.starts_with("MFEM INLINE mesh v") || line.starts_with("MFEM FiniteElementSpace v");
}

/// What may stand before a mesh in a stream.
bool IsStreamKeyword(std::string_view word)
{
  return word == "solution" || word == "mesh" || word == "fem3d_data" || word == "vfem3d_data" ||
    word == "fem3d_gf_data" || word == "vfem3d_gf_data" || word == "fem3d_gf_data_keys" ||
    word == "vfem3d_gf_data_keys";
}
} // namespace

bool IsStream(std::string_view head)
{
  constexpr std::string_view kBlank = " \t\r\n";
  head.remove_prefix(std::min(head.find_first_not_of(kBlank), head.size()));
  const std::string_view word = head.substr(0, head.find_first_of(kBlank));
  return word == "parallel" || word == "quadrature" || IsStreamKeyword(word);
}

StreamRank ReadStreamRank(TextScanner& scanner, int processes)
{
  scanner.Expect("parallel");
  StreamRank rank;
  // A process' stream has some lines.
  rank.processes = processes > 0 ? scanner.Integer("the number of processes")
                                 : scanner.Count("the number of processes", kShortestStream);
  rank.number = scanner.Integer("the number of the process", 0, std::max(0, rank.processes - 1));
  if (rank.processes < 1 || (processes > 0 && rank.processes != processes))
  {
    scanner.Fail("this stream is one of " + std::to_string(rank.processes) +
      " processes, those before it are of " + std::to_string(processes) + ".");
  }
  return rank;
}

bool ReadStreamKeyword(TextScanner& scanner)
{
  const std::string_view keyword = scanner.Peek();
  if (keyword == "quadrature")
  {
    scanner.FailUnsupported("quadrature functions, which have values at points of their own, are "
                            "not read; project the function to L2 and save that.");
  }
  if (!IsStreamKeyword(keyword))
  {
    scanner.Fail("this is no GLVis stream: it should begin with 'solution' or 'mesh'.");
  }
  scanner.Word("the kind of stream");
  return keyword != "mesh";
}

void SkipCommands(TextScanner& scanner, bool toNextProcess)
{
  if (double number = 0.0; scanner.TryNumber(number))
  {
    scanner.Fail("a number stands behind the end of the data; the file contradicts itself.");
  }
  while (!scanner.Peek().empty() && !(toNextProcess && scanner.Peek() == "parallel"))
  {
    if (BeginsData(scanner.RestOfLine()))
    {
      scanner.FailUnsupported("the stream goes on with another mesh or grid function; one of them "
                              "is read: save them as files of their own.");
    }
  }
}
} // namespace pixelexact::mfem
