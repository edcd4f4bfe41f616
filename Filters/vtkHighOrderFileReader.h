// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderFileReader
 * @brief   base class of the readers of solvers' own files
 *
 * The output is a vtkHighOrderGrid: all coefficients of the files, in the canonical bases, and
 * VTK's cells with the fields' values at their points (see SetCells). Other arrays: CellData
 * `Attribute` and `BoundaryAttribute` (per face of the cell, its first one, -1: none). VTK's own
 * filters use the cells. PixelExact's results come from the coefficients, and boundary attributes
 * from a complete list (data-set.md).
 *
 * A new time step keeps the mesh's arrays and the locator where steps share a mesh. After
 * Modified() the mesh is read again. Times in the files are the steps of the pipeline. The step
 * nearest below the requested time is read, the first one without a request.
 *
 * If a piece of several is requested (UPDATE_PIECE_NUMBER), as by each process of a parallel run,
 * the output is that piece. If a run left a file for each of its processes, a piece consists of
 * consecutive files, and only these are read. Other files are read whole; the piece is its share of
 * the elements, in the order of the file. If the pieces are the processes of the global controller,
 * elements have their numbers in the whole; all processes must then execute, and where one fails
 * all do. Boundary faces (curved-surfaces.md) are then those of the piece (parallel.md).
 *
 * Errors go to vtkErrorMacro, with file, line or tag, and remedy; the output is then empty. Notes
 * on the files are reported as warnings and by GetDiagnostic().
 */

#ifndef vtkHighOrderFileReader_h
#define vtkHighOrderFileReader_h

#include "PixelExactFiltersModule.h"
#include "vtkHighOrderGridAlgorithm.h"
#include "vtkSmartPointer.h" // for the mesh
#include "vtkTimeStamp.h"    // for its age

#include <memory> // for the layout
#include <string> // for names
#include <vector> // for names

class vtkHighOrderGrid;

namespace pixelexact
{
struct CellLayout;
struct Mesh;
struct SolverModel;
} // namespace pixelexact

class PIXELEXACTFILTERS_EXPORT vtkHighOrderFileReader : public vtkHighOrderGridAlgorithm
{
public:
  vtkTypeMacro(vtkHighOrderFileReader, vtkHighOrderGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file that holds the mesh.
   */
  virtual void SetFileName(const char* name);
  virtual const char* GetFileName();
  ///@}

  /// The cells that the output has beside the coefficients.
  enum CellKinds
  {
    LAGRANGE_CELLS = 0,
    CORNER_CELLS = 1
  };

  ///@{
  /**
   * LAGRANGE_CELLS, the default: VTK's Lagrange cells, whose degrees hold the geometry and the
   * fields, at most 10 (VTK's limit), with fields as point data. Elements share points unless a
   * field is discontinuous. VTK's filters then work on the polynomials' nodal interpolants, which
   * are the polynomials themselves for straight or curved hexahedra, prisms and tetrahedra up to
   * degree 10. Pyramids stay linear cells, since VTK has no Lagrange pyramid. Steps of a file have
   * the cells of the step that was read first.
   *
   * CORNER_CELLS: linear cells between the elements' vertices. Fields are point data at the
   * vertices, or, where they are discontinuous, one value per cell. They take the least memory and
   * time, and serve where nothing but this project's classes uses the output.
   */
  vtkSetClampMacro(Cells, int, LAGRANGE_CELLS, CORNER_CELLS);
  vtkGetMacro(Cells, int);
  ///@}

  ///@{
  /**
   * With more nodes, counted per cell, Lagrange cells give way to corner cells, and GetDiagnostic()
   * says so. Default 4,000,000, which take some 130 MB, and 32 MB more for each component of each
   * field.
   */
  vtkSetClampMacro(MaximumNumberOfNodes, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(MaximumNumberOfNodes, vtkIdType);
  ///@}

  ///@{
  /**
   * Whether the output is prepared for programs that colour by arrays: its first field becomes the
   * active scalars, and the ranges of the fields' arrays are those of the fields (ColorDefaults.h),
   * which takes time. The default is off.
   */
  vtkSetMacro(ColorDefaults, bool);
  vtkGetMacro(ColorDefaults, bool);
  vtkBooleanMacro(ColorDefaults, bool);
  ///@}

  /**
   * Whether a file begins as the reader's files do, for programs that choose a reader by content.
   * 1: it does, although reading may still fail. 0: it does not, or it is not a file.
   */
  virtual int CanReadFile(const char* name);

protected:
  vtkHighOrderFileReader();
  ~vtkHighOrderFileReader() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /**
   * Reads the fields of `step` and, if `wantMesh`, the mesh, which may be left empty otherwise. For
   * runs in pieces it reads Piece of Pieces. Throws pixelexact::Error.
   */
  virtual pixelexact::SolverModel ReadModel(int step, bool wantMesh) = 0;

  /**
   * The step whose mesh this step has. Steps share the first one's mesh by default; a step with
   * another mesh reads it. Throws pixelexact::Error.
   */
  virtual int StepOfMesh(int /*step*/) { return 0; }

  /**
   * Whether these are the first bytes of a file of the reader's kind, after gunzip.
   */
  virtual bool IsHead(const std::string& head) = 0;

  /**
   * Times of the steps, ascending; empty for files without time. Throws pixelexact::Error.
   */
  virtual std::vector<double> ReadTimes();

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  std::string FileName;
  int Piece = 0;  ///< the requested piece
  int Pieces = 1; ///< number of pieces

private:
  vtkHighOrderFileReader(const vtkHighOrderFileReader&) = delete;
  void operator=(const vtkHighOrderFileReader&) = delete;

  pixelexact::CellLayout ChooseLayout(
    const pixelexact::Mesh& mesh, const pixelexact::SolverModel& model);
  pixelexact::SolverModel ReadPart(int step, bool wantMesh);
  int RequestedStep(vtkInformation* output);

  int Cells = LAGRANGE_CELLS;
  vtkIdType MaximumNumberOfNodes = 4'000'000;
  bool ColorDefaults = false;
  std::vector<double> Times;
  vtkSmartPointer<vtkHighOrderGrid> MeshGrid; ///< without fields; shared by steps
  std::unique_ptr<pixelexact::CellLayout> MeshLayout;
  std::string LayoutNote; ///< reason for other cells than the requested ones; may be empty
  vtkTimeStamp MeshTime;
  int MeshStep = 0; ///< StepOfMesh of MeshGrid
  int MeshPiece = 0;
  int MeshPieces = 1;
};

#endif
