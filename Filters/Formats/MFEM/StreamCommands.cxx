// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/StreamCommands.h"

namespace pixelexact::mfem
{
namespace
{
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

bool ReadStreamKeyword(TextScanner& scanner)
{
  const std::string_view keyword = scanner.Peek();
  if (keyword == "parallel" || keyword == "quadrature")
  {
    scanner.FailUnsupported("streams of the kind '" + std::string(keyword) +
      "' are not read; send the whole solution as one grid function.");
  }
  if (!IsStreamKeyword(keyword))
  {
    scanner.Fail("this is no GLVis stream: it should begin with 'solution' or 'mesh'.");
  }
  scanner.Word("the kind of stream");
  return keyword != "mesh";
}

void SkipCommands(TextScanner& scanner)
{
  if (double number = 0.0; scanner.TryNumber(number))
  {
    scanner.Fail("a number stands behind the end of the data; the file contradicts itself.");
  }
  while (!scanner.Peek().empty())
  {
    if (BeginsData(scanner.RestOfLine()))
    {
      scanner.FailUnsupported("the stream goes on with another mesh or grid function; one of them "
                              "is read: save them as files of their own.");
    }
  }
}
} // namespace pixelexact::mfem
