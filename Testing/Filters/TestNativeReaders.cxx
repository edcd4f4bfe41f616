// SPDX-License-Identifier: BSD-3-Clause
// What the readers of solvers' own files do beside giving the right numbers: round trips, time
// steps, selection, refusals.
#include "OracleCheck.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkGLVisReader.h"
#include "vtkGmshReader.h"
#include "vtkInformation.h"
#include "vtkMFEMReader.h"
#include "vtkNekReader.h"
#include "vtkNektarReader.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"
#include "vtkThreshold.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <cstring>
#include <random>

namespace
{
using namespace pixelexact;
using namespace pixelexact::testing;

/// The solver stops that near its exact solution.
constexpr double kHalfModeError = 5e-13;

std::string Text(const std::filesystem::path& file)
{
  std::ifstream in(file, std::ios::binary);
  return { std::istreambuf_iterator<char>(in), {} };
}

/// A folder that goes with the test.
class Scratch
{
public:
  Scratch()
    : Folder(std::filesystem::temp_directory_path() /
        ("pixelexact-" +
          std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()) +
          std::to_string(std::random_device()())))
  {
    std::filesystem::create_directories(Folder);
  }
  ~Scratch() { std::filesystem::remove_all(Folder); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  std::string Write(const std::string& name, const std::string& text) const
  {
    const auto file = Folder / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
    return file.string();
  }
  [[nodiscard]] std::string Path(const std::string& name) const { return (Folder / name).string(); }

private:
  std::filesystem::path Folder;
};

vtkSmartPointer<vtkMFEMReader> MakeDarcyReader()
{
  const auto folder = kData / "mfem_escher_tet_darcy_p3";
  auto reader = vtkSmartPointer<vtkMFEMReader>::New();
  reader->SetFileName((folder / "mfem_escher_tet_darcy_p3.mesh").c_str());
  reader->AddGridFunctionFileName((folder / "pressure.gf").c_str());
  reader->AddGridFunctionFileName((folder / "flux.gf").c_str());
  return reader;
}

vtkSmartPointer<vtkMFEMReader> Zoo()
{
  const auto folder = kData / "mfem49_tinyzoo_g3_p5";
  auto reader = vtkSmartPointer<vtkMFEMReader>::New();
  reader->SetFileName((folder / "mfem49_tinyzoo_g3_p5.mesh").c_str());
  reader->AddGridFunctionFileName((folder / "u.gf").c_str());
  return reader;
}

vtkSmartPointer<vtkNektarReader> VariableOrder()
{
  const auto folder = kData / "nek_tet_varp";
  auto reader = vtkSmartPointer<vtkNektarReader>::New();
  reader->SetFileName((folder / "nek_tet_varp.xml").c_str());
  reader->AddFieldFileName((folder / "nek_tet_varp.fld").c_str());
  return reader;
}

template <class T>
void ExpectSameBytes(std::span<const T> a, std::span<const T> b, const std::string& what)
{
  ASSERT_EQ(a.size(), b.size()) << what;
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size_bytes()), 0) << what;
}

void ExpectSame(const Expansion& a, const Expansion& b, const std::string& what)
{
  ExpectSameBytes(a.spaces, b.spaces, what);
  ExpectSameBytes(a.spaceOf, b.spaceOf, what);
  ExpectSameBytes(a.offset, b.offset, what);
  ExpectSameBytes(a.coefficients, b.coefficients, what);
  EXPECT_EQ(a.components, b.components) << what;
}

