// SPDX-License-Identifier: BSD-3-Clause
// Loading an MFEM mesh of some 50 MB with a grid function of some 35 MB: time and memory, beside
// plain reading of the numbers in the files. Counters: MB_file, MB_coefficients, and what the
// process held beyond what it held before: MB_peak at most during the load, MB_after when it was
// done.
#include "vtkFieldData.h"
#include "vtkHighOrderGrid.h"
#include "vtkMFEMReader.h"
#include "vtkNew.h"

#include <benchmark/benchmark.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>

namespace pixelexact::benchmarks
{
namespace
{
constexpr int kBoxes = 24;
constexpr int kMeshOrder = 3;
constexpr int kFieldOrder = 4;
constexpr double kMega = 1e6;

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

File Create(const std::filesystem::path& path)
{
  File file(std::fopen(path.c_str(), "w"), &std::fclose);
  if (!file)
  {
    throw std::runtime_error("cannot write " + path.string());
  }
  return file;
}

/// Writes `components` values at the closed uniform nodes of every box.
template <class Function>
void WriteNodes(std::FILE* file, int order, Function&& function)
{
  for (int box = 0; box < kBoxes * kBoxes * kBoxes; ++box)
  {
    const int at[3] = { box % kBoxes, box / kBoxes % kBoxes, box / kBoxes / kBoxes };
    for (int node = 0; node < (order + 1) * (order + 1) * (order + 1); ++node)
    {
      const int n[3] = { node % (order + 1), node / (order + 1) % (order + 1),
        node / (order + 1) / (order + 1) };
      double x[3];
      for (int d = 0; d < 3; ++d)
      {
        x[d] = (at[d] + static_cast<double>(n[d]) / order) / kBoxes;
      }
      function(file, x);
    }
  }
}

void WriteTopology(std::FILE* file)
{
  constexpr int kNodes = kBoxes + 1;
  std::fprintf(file, "MFEM mesh v1.0\n\ndimension\n3\n\nelements\n%d\n", kBoxes * kBoxes * kBoxes);
  for (int box = 0; box < kBoxes * kBoxes * kBoxes; ++box)
  {
    const int a = (box / kBoxes / kBoxes * kNodes + box / kBoxes % kBoxes) * kNodes + box % kBoxes;
    const int b = a + kNodes * kNodes;
    std::fprintf(file, "1 5 %d %d %d %d %d %d %d %d\n", a, a + 1, a + kNodes + 1, a + kNodes, b,
      b + 1, b + kNodes + 1, b + kNodes);
  }
  std::fprintf(file, "\nboundary\n0\n\nvertices\n%d\n\n", kNodes * kNodes * kNodes);
}

/// Made once, removed with the process.
struct Files
{
  Files()
    : folder(std::filesystem::temp_directory_path() /
        ("pixelexact-loading-" + std::to_string(std::rand()) + std::to_string(getpid())))
  {
    std::filesystem::create_directories(folder);
    const File meshFile = Create(Mesh());
    WriteTopology(meshFile.get());
    std::fprintf(meshFile.get(),
      "nodes\nFiniteElementSpace\nFiniteElementCollection: L2_T4_3D_P%d\nVDim: 3\nOrdering: 1\n\n",
      kMeshOrder);
    WriteNodes(meshFile.get(), kMeshOrder,
      [](std::FILE* file, const double* x)
      {
        std::fprintf(file, "%.17g %.17g %.17g\n", x[0] + 0.01 * std::sin(3 * x[1]),
          x[1] + 0.01 * std::sin(3 * x[2]), x[2] + 0.01 * std::sin(3 * x[0]));
      });
    const File fieldFile = Create(Field());
    std::fprintf(fieldFile.get(),
      "FiniteElementSpace\nFiniteElementCollection: L2_T4_3D_P%d\nVDim: 1\nOrdering: 0\n\n",
      kFieldOrder);
    WriteNodes(fieldFile.get(), kFieldOrder,
      [](std::FILE* file, const double* x)
      { std::fprintf(file, "%.17g\n", std::sin(5 * x[0]) * std::cos(4 * x[1]) + x[2]); });
  }
  ~Files() { std::filesystem::remove_all(folder); }
  Files(const Files&) = delete;
  Files& operator=(const Files&) = delete;

  [[nodiscard]] std::string Mesh() const { return (folder / "block.mesh").string(); }
  [[nodiscard]] std::string Field() const { return (folder / "u.gf").string(); }

  std::filesystem::path folder;
};

const Files& GetFiles()
{
  static const Files files;
  return files;
}

double FileMegabytes()
{
  return static_cast<double>(std::filesystem::file_size(GetFiles().Mesh()) +
           std::filesystem::file_size(GetFiles().Field())) /
    kMega;
}

/// A line of /proc/self/status in MB.
double Status(const std::string& key)
{
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
  {
    if (word == key)
    {
      double kilobytes = 0.0;
      status >> kilobytes;
      return kilobytes * 1024 / kMega;
    }
  }
  return NAN;
}

void LoadMfem(benchmark::State& state)
{
  double peak = 0.0;
  double after = 0.0;
  double coefficients = 0.0;
  GetFiles();
  for (auto _ : state)
  {
    state.PauseTiming();
    std::ofstream("/proc/self/clear_refs") << "5"; // the high-water mark begins here
    const double before = Status("VmRSS:");
    vtkNew<vtkMFEMReader> reader;
    reader->SetFileName(GetFiles().Mesh().c_str());
    reader->AddGridFunctionFileName(GetFiles().Field().c_str());
    state.ResumeTiming();
    reader->Update();
    state.PauseTiming();
    peak = std::max(peak, Status("VmHWM:") - before);
    after = Status("VmRSS:") - before;
    vtkFieldData* data = reader->GetHighOrderOutput()->GetFieldData();
    coefficients = 8.0 / kMega *
      static_cast<double>(data->GetArray("PixelExact.Mesh.Coefficients")->GetNumberOfValues() +
        data->GetArray("PixelExact.Field.u.Coefficients")->GetNumberOfValues());
    state.ResumeTiming();
  }
  state.counters["MB_file"] = FileMegabytes();
  state.counters["MB_coefficients"] = coefficients;
  state.counters["MB_peak"] = peak;
  state.counters["MB_after"] = after;
  state.counters["MB_per_second"] =
    benchmark::Counter(FileMegabytes(), benchmark::Counter::kIsIterationInvariantRate);
}

/// The floor: every number of the files once through the standard library.
void ParseNumbers(benchmark::State& state)
{
  for (auto _ : state)
  {
    double sum = 0.0;
    for (const std::string& path : { GetFiles().Mesh(), GetFiles().Field() })
    {
      std::ifstream file(path, std::ios::binary);
      const std::string text{ std::istreambuf_iterator<char>(file), {} };
      for (const char* at = text.c_str(); *at != '\0';)
      {
        char* end = nullptr;
        sum += std::strtod(at, &end);
        at = end > at ? end : at + 1;
      }
    }
    benchmark::DoNotOptimize(sum);
  }
  state.counters["MB_file"] = FileMegabytes();
  state.counters["MB_per_second"] =
    benchmark::Counter(FileMegabytes(), benchmark::Counter::kIsIterationInvariantRate);
}

BENCHMARK(ParseNumbers)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(LoadMfem)->Unit(benchmark::kMillisecond)->UseRealTime();
} // namespace
} // namespace pixelexact::benchmarks
