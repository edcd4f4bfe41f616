// SPDX-License-Identifier: BSD-3-Clause
// Time series in files: the reader, and what stands behind it, from step to step.
#include "SeriesFiles.h"

namespace
{
using namespace pixelexact;
using namespace pixelexact::testing;

using TimeSeries = SeriesFiles;

TEST_F(TimeSeries, StepsOfOneMeshKeepTheLocator)
{
  std::string sets;
  for (const int i : { 2, 0, 1 }) // a collection may be in any order
  {
    const std::string name = "u_" + std::to_string(i) + ".vtu";
    Write(name, Slabs(0, 3, 0.5 * i));
    sets += DataSet("timestep=\"" + std::to_string(0.5 * i) + "\" part=\"0\"", name);
  }
  Reader->SetFileName(WriteCollection(sets).c_str());
  EXPECT_EQ(Steps(), (std::vector{ 0.0, 0.5, 1.0 }));
  ExpectValues(0.0, 0.0);
  const Locator* first = Located();
  ASSERT_NE(first, nullptr);
  for (const double t : { 0.5, 1.0, 0.0 })
  {
    // Held by the probe, which has not yet executed.
    Converter->UpdateTimeStep(t);
    EXPECT_EQ(Located(), first) << t;
    ExpectValues(t, t);
    EXPECT_EQ(Located(), first) << t;
    EXPECT_EQ(
      Reader->GetOutputDataObject(0)->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), t);
    EXPECT_EQ(
      Converter->GetOutputDataObject(0)->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), t);
  }
  // Times between, before and after the steps.
  ExpectValues(0.7, 0.5);
  ExpectValues(-5.0, 0.0);
  ExpectValues(99.0, 1.0);
}

TEST_F(TimeSeries, AnotherMeshHasAnotherLocator)
{
  Write("a.vtu", Slabs(0, 3, 0.0));
  Write("b.vtu", Slabs(0, 4, 1.0));
  Reader->AddFileName((Folder / "a.vtu").c_str());
  Reader->AddFileName((Folder / "b.vtu").c_str());
  EXPECT_EQ(Steps(), (std::vector{ 0.0, 1.0 }));
  ExpectValues(0.0, 0.0);
  Converter->UpdateTimeStep(1.0);
  EXPECT_EQ(Located(), nullptr);
  ExpectValues(1.0, 1.0);
}

TEST_F(TimeSeries, StepsInAFileOfVtkHdf)
{
  Reader->SetFileName(PIXELEXACT_DATA_DIR "/vtkhdf_steps.vtkhdf");
  const std::vector<double> steps = Steps();
  if (Heard->errors.find("without the HDF5 library") != std::string::npos)
  {
    GTEST_SKIP() << "built without the HDF5 library";
  }
  EXPECT_EQ(steps, (std::vector{ 0.0, 0.5, 1.0 }));
  ExpectValues(0.0, 0.0);
  const Locator* first = Located();
  ASSERT_NE(first, nullptr);
  ExpectValues(0.5, 0.5);
  ExpectValues(99.0, 1.0);
  EXPECT_EQ(Located(), first);
}

TEST_F(TimeSeries, AFileAloneHasNoTime)
{
  Write("a.vtu", Slabs(0, 3, 2.0));
  Reader->SetFileName((Folder / "a.vtu").c_str());
  EXPECT_EQ(Steps(), std::vector<double>());
  ExpectValues(0.0, 2.0);
}

TEST_F(TimeSeries, RefusesWithTheFileNamed)
{
  ExpectError("SetFileName");
  const auto refuse = [&](const std::string& file, const std::string& word)
  {
    Reader->SetFileName(file.c_str());
    ExpectError(word);
    EXPECT_NE(
      Heard->errors.find(std::filesystem::path(file).filename().string()), std::string::npos)
      << Heard->errors;
  };
  refuse(Folder / "absent.pvd", "not found");
  refuse(Folder / "absent.vtu", "no such file");
  refuse(Folder / "absent.pvtu", "not found");
  refuse(WriteText("noise.pvd", "no XML"), "cannot read");
  refuse(WriteText("other.pvd", "<VTKFile type='PolyData'><PolyData/></VTKFile>"), "Collection");
  refuse(WriteText("noise.vtu", "no XML"), "cannot read");
  refuse(WriteText("noise.pvtu", "<VTKFile"), "byte");
  refuse(WriteCollection(""), "lists no DataSet");
  refuse(WriteCollection("<DataSet timestep='0'/>"), "names no file");
  refuse(WriteCollection(DataSet("timestep='soon'", "a.vtu")), "soon");
  for (const std::string time : { "nan", "1 2", "1x", "1,5", "0x1", "+-1", "1e999", "" })
  {
    refuse(
      WriteCollection(DataSet("timestep='" + time + "'", "a.vtu")), "'" + time + "' is no time");
  }
  refuse(WriteCollection(DataSet("timestep='0'", "a.vtu")), "a.vtu");
  refuse(
    WriteCollection(DataSet("timestep='0'", "series.pvd")), "only .vtu, .pvtu, .vtk and .vtkhdf");
  refuse(WriteCollection(DataSet("timestep='0'", "cut.vtp")), "no volume");
  WritePieces("loop.pvtu", { "loop.pvtu" });
  refuse(Folder / "loop.pvtu", "only .vtu, .pvtu, .vtk and .vtkhdf");
  WritePieces("none.pvtu", {});
  refuse(Folder / "none.pvtu", "lists no Piece");
  Reader->AddFileName((Folder / "series.pvd").c_str());
  ExpectError("only file");
}
} // namespace