/// Writes a compressed .vtu and reads it: every bit of mesh and fields is the same.
void ExpectRoundTrip(vtkHighOrderFileReader* reader)
{
  vtkNew<Messages> messages;
  messages->Watch(reader);
  reader->Update();
  ASSERT_EQ(messages->errors, "");
  const Scratch scratch;
  const std::string file = scratch.Path("saved.vtu");
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(reader->GetHighOrderOutput());
  writer->SetFileName(file.c_str());
  writer->SetCompressorTypeToZLib();
  ASSERT_EQ(writer->Write(), 1);

  const auto back = ReadGrid(file);
  const auto before = HighOrderModel::From(reader->GetHighOrderOutput());
  const auto after = HighOrderModel::From(back);
  ExpectSame(before->GetMesh().map, after->GetMesh().map, "map");
  ExpectSameBytes(before->GetMesh().centre, after->GetMesh().centre, "centre");
  ExpectSameBytes(before->GetMesh().size, after->GetMesh().size, "size");
  ExpectSameBytes(before->GetMesh().uncertainty, after->GetMesh().uncertainty, "uncertainty");
  ExpectSameBytes(before->SourceCells(), after->SourceCells(), "source cells");
  EXPECT_TRUE(std::ranges::equal(before->BoundaryFaces(), after->BoundaryFaces()));
  EXPECT_FALSE(after->BoundaryFaces().empty());
  ASSERT_EQ(before->Fields().size(), after->Fields().size());
  for (std::size_t f = 0; f < before->Fields().size(); ++f)
  {
    const Field& field = before->Fields()[f];
    EXPECT_EQ(field.name, after->Fields()[f].name);
    EXPECT_EQ(field.mapping, after->Fields()[f].mapping);
    ExpectSame(field.values, after->Fields()[f].values, field.name);
  }
}

void ExpectTimes(vtkHighOrderFileReader* reader, double first, double second)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  reader->UpdateInformation();
  vtkInformation* information = reader->GetOutputInformation(0);
  ASSERT_EQ(information->Length(Pipeline::TIME_STEPS()), 2);
  EXPECT_EQ(information->Get(Pipeline::TIME_STEPS())[0], first);
  EXPECT_EQ(information->Get(Pipeline::TIME_STEPS())[1], second);
}

TEST(NativeReaders, RoundTripOfVectorElements)
{
  ExpectRoundTrip(MakeDarcyReader());
}

TEST(NativeReaders, RoundTripOfAllShapes)
{
  ExpectRoundTrip(Zoo());
}

TEST(NativeReaders, RoundTripOfVariableOrder)
{
  ExpectRoundTrip(VariableOrder());
}

TEST(NativeReaders, ReportTheBasesAndTheGroups)
{
  const auto reader = MakeDarcyReader();
  reader->Update();
  vtkUnstructuredGrid* grid = reader->GetOutput();
  auto* basis = vtkStringArray::SafeDownCast(
    grid->GetFieldData()->GetAbstractArray("PixelExact.Field.flux.Basis"));
  ASSERT_NE(basis, nullptr);
  EXPECT_NE(basis->GetValue(0).find("H(div)"), std::string::npos) << basis->GetValue(0);
  EXPECT_NE(grid->GetCellData()->GetArray("Attribute"), nullptr);
  // The mesh's 48 boundary triangles have attributes.
  vtkDataArray* boundary = grid->GetCellData()->GetArray("BoundaryAttribute");
  ASSERT_NE(boundary, nullptr);
  int faces = 0;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    for (int face = 0; face < boundary->GetNumberOfComponents(); ++face)
    {
      faces += boundary->GetComponent(cell, face) >= 0.0 ? 1 : 0;
    }
  }
  EXPECT_EQ(faces, 48);
}

TEST(NativeReaders, CellsSelectedByVtkKeepTheirCoefficients)
{
  const auto reader = Zoo();
  vtkNew<vtkThreshold> threshold;
  threshold->SetInputConnection(reader->GetOutputPort());
  threshold->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "PixelExactElementId");
  threshold->SetThresholdFunction(vtkThreshold::THRESHOLD_BETWEEN);
  threshold->SetLowerThreshold(2);
  threshold->SetUpperThreshold(2);
  threshold->Update();
  vtkUnstructuredGrid* grid = threshold->GetOutput();
  ASSERT_EQ(grid->GetNumberOfCells(), 1);
  const Table table = ReadTable(kData / "mfem49_tinyzoo_g3_p5" / "oracle_u.csv");
  const auto model = HighOrderModel::From(grid);
  const Shape shape = model->GetMesh().ShapeOf(0);
  EXPECT_EQ(shape, Shape::Pyramid);
  int points = 0;
  for (std::size_t i = 0; i < table.at("u").size(); ++i)
  {
    if (table.at("element")[i] == 2.0)
    {
      const Vec3 xi = OracleXi(table, shape, i);
      double value = 0.0;
      EvaluateAt(
        model->GetMesh(), *model->FindField("u"), 0, std::span(&xi, 1), std::span(&value, 1), {});
      EXPECT_NEAR(value, table.at("u")[i], 1e-12);
      ++points;
    }
  }
  EXPECT_GT(points, 10);
}

