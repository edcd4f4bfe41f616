// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/RootFile.h"

#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"
#include "Formats/FileText.h"
#include "Formats/MFEM/Text/PieceNames.h"
#include "Formats/MFEM/Text/QuadratureFile.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace pixelexact::mfem
{
namespace
{
using Json = nlohmann::json;

constexpr int kMaxPieces = 1000000; ///< as many as six digits can number

[[noreturn]] void Fail(const NamedText& file, const std::string& problem)
{
  throw InvalidData(file.name + ": " + problem);
}

const Json& Entry(const NamedText& file, const Json& parent, const char* name)
{
  const auto found = parent.is_object() ? parent.find(name) : parent.end();
  if (!parent.is_object() || found == parent.end())
  {
    Fail(file,
      std::string("the entry '") + name +
        "' is missing; the file is no root file of an MFEM collection, or is damaged.");
  }
  return *found;
}

/// A whole number, stored as a number or, in tags, as text.
int Integer(const NamedText& file, const Json& entry, const char* name, int low, int high)
{
  const double number = entry.is_number() ? entry.get<double>() : std::nan("");
  if (!(number >= low && number <= high && number == std::floor(number)))
  {
    Fail(file,
      std::string("the entry '") + name + "' is no whole number from " + std::to_string(low) +
        " to " + std::to_string(high) + ".");
  }
  return static_cast<int>(number);
}

/// The path of the first piece: "x.%06d" with 0 for the number.
std::string FirstPiece(const NamedText& file, const Json& parent)
{
  const Json& entry = Entry(file, parent, "path");
  std::string path = entry.is_string() ? entry.get<std::string>() : std::string();
  const auto at = path.find("%06d");
  if (path.empty() || at == std::string::npos || std::ranges::count(path, '%') != 1)
  {
    Fail(file,
      "the path '" + path.substr(0, 100) + "' should end with .%06d, for the number of a piece.");
  }
  return path.replace(at, 4, "000000");
}
} // namespace

RootFile ParseRootFile(const NamedText& file)
{
  const Json root = Json::parse(file.text, nullptr, false);
  if (root.is_discarded())
  {
    Fail(file, "this is no JSON; the file is damaged, or no root file of an MFEM collection.");
  }
  const Json& main = Entry(file, Entry(file, root, "dsets"), "main");
  RootFile result;
  result.cycle = Integer(file, Entry(file, main, "cycle"), "cycle", -1, 2000000000);
  const Json& time = Entry(file, main, "time");
  if (!time.is_number())
  {
    Fail(file, "the entry 'time' is no number.");
  }
  result.time = time.get<double>();
  result.pieces = Integer(file, Entry(file, main, "domains"), "domains", 1, kMaxPieces);
  result.mesh = FirstPiece(file, Entry(file, main, "mesh"));
  if (const auto fields = main.find("fields"); fields != main.end() && fields->is_object())
  {
    for (const auto& [name, field] : fields->items())
    {
      result.fields.push_back({ name, FirstPiece(file, field) });
    }
  }
  return result;
}

SolverModel ReadRootFile(const std::string& path, const PieceOf& part)
{
  const std::string text = ReadFileText(path);
  const RootFile root = ParseRootFile({ path, text });
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  const auto at = [&folder](const std::string& file) { return (folder / file).string(); };
  const std::vector<std::string> pieces = PiecesOf(at(root.mesh));
  if (static_cast<int>(pieces.size()) != root.pieces)
  {
    throw InvalidData(path + ": it lists " + Counted(root.pieces, "piece") +
      " of the mesh, but there are " + std::to_string(pieces.size()) + " files as " +
      pieces.front() + "; copy all of the collection, and nothing else, into its folder.");
  }
  std::vector<std::string> functions;
  std::vector<std::string> quadratures;
  for (const RootFile::Field& field : root.fields)
  {
    // The tag "assoc" is not reliable: solvers also write it for grid functions of one value per
    // element.
    const FileText begin(at(field.path));
    TextScanner scanner({ at(field.path), begin.Get(), &begin });
    (IsQuadratureFunction(scanner) ? quadratures : functions).push_back(at(field.path));
  }
  std::vector<std::string> all = functions;
  all.insert(all.end(), quadratures.begin(), quadratures.end());
  SolverModel model;
  try
  {
    model = ReadFiles(at(root.mesh), all, part);
  }
  catch (const UnreadQuadrature& error)
  {
    model = ReadFiles(at(root.mesh), functions, part);
    model.notes.push_back(std::string(error.what()) + " It is left out.");
  }
  model.time = root.time;
  return model;
}
} // namespace pixelexact::mfem
