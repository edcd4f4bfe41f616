// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Reader.h"

#include "Core/Base/Error.h"
#include "Formats/MFEM/Meshes/MeshFile.h"
#include "Formats/MFEM/ModelBuilder.h"
#include "Formats/MFEM/Nurbs/NurbsMesh.h"
#include "Formats/MFEM/Text/PieceNames.h"
#include "Formats/MFEM/Text/QuadratureFile.h"
#include "Formats/MFEM/Text/TextScanner.h"

#include <algorithm>
#include <optional>

namespace pixelexact::mfem
{
namespace
{
// Lines around the data in a GLVis stream.

/// The number of processes, and the process that wrote a stream.
struct StreamRank
{
  int processes = 1;
  int number = 0;
};

/// Fewest bytes of one process' stream: its keyword and the first lines of a mesh.
constexpr std::size_t kShortestStream = 64;

/// Whether a line begins a mesh or a grid function.
bool BeginsData(std::string_view line)
{
  return line == "FiniteElementSpace" || line.starts_with("MFEM mesh v") ||
    line.starts_with("MFEM NC mesh v") || line.starts_with("MFEM NURBS mesh v") ||
    line.starts_with("MFEM INLINE mesh v") || line.starts_with("MFEM FiniteElementSpace v");
}

/// Whether a word may precede a mesh in a stream.
bool IsStreamKeyword(std::string_view word)
{
  return word == "solution" || word == "quadrature" || word == "mesh" || word == "fem3d_data" ||
    word == "vfem3d_data" || word == "fem3d_gf_data" || word == "vfem3d_gf_data" ||
    word == "fem3d_gf_data_keys" || word == "vfem3d_gf_data_keys";
}

/// Reads "parallel n i". `processes`: the number in earlier streams, 0 before the first one. Throws
/// InvalidData where they differ.
StreamRank ReadStreamRank(TextScanner& scanner, int processes)
{
  scanner.Expect("parallel");
  StreamRank rank;
  // Every process' stream has at least kShortestStream bytes.
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

/// Reads the word before the mesh. Returns whether a grid function or a quadrature function follows
/// the mesh. Throws InvalidData where this is not a stream.
bool ReadStreamKeyword(TextScanner& scanner)
{
  const std::string_view keyword = scanner.Peek();
  if (!IsStreamKeyword(keyword))
  {
    scanner.Fail("this is no GLVis stream: it should begin with 'solution' or 'mesh'.");
  }
  scanner.Word("the kind of stream");
  return keyword != "mesh";
}

/// Skips the commands to GLVis after the data, up to the stream of another process where
/// `toNextProcess`. Throws Unsupported where another mesh or grid function follows, InvalidData for
/// numbers.
void SkipCommands(TextScanner& scanner, bool toNextProcess = false)
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

/// Reads a mesh of any version; the text after it stays in the scanner. Throws InvalidData and
/// Unsupported.
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

/// Throws where a mesh is a piece of more processes than there are pieces.
void RequireRanks(const TextScanner& scanner, const MeshFile& mesh, int pieces)
{
  if (mesh.ranks > pieces)
  {
    RefusePiece(scanner, mesh.ranks, pieces);
  }
}

/// Throws InvalidData where a piece shares entities with another one that does not share with it.
void RequireOneRun(const std::vector<MeshPiece>& pieces)
{
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    for (const int other : pieces[p].file.sharing)
    {
      // RequireRanks has refused processes without a piece.
      const MeshPiece& shared = pieces[static_cast<std::size_t>(other)];
      if (!shared.file.sharing.contains(static_cast<int>(p)))
      {
        throw InvalidData(pieces[p].name + " shares its border with " + shared.name +
          ", which knows nothing of that; they are of different runs: remove what an earlier one "
          "has left.");
      }
    }
  }
}

MeshFile ParseMesh(const NamedText& text, int pieces)
{
  TextScanner scanner(text);
  MeshFile mesh = ReadMesh(scanner);
  if (!scanner.Peek().empty())
  {
    scanner.FailAtWord("behind the end of the mesh");
  }
  RequireRanks(scanner, mesh, pieces);
  return mesh;
}

/// Whether the mesh is NURBS. Pieces of a NURBS mesh are joined to one model, which is cut after
/// reading.
bool IsNurbs(const std::string& mesh)
{
  const FileText text(mesh);
  TextScanner scanner({ mesh, text.Get(), &text });
  const MeshFormat format = ReadMeshFormat(scanner);
  return format == MeshFormat::Nurbs || format == MeshFormat::NurbsSpaced;
}

GridFunctionFile ParseGridFunction(const NamedText& text)
{
  TextScanner scanner(text);
  GridFunctionFile file = ReadAnyGridFunction(scanner);
  if (!scanner.Peek().empty())
  {
    scanner.FailAtWord("among the numbers behind the header");
  }
  return file;
}

/// Adds the pieces of a field; a complex field becomes two: real and imaginary part.
void AddField(ModelBuilder& builder, const std::vector<GridFunctionFile>& pieces,
  const std::vector<std::string>& files, const std::string& name)
{
  const auto complex = std::ranges::count(pieces, true, &GridFunctionFile::isComplex);
  if (complex == 0)
  {
    builder.AddField(pieces, files, name);
    if (pieces.front().quadraturePoints != 0)
    {
      const std::string basis = DescribeQuadrature(pieces.front());
      builder.Model.fields.back().basis = basis;
      builder.Model.notes.push_back(
        files.front() + ": " + basis + "; between them it is the polynomial through them.");
    }
    return;
  }
  if (complex != std::ssize(pieces))
  {
    throw InvalidData(
      files.front() + ": some pieces of the grid function are complex, and others are not.");
  }
  std::vector<GridFunctionFile> real;
  std::vector<GridFunctionFile> imaginary;
  for (const GridFunctionFile& piece : pieces)
  {
    auto [first, second] = PartsOf(piece);
    real.push_back(std::move(first));
    imaginary.push_back(std::move(second));
  }
  builder.AddField(real, files, name + "_real");
  builder.AddField(imaginary, files, name + "_imag");
}

/// One process' part of a stream.
struct StreamPiece
{
  MeshPiece mesh;
  std::optional<GridFunctionFile> field;
};

StreamPiece ReadStreamPiece(TextScanner& scanner, int pieces)
{
  const bool hasField = ReadStreamKeyword(scanner);
  StreamPiece piece{ { ReadMesh(scanner), scanner.Name() }, std::nullopt };
  RequireRanks(scanner, piece.mesh.file, pieces);
  if (scanner.Peek() == "mfem_mesh_end")
  {
    scanner.Word("the end of the mesh");
  }
  if (hasField)
  {
    piece.field = ReadAnyGridFunction(scanner);
  }
  return piece;
}

/// The parts of all processes, in their order.
std::vector<StreamPiece> ReadStreamPieces(TextScanner& scanner)
{
  std::vector<StreamPiece> pieces;
  if (scanner.Peek() != "parallel")
  {
    pieces.push_back(ReadStreamPiece(scanner, 1));
    return pieces;
  }
  std::vector<std::optional<StreamPiece>> found;
  while (scanner.Peek() == "parallel")
  {
    const StreamRank rank = ReadStreamRank(scanner, static_cast<int>(found.size()));
    found.resize(static_cast<std::size_t>(rank.processes));
    auto& place = found[static_cast<std::size_t>(rank.number)];
    if (place)
    {
      scanner.Fail("the stream of process " + std::to_string(rank.number) + " is there twice.");
    }
    place = ReadStreamPiece(scanner, rank.processes);
    SkipCommands(scanner, true);
  }
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    if (!found[i])
    {
      scanner.Fail("the streams of " + std::to_string(found.size()) +
        " processes should be here, but that of process " + std::to_string(i) +
        " is missing; save the streams of all.");
    }
    pieces.push_back(std::move(*found[i]));
  }
  return pieces;
}
} // namespace