/// Checks that the reader reports `expected` and returns nothing.
void ExpectRefusal(vtkHighOrderFileReader* reader, const std::string& expected)
{
  vtkNew<Messages> messages;
  messages->Watch(reader);
  reader->Update();
  EXPECT_NE(messages->errors.find(expected), std::string::npos) << messages->errors;
  EXPECT_EQ(reader->GetOutput()->GetNumberOfCells(), 0);
}

TEST(NativeReaders, FieldFilesAreTimeSteps)
{
  // The same field at two times, the second one given first.
  const auto folder = kData / "nek_hex_aniso_p3p5p7";
  const std::string field = Text(folder / "nek_hex_aniso_p3p5p7.fld");
  const auto withTime = [&](const std::string& time)
  {
    std::string text = field;
    text.insert(text.find("</Metadata>"), "<Time>" + time + "</Time>");
    return text;
  };
  const Scratch scratch;
  vtkNew<vtkNektarReader> reader;
  reader->SetFileName((folder / "nek_hex_aniso_p3p5p7.xml").c_str());
  reader->AddFieldFileName(scratch.Write("b.chk", withTime("2.5")).c_str());
  reader->AddFieldFileName(scratch.Write("a.chk", withTime("0.5")).c_str());
  ExpectTimes(reader, 0.5, 2.5);

  reader->UpdateTimeStep(0.5);
  const auto first = HighOrderModel::From(reader->GetHighOrderOutput());
  const Locator* locator = &first->GetLocator();
  reader->UpdateTimeStep(2.5);
  const auto second = HighOrderModel::From(reader->GetHighOrderOutput());
  EXPECT_EQ(
    reader->GetHighOrderOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), 2.5);
  EXPECT_NE(first, second);
  EXPECT_EQ(locator, &second->GetLocator());

  for (const char* time : { "0.5x", "1 2", "soon", "" })
  {
    vtkNew<vtkNektarReader> wrong;
    wrong->SetFileName((folder / "nek_hex_aniso_p3p5p7.xml").c_str());
    wrong->AddFieldFileName(scratch.Write("wrong.chk", withTime(time)).c_str());
    ExpectRefusal(wrong, "wrong.chk, <Time>");
  }
}

TEST(NativeReaders, FoldersOfPartsAreOneField)
{
  // The two shapes of a mixed mesh cannot be had from Data/: one part is enough to be a folder.
  const auto folder = kData / "nek_tet_varp";
  const Scratch scratch;
  scratch.Write("u.fld/P0000000.fld", Text(folder / "nek_tet_varp.fld"));
  vtkNew<vtkNektarReader> reader;
  vtkNew<Messages> messages;
  messages->Watch(reader);
  scratch.Write("mesh_xml/P0000000.xml", Text(folder / "nek_tet_varp.xml"));
  reader->SetFileName(scratch.Path("mesh_xml").c_str());
  reader->AddFieldFileName(scratch.Path("u.fld").c_str());
  reader->Update();
  ASSERT_EQ(messages->errors, "");
  EXPECT_NE(HighOrderModel::From(reader->GetHighOrderOutput())->FindField("u"), nullptr);
}

TEST(NativeReaders, RefuseAFieldOfAnotherMesh)
{
  const auto reader = MakeDarcyReader();
  reader->AddGridFunctionFileName((kData / "mfem49_tinyzoo_g3_p5" / "u.gf").c_str());
  ExpectRefusal(reader, "u.gf");

  const auto nektar = VariableOrder();
  nektar->ClearFieldFileNames();
  nektar->AddFieldFileName((kData / "nek_hex_aniso_p3p5p7" / "nek_hex_aniso_p3p5p7.fld").c_str());
  ExpectRefusal(nektar, "nek_hex_aniso_p3p5p7.fld");
}

