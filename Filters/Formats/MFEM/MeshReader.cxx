// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/MeshReader.h"

#include "Formats/MFEM/Meshes/ConformingMesh.h"
#include "Formats/MFEM/Meshes/InlineMesh.h"
#include "Formats/MFEM/Meshes/RefinementForest.h"
#include "Formats/MFEM/Nurbs/NurbsMesh.h"
#include "Formats/MFEM/Text/MeshFormat.h"

namespace pixelexact::mfem
{
MeshFile ReadMesh(TextScanner& scanner)
{
  switch (ReadMeshFormat(scanner))
  {
    case MeshFormat::Nonconforming:
      return ReadNonconforming(scanner, false);
    case MeshFormat::NonconformingScaled:
      return ReadNonconforming(scanner, true);
    case MeshFormat::Inline:
      return ReadInline(scanner);
    case MeshFormat::Nurbs:
      return ReadNurbs(scanner, false);
    case MeshFormat::NurbsSpaced:
      return ReadNurbs(scanner, true);
    case MeshFormat::Legacy:
      return ReadConforming(scanner, true);
    default:
      return ReadConforming(scanner, false);
  }
}
} // namespace pixelexact::mfem
