// SPDX-License-Identifier: BSD-3-Clause
// Derivatives in expressions, on solvers' elements. What is expected is differentiated in long
// double (LongDual.h) and shares nothing with the kernels, or is the solver's own gradient.
#include "NektarModes.h"

#include "Core/Expression/Expression.h"
#include "Formats/FileText.h"
#include "Formats/Gmsh/Reader.h"
#include "Formats/MFEM/Reader.h"
#include "Formats/Nektar/Reader.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <sstream>

namespace pixelexact::testing
{
namespace
{
constexpr long double kMaxError = 1e-12L; ///< of a quantity, by its range

/// Three functions of the fields, as an expression and as what is expected of it.
struct VectorOfFields
{
  std::string scalar; ///< the first of the three, as an expression
  std::string vector;
  std::function<SlopeTriple(const KnownPoint&)> exact;
};

VectorOfFields FromOneField(const std::string& u)
{
  return { u, "vec(" + u + ", " + u + "*" + u + ", x*" + u + ")", [](const KnownPoint& at) {
            return SlopeTriple{ at.values[0], at.values[0] * at.values[0], at.x[0] * at.values[0] };
          } };
}

/// Fields `first`, `first` + 1 and `first` + 2.
VectorOfFields FromThreeValues(const std::string& scalar, const std::string& vector, int first = 0)
{
  return { scalar, vector, [first](const KnownPoint& at) {
            return SlopeTriple{ at.values[first], at.values[first + 1], at.values[first + 2] };
          } };
}

std::string DataPath(const std::string& folder, const std::string& file)
{
  return std::string(PIXELEXACT_DATA_DIR) + "/" + folder + "/" + file;
}

/// The files of a folder in Data/: its mesh, named as the folder, and those of the fields.
SolverModel LoadFolder(const std::string& folder, const std::vector<std::string>& fields)
{
  std::vector<std::string> paths(fields.size());
  std::ranges::transform(
    fields, paths.begin(), [&](const std::string& field) { return DataPath(folder, field); });
  if (folder.starts_with("mfem"))
  {
    return mfem::ReadFiles(DataPath(folder, folder + ".mesh"), paths);
  }
  if (folder.starts_with("gmsh"))
  {
    return gmsh::Read(FileTexts({ DataPath(folder, folder + ".msh") }).Named);
  }
  return nektar::Read(
    FileTexts({ DataPath(folder, folder + ".xml") }).Named, FileTexts(paths).Named);
}

/// The largest error over the points, by the range of `exact` over all its components.
long double ErrorOf(const SolverModel& model, const std::vector<KnownPoint>& points,
  const std::string& text, const std::function<std::vector<long double>(const KnownPoint&)>& exact)
{
  std::vector<Field> fields;
  for (const SolverField& field : model.fields)
  {
    fields.push_back({ field.name, field.values.View(), field.mapping });
  }
  ExpressionScope scope;
  scope.fields = fields;
  Field field{ text, {}, Mapping::Identity, MakeExpression(text, scope) };
  field.values.components = field.function->Components();
  const Mesh mesh = ViewOf(model.mesh);
  long double worst = 0.0L;
  std::vector<long double> lower;
  std::vector<long double> upper;
  for (const KnownPoint& point : points)
  {
    const std::vector<long double> expected = exact(point);
    std::vector<double> found(field.values.components);
    EXPECT_EQ(found.size(), expected.size()) << text;
    EvaluateAt(mesh, field, point.element, std::span(&point.xi, 1), found, {});
    lower = lower.empty() ? expected : lower;
    upper = upper.empty() ? expected : upper;
    for (std::size_t c = 0; c < expected.size(); ++c)
    {
      lower[c] = std::min(lower[c], expected[c]);
      upper[c] = std::max(upper[c], expected[c]);
      EXPECT_TRUE(std::isfinite(found.at(c))) << text;
      worst = std::max(worst, std::fabs(found.at(c) - expected[c]));
    }
  }
  long double range = 0.0L;
  for (std::size_t c = 0; c < lower.size(); ++c)
  {
    range = std::max(range, upper[c] - lower[c]);
  }
  return worst / range;
}

void ExpectDerivatives(const std::string& name, const SolverModel& model,
  const std::vector<KnownPoint>& points, const VectorOfFields& v)
{
  ASSERT_GE(points.size(), 100U) << name;
  using Numbers = std::vector<long double>;
  const long double gradient = ErrorOf(model, points, "grad(" + v.scalar + ")",
    [&](const KnownPoint& at)
    {
      const auto slope = v.exact(at)[0].derivative;
      return Numbers(slope.begin(), slope.end());
    });
  const long double vorticity = ErrorOf(model, points, "vorticity(" + v.vector + ")",
    [&](const KnownPoint& at)
    {
      const auto [a, b, c] = v.exact(at);
      return Numbers{ c.derivative[1] - b.derivative[2], a.derivative[2] - c.derivative[0],
        b.derivative[0] - a.derivative[1] };
    });
  const long double q = ErrorOf(model, points, "Q(" + v.vector + ")",
    [&](const KnownPoint& at)
    {
      // (|W|^2 - |S|^2) / 2 is minus half the trace of the gradient's square.
      const SlopeTriple f = v.exact(at);
      long double traceOfSquare = 0.0L;
      for (int i = 0; i < 3; ++i)
      {
        for (int j = 0; j < 3; ++j)
        {
          traceOfSquare += f[i].derivative[j] * f[j].derivative[i];
        }
      }
      return Numbers{ -traceOfSquare / 2 };
    });
  std::printf("[ measured ] %-44s %4zu points, gradient %.1Le vorticity %.1Le Q %.1Le\n",
    (name + " " + v.vector).c_str(), points.size(), gradient, vorticity, q);
  EXPECT_LE(gradient, kMaxError) << name;
  EXPECT_LE(vorticity, kMaxError) << name;
  EXPECT_LE(q, kMaxError) << name;
}

/// The rows of an oracle: place, value and gradient as the solver's library computed them.
std::vector<KnownPoint> PointsFromOracle(const SolverModel& model, const std::string& path)
{
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  EXPECT_TRUE(line.starts_with("x,y,z,element,type,r,s,t,u,dudx,dudy,dudz")) << path;
  std::vector<KnownPoint> points;
  while (std::getline(file, line))
  {
    std::vector<double> row;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');)
    {
      row.push_back(std::strtod(cell.c_str(), nullptr)); // 0 for the shape's name
    }
    KnownPoint point{ ElementNumbered(model, std::llround(row[3])), {}, {}, {} };
    const Vec3 at(2 * row[5] - 1, 2 * row[6] - 1, 2 * row[7] - 1);
    point.xi =
      ViewOf(model.mesh).ShapeOf(point.element) == Shape::Prism ? Vec3(at.x, -at.z, at.y) : at;
    point.x = VariablesAt({ row[0], row[1], row[2] });
    point.values.emplace_back(row[8], std::array<long double, 3>{ row[9], row[10], row[11] });
    points.push_back(point);
  }
  return points;
}
} // namespace

TEST(ExpressionDerivatives, AreThoseOfTheStoredCoefficients)
{
  struct Folder
  {
    std::string name;
    std::vector<std::string> fields;
    VectorOfFields vector;
  };
  const VectorOfFields u = FromOneField("u");
  const VectorOfFields flow = FromThreeValues("u", "vec(u, v, w)");
  for (const Folder& folder : {
         Folder{ "nek_hex_aniso_p3p5p7", { "nek_hex_aniso_p3p5p7.fld" }, u },
         Folder{ "nek_hex_gll_lagrange_p6", { "nek_hex_gll_lagrange_p6.fld" }, u },
         Folder{ "nek_prism_curved_p7", { "nek_prism_curved_p7.fld" }, u },
         Folder{ "nek_pyramid_curved_p6", { "nek_pyramid_curved_p6.fld" }, u },
         Folder{ "nek_tet_varp", { "nek_tet_varp.fld" }, u },
         Folder{ "nek_homogeneous_chan", { "nek_homogeneous_chan.fld" }, u },
         Folder{ "nek_half_mode", { "nek_half_mode.fld" }, flow },
         Folder{ "mfem49_tinyzoo_g3_p5", { "u.gf" }, u },
         Folder{ "mfem_escher_tet_darcy_p3", { "pressure.gf" }, FromOneField("pressure") },
         Folder{ "mfem_escher_tet_darcy_p3", { "flux.gf" }, FromThreeValues("flux.x", "flux") },
         Folder{ "mfem_nurbs_pipe", { "u.gf" }, u },
         Folder{ "mfem_plane_amr_g3_p5", { "circulation.gf" },
           FromThreeValues("circulation.x", "circulation") },
         Folder{ "gmsh_zoo_g4", {}, u },
         Folder{ "gmsh_zoo_g4", {}, FromThreeValues("v.x", "v", 1) },
       })
  {
    const SolverModel model = LoadFolder(folder.name, folder.fields);
    std::vector<KnownPoint> points;
    for (int e = 0; e < static_cast<int>(model.mesh.number.size()); ++e)
    {
      for (const Vec3& xi :
        PointsOfElement(ViewOf(model.mesh).ShapeOf(e), e, PointsForEach(model), true))
      {
        points.push_back(PointFromModel(model, e, xi));
      }
    }
    ExpectDerivatives(folder.name, model, points, folder.vector);
  }
}

TEST(ExpressionDerivatives, AreThoseOfNektarsOwnBasis)
{
  for (const std::string folder : { "nek_hex_aniso_p3p5p7", "nek_prism_curved_p7",
         "nek_pyramid_curved_p6", "nek_tet_varp", "nek_homogeneous_chan", "nek_half_mode" })
  {
    const SolverModel model = LoadFolder(folder, { folder + ".fld" });
    const bool isFlow = folder == "nek_half_mode";
    ExpectDerivatives(folder, model, PointsFromNektarFile(model, DataPath(folder, folder + ".fld")),
      isFlow ? FromThreeValues("u", "vec(u, v, w)") : FromOneField("u"));
  }
}

TEST(ExpressionDerivatives, AreTheSolversOwn)
{
  for (const auto& [folder, field] : {
         std::pair<std::string, std::string>{ "mfem49_tinyzoo_g3_p5", "u" },
         { "mfem_escher_tet_darcy_p3", "pressure" },
         { "gmsh_shell_tet_g3", "u" },
         { "gmsh_zoo_g2", "u" },
         { "gmsh_zoo_g4", "u" },
       })
  {
    const bool isGmsh = folder.starts_with("gmsh");
    const SolverModel model = LoadFolder(folder, { field + ".gf" });
    const std::string oracle = isGmsh ? "oracle.csv" : "oracle_" + field + ".csv";
    ExpectDerivatives(
      folder, model, PointsFromOracle(model, DataPath(folder, oracle)), FromOneField(field));
  }
}
} // namespace pixelexact::testing