TEST(NativeReaders, RefuseWhatIsNotThere)
{
  vtkNew<vtkMFEMReader> unnamed;
  ExpectRefusal(unnamed, "SetFileName");
  vtkNew<vtkMFEMReader> missing;
  missing->SetFileName("/nowhere/a.mesh");
  ExpectRefusal(missing, "/nowhere/a.mesh");
  const auto twice = MakeDarcyReader();
  twice->AddGridFunctionFileName((kData / "mfem_escher_tet_darcy_p3" / "pressure.gf").c_str());
  ExpectRefusal(twice, "pressure");
}

TEST(NativeReaders, PiecesAreOneMesh)
{
  const std::string mesh = Text(kData / "mfem49_tinyzoo_g3_p5" / "mfem49_tinyzoo_g3_p5.mesh");
  const std::string field = Text(kData / "mfem49_tinyzoo_g3_p5" / "u.gf");
  const Scratch scratch;
  const std::string first = scratch.Write("a.000000", mesh);
  scratch.Write("a.000001", mesh);
  const std::string u = scratch.Write("u.000000", field);
  vtkNew<vtkMFEMReader> reader;
  reader->SetFileName(first.c_str());
  reader->AddGridFunctionFileName(u.c_str());
  ExpectRefusal(reader, "u.000001");
  scratch.Write("u.000001", field);
  reader->Modified();
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfCells(), 8);
  EXPECT_EQ(reader->GetNumberOfDiagnostics(), 0);
}

/// Each cycle has a mesh of its own: the second one is twice as wide.
TEST(NativeReaders, RootFilesAreTimeSteps)
{
  const auto mesh = [](int width)
  {
    const std::string x = std::to_string(width);
    return "MFEM mesh v1.0\ndimension\n2\nelements\n1\n1 3 0 1 2 3\nboundary\n0\nvertices\n4\n2\n"
           "0 0\n" +
      x + " 0\n" + x + " 1\n0 1\n";
  };
  const Scratch scratch;
  std::vector<std::string> roots;
  for (const int cycle : { 2, 1 })
  {
    const std::string name = "m" + std::to_string(cycle);
    scratch.Write(name + ".000000", mesh(cycle));
    roots.push_back(scratch.Write(name + ".mfem_root",
      R"({"dsets": {"main": {"cycle": )" + std::to_string(cycle) + R"(, "time": )" +
        std::to_string(cycle) + R"(, "domains": 1, "mesh": {"path": ")" + name + R"(.%06d"}}}})"));
  }
  vtkNew<vtkMFEMReader> reader;
  reader->SetFileName(roots[0].c_str());
  reader->AddStepFileName(roots[1].c_str());
  for (const double time : { 2.0, 1.0, 1.5, 2.5 })
  {
    reader->UpdateTimeStep(time);
    EXPECT_EQ(reader->GetOutput()->GetBounds()[1], time < 2.0 ? 1.0 : 2.0) << time;
    EXPECT_EQ(reader->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()),
      time < 2.0 ? 1.0 : 2.0);
  }
  reader->AddStepFileName(roots[1].c_str());
  vtkNew<Messages> messages;
  messages->Watch(reader);
  reader->Update();
  EXPECT_NE(messages->errors.find("of one time"), std::string::npos) << messages->errors;
}

TEST(NativeReaders, RefuseEveryTruncation)
{
  const std::string mesh = Text(kData / "mfem49_tinyzoo_g3_p5" / "mfem49_tinyzoo_g3_p5.mesh");
  const Scratch scratch;
  for (std::size_t size = 0; size + 40 < mesh.size(); size += 397)
  {
    vtkNew<vtkMFEMReader> reader;
    reader->SetFileName(scratch.Write("cut.mesh", mesh.substr(0, size)).c_str());
    ExpectRefusal(reader, "cut.mesh");
  }
  const std::string session = Text(kData / "nek_pyramid_curved_p6" / "nek_pyramid_curved_p6.xml");
  for (std::size_t size = 0; size < session.size() - 40; size += 97)
  {
    vtkNew<vtkNektarReader> reader;
    reader->SetFileName(scratch.Write("cut.xml", session.substr(0, size)).c_str());
    ExpectRefusal(reader, "cut.xml");
  }
}