bool IsStream(std::string_view head)
{
  constexpr std::string_view kBlank = " \t\r\n";
  head.remove_prefix(std::min(head.find_first_not_of(kBlank), head.size()));
  const std::string_view word = head.substr(0, head.find_first_of(kBlank));
  return word == "parallel" || IsStreamKeyword(word);
}

SolverModel Read(const NamedText& mesh, const std::vector<NamedText>& gridFunctions)
{
  std::vector<MeshPiece> pieces;
  pieces.push_back({ ParseMesh(mesh, 1), mesh.name });
  ModelBuilder builder(std::move(pieces));
  for (const NamedText& text : gridFunctions)
  {
    AddField(builder, { ParseGridFunction(text) }, { text.name }, FieldName(text.name));
  }
  return std::move(builder.Model);
}

SolverModel ReadFiles(
  const std::string& mesh, const std::vector<std::string>& gridFunctions, const PieceOf& part)
{
  const std::vector<std::string> names = PiecesOf(mesh);
  const auto count = static_cast<int>(names.size());
  if (!part.IsWhole() && (count == 1 || IsNurbs(names.front())))
  {
    return ReadFiles(mesh, gridFunctions);
  }
  const bool whole = part.IsWhole();
  std::vector<ReadPiece> read;
  std::vector<MeshPiece> pieces;
  const auto [first, end] = part.Of(count);
  for (auto p = static_cast<int>(first); p < static_cast<int>(end); ++p)
  {
    const std::string& name = names[static_cast<std::size_t>(p)];
    const FileText text(name);
    pieces.push_back({ ParseMesh({ name, text.Get(), &text }, count), name });
    read.push_back({ p, 0 });
  }
  if (pieces.empty())
  {
    SolverModel nothing;
    nothing.piecesOfRun = count;
    return nothing;
  }
  if (whole)
  {
    RequireOneRun(pieces);
  }
  ModelBuilder builder(std::move(pieces));
  for (const std::string& file : gridFunctions)
  {
    const std::vector<std::string> all = PiecesOf(file, count, mesh);
    std::vector<std::string> parts;
    std::vector<GridFunctionFile> functions;
    for (const ReadPiece& piece : read)
    {
      const std::string& name = parts.emplace_back(all[static_cast<std::size_t>(piece.piece)]);
      const FileText text(name);
      functions.push_back(ParseGridFunction({ name, text.Get(), &text }));
    }
    AddField(builder, functions, parts, FieldName(file));
  }
  if (!whole)
  {
    for (std::size_t p = 0; p < read.size(); ++p)
    {
      read[p].elements = builder.ElementsOf(static_cast<std::int32_t>(p));
    }
    builder.Model.pieces = std::move(read);
    builder.Model.piecesOfRun = count;
  }
  return std::move(builder.Model);
}

SolverModel ReadStream(const NamedText& saved)
{
  TextScanner scanner(saved);
  std::vector<StreamPiece> streams = ReadStreamPieces(scanner);
  std::vector<MeshPiece> pieces;
  std::vector<GridFunctionFile> functions;
  for (StreamPiece& stream : streams)
  {
    if (stream.field)
    {
      functions.push_back(std::move(*stream.field));
    }
    pieces.push_back(std::move(stream.mesh));
  }
  const std::size_t count = pieces.size();
  ModelBuilder builder(std::move(pieces));
  if (!functions.empty() && functions.size() != count)
  {
    scanner.Fail("some of the processes sent a grid function, and some did not.");
  }
  if (!functions.empty())
  {
    AddField(
      builder, functions, std::vector<std::string>(functions.size(), saved.name), "solution");
  }
  SkipCommands(scanner);
  return std::move(builder.Model);
}
} // namespace pixelexact::mfem
