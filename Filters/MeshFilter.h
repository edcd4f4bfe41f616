// SPDX-License-Identifier: BSD-3-Clause
#ifndef MeshFilter_h
#define MeshFilter_h

#include "PixelExactFiltersModule.h"

#include "vtkDataObject.h" // of the output, in a template

#include <functional>
#include <memory>
#include <type_traits>
#include <utility>

class vtkAlgorithm;
class vtkInformation;
class vtkInformationVector;

// The steps that filters of a mesh share: the type of the input port, the request for parts of the
// mesh, errors, and what several processes do.

namespace pixelexact
{
class HighOrderModel;
class ModelSource;
class WholeMesh;

/// The mesh that a filter needs where several processes have parts of it.
enum class MeshScope
{
  WholeOnFirst, ///< the whole mesh on the first process; the output of the others is empty
  WholeOnEach,  ///< the whole mesh on each process
  Part,         ///< the part of each process, composite data as one mesh
  PartByBlock   ///< the part of each process; VTK's pipeline calls the filter for each block
};

/// The input port of a filter that takes a mesh: a grid that carries coefficients, a plain one,
/// which is converted, or composite data of such.
class PIXELEXACTFILTERS_EXPORT MeshInput
{
public:
  MeshInput(MeshScope scope, int port);
  ~MeshInput();

  /// FillInputPortInformation of the port.
  void FillPort(vtkInformation* port) const;

  /// RequestUpdateExtent of the port. False where the superclass makes the request.
  [[nodiscard]] bool RequestParts(
    vtkInformationVector** inputs, vtkInformationVector* outputs) const;

  /// RequestData: fills the output by `make`, whose false ends the work without a result. The
  /// output is then empty, as on a process without a share of the mesh and after an exception,
  /// which becomes the filter's error.
  int Fill(vtkAlgorithm* filter, vtkInformationVector** inputs, vtkInformationVector* outputs,
    const std::function<bool(vtkDataObject* mesh)>& make);

  /// The model of the mesh that Fill passes on. Diagnostics of a conversion become warnings of
  /// `filter`. Throws Error.
  std::shared_ptr<HighOrderModel> Model(vtkDataObject* mesh, vtkAlgorithm* filter);

  /// After Model: the data whose cells are the model's elements. A converted mesh is another object
  /// than the input.
  [[nodiscard]] vtkDataObject* GridOf(vtkDataObject* mesh) const;

private:
  MeshScope Scope;
  int Port;
  std::unique_ptr<ModelSource> Source;
  std::unique_ptr<WholeMesh> Whole; ///< null: the part of each process
};

/// A filter of a mesh. `Algorithm` is VTK's class for filters of its output type. Classes that are
/// wrapped name it PIXELEXACT_MESH_FILTER(Algorithm).
template <class Algorithm>
class MeshFilter : public Algorithm
{
protected:
  using Output = std::remove_pointer_t<decltype(std::declval<Algorithm&>().GetOutput())>;

  explicit MeshFilter(MeshScope scope, int port = 0)
    : Input(scope, port)
  {
  }

  /// Resets what the filter reports of its last update.
  virtual void ResetReport() {}

  /// Fills the output. Throws Error. False where it was aborted.
  virtual bool Make(vtkDataObject* mesh, Output* output) = 0;

  std::shared_ptr<HighOrderModel> ModelOf(vtkDataObject* mesh)
  {
    return this->Input.Model(mesh, this);
  }

  int FillInputPortInformation(int /*port*/, vtkInformation* info) override
  {
    this->Input.FillPort(info);
    return 1;
  }

  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override
  {
    return this->Input.RequestParts(inputVector, outputVector)
      ? 1
      : Algorithm::RequestUpdateExtent(request, inputVector, outputVector);
  }

  int RequestData(vtkInformation* /*request*/, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override
  {
    this->ResetReport();
    return this->Input.Fill(this, inputVector, outputVector,
      [&](vtkDataObject* mesh) { return this->Make(mesh, Output::GetData(outputVector)); });
  }

  MeshInput Input;
};
} // namespace pixelexact

// VTK's wrappers do not support templates, so they get VTK's superclass.
#ifdef __VTK_WRAP__
#define PIXELEXACT_MESH_FILTER(algorithm) algorithm
#else
#define PIXELEXACT_MESH_FILTER(algorithm) pixelexact::MeshFilter<algorithm>
#endif
#endif