TEST(NativeReaders, TimesOfNektar3AreSteps)
{
  const auto folder = kData / "nek_hex_aniso_p3p5p7";
  const std::string field = Text(folder / "nek_hex_aniso_p3p5p7.fld");
  const auto withTime = [&](const std::string& time)
  {
    std::string text = field;
    return text.insert(text.find("<Metadata>"),
      "<FIELDMETADATA><P PARAM=\"Time\"> " + time + "</P></FIELDMETADATA>");
  };
  const Scratch scratch;
  vtkNew<vtkNektarReader> reader;
  reader->SetFileName((folder / "nek_hex_aniso_p3p5p7.xml").c_str());
  reader->AddFieldFileName(scratch.Write("b.chk", withTime("2.5")).c_str());
  reader->AddFieldFileName(scratch.Write("a.chk", withTime("0.5")).c_str());
  ExpectTimes(reader, 0.5, 2.5);

  // A text that is not completely a number is not a time. Files are then numbered, and reading
  // reports the error.
  scratch.Write("b.chk", withTime("2.5 s"));
  reader->Modified();
  ExpectTimes(reader, 0.0, 1.0);
  ExpectRefusal(reader, "'s' is no number");
}

/// A half mode of Nektar++'s tests against the flow that its session forces.
TEST(NektarReader, HalfModesAreTheirExactSolution)
{
  vtkNew<vtkNektarReader> reader;
  reader->SetFileName((kData / "nek_half_mode/nek_half_mode.xml").c_str());
  reader->AddFieldFileName((kData / "nek_half_mode/nek_half_mode.fld").c_str());
  reader->Update();
  const auto model = HighOrderModel::From(reader->GetOutput());
  const Mesh& mesh = model->GetMesh();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-0.95, -0.05); // inside of prisms, too
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    for (int trial = 0; trial < 20; ++trial)
    {
      const Vec3 xi(place(random), place(random), place(random));
      Vec3 x;
      MapForward(mesh, e, std::span(&xi, 1), std::span(&x, 1));
      const double wave = 2 * std::acos(-1.0) * x.z;
      const std::map<std::string, double> exact{
        { "u", -2 * std::acos(-1.0) * x.x * x.y * std::cos(wave) },
        { "v", x.x * x.x * std::cos(wave) }, { "w", x.y * std::sin(wave) },
        { "p", 4 * x.x * x.y * std::cos(wave) }
      };
      for (const auto& [name, value] : exact)
      {
        std::vector<double> found(1);
        EvaluateAt(mesh, *model->FindField(name), e, std::span(&xi, 1), found, {});
        EXPECT_NEAR(found[0], value, kHalfModeError) << name;
      }
    }
  }
}

/// The second step has no mesh and so has the first one's.
TEST(NekReader, StepsShareAMesh)
{
  vtkNew<vtkNekReader> reader;
  reader->SetFileName((kData / "nek5000_bent" / "bent.nek5000").c_str());
  ExpectTimes(reader, 0.5, 1.25);
  std::vector<std::shared_ptr<const HighOrderModel>> models;
  for (const double time : { 0.5, 1.25, 0.75 })
  {
    reader->UpdateTimeStep(time);
    const auto model = HighOrderModel::From(reader->GetOutput());
    models.push_back(model);
    const Vec3 xi(-0.25, 0.5, 0.125);
    Vec3 x;
    MapForward(model->GetMesh(), 1, std::span(&xi, 1), std::span(&x, 1));
    std::vector<double> found(1);
    EvaluateAt(model->GetMesh(), *model->FindField("pressure"), 1, std::span(&xi, 1), found, {});
    EXPECT_NEAR(found[0], (time < 1.25 ? 1.5 : 2.25) * (x.x * x.y - x.z), 1e-14) << time;
  }
  for (const auto& model : models)
  {
    EXPECT_EQ(&model->GetLocator(), &models[0]->GetLocator());
  }
}

TEST(NekReader, StepsWithMeshesReadThem)
{
  const Scratch scratch;
  const auto folder = kData / "nek5000_bent";
  // The second step's files have the first one's content, moved by 8 and at another time.
  for (const std::string part : { "bent0.f0000", "bent1.f0000" })
  {
    std::string step = Text(folder / (part + "0"));
    scratch.Write(part + "0", step);
    step.replace(step.find("5.0000000000000E-01"), 19, "7.5000000000000E-01");
    for (std::size_t node = 0; node < 64; ++node)
    {
      double x = 0.0;
      std::memcpy(&x, &step[140 + 8 * node], sizeof(x));
      x += 8.0;
      std::memcpy(&step[140 + 8 * node], &x, sizeof(x));
    }
    scratch.Write(part + "1", step);
  }
  vtkNew<vtkNekReader> reader;
  reader->SetFileName(scratch.Path("bent1.f00001").c_str());
  reader->AddStepFileName(scratch.Path("bent0.f00000").c_str());
  ExpectTimes(reader, 0.5, 0.75);
  for (const double time : { 0.75, 0.5 })
  {
    reader->UpdateTimeStep(time);
    EXPECT_EQ(reader->GetOutput()->GetBounds()[0], time > 0.5 ? 8.0 : 0.0);
  }
  scratch.Write("bent1.f00001", Text(folder / "bent1.f00000").substr(0, 2000));
  reader->Modified();
  ExpectRefusal(reader, "bent1.f00001: the file has 2000 bytes");
}

TEST(NativeReaders, KnowTheirFilesByContent)
{
  const Scratch scratch;
  vtkNew<vtkMFEMReader> mfem;
  vtkNew<vtkNektarReader> nektar;
  vtkNew<vtkGmshReader> gmsh;
  vtkNew<vtkGLVisReader> glvis;
  vtkNew<vtkNekReader> nek;
  const std::vector<vtkHighOrderFileReader*> readers{ mfem, nektar, gmsh, glvis, nek };
  const std::string darcy = (kData / "mfem_escher_tet_darcy_p3").string();
  const std::pair<std::string, vtkHighOrderFileReader*> files[] = {
    { darcy + "/mfem_escher_tet_darcy_p3.mesh", mfem },
    { darcy + "/flux.gf", nullptr },
    { (kData / "nek_tet_varp" / "nek_tet_varp.xml").string(), nektar },
    { (kData / "nek_tet_varp" / "nek_tet_varp.fld").string(), nektar },
    { (kData / "nek_hdf5" / "nek_tet_varp.fld").string(), nektar },
    { (kData / "gmsh_zoo_g2" / "gmsh_zoo_g2.msh").string(), gmsh },
    { (kData / "nek5000_bent" / "bent.nek5000").string(), nek },
    { (kData / "nek5000_bent" / "bent1.f00001").string(), nek },
    { scratch.Write("a.saved", "\n solution\nMFEM mesh v1.0\n"), glvis },
    { scratch.Write("a.mfem_root", "{ \"dsets\": { \"main\": {} } }"), mfem },
    { scratch.Write("city.xml", "<?xml version=\"1.0\"?>\n<CityModel/>\n"), nullptr },
    { scratch.Write("empty.msh", ""), nullptr },
    { (kData / "toroid_hex_g3_p6.vtu").string(), nullptr },
    { kData.string(), nullptr },
    { scratch.Path("none.mesh"), nullptr },
  };
  for (const auto& [file, own] : files)
  {
    for (vtkHighOrderFileReader* reader : readers)
    {
      EXPECT_EQ(reader->CanReadFile(file.c_str()), reader == own ? 1 : 0)
        << reader->GetClassName() << " " << file;
    }
  }
  EXPECT_EQ(mfem->CanReadFile(nullptr), 0);
}
} // namespace
