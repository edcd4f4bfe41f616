// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderFileReader
 * @brief   what the readers of solvers' own files have in common
 *
 * Output is a vtkHighOrderGrid: every coefficient of the files, in the canonical bases, and beside
 * them VTK's cells with the fields' values at their points (see SetCells). Other arrays: CellData
 * `Attribute` and `BoundaryAttribute` (per face of the cell, the first that it has, -1: none).
 * VTK's own filters use the cells; what this project computes comes from the coefficients, and
 * boundary attributes from a list that holds all (data-set.md).
 *
 * A new time step keeps the mesh's arrays, and with them the locator, where steps share a mesh;
 * after Modified() the mesh is read anew. Where files hold times, they are the steps of the
 * pipeline; the step nearest below the time asked for is read, the first one without such a
 * request.
 *
 * Asked for a piece of several (UPDATE_PIECE_NUMBER), as by each process of a parallel run, it
 * gives that piece: of a run that left a file for each of its processes some consecutive files,
 * and only these are read; of others, which are read whole, the piece's share of the elements, in
 * the order of the file. Elements have the numbers
 * that they have in the whole, where the pieces are the processes of the global controller; all of
 * them must then execute, and where one fails all do. Boundary faces, as curved-surfaces.md has
 * them, are then those of the piece (parallel.md).
 *
 * Errors go to vtkErrorMacro, with file, line or tag, and remedy; the output is then empty. What
 * was noticed in the files is reported as warnings and by GetDiagnostic().
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

  /**
   * Whether a file begins as those do that SetFileName takes, for programs that choose a reader by
   * what is in a file. 1: it does, which is no promise that it can be read; 0: it does not, or it
   * is no file.
   */
  int CanReadFile(const char* name);

protected:
  vtkHighOrderFileReader();
  ~vtkHighOrderFileReader() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /**
   * Reads the fields of `step`, and the mesh where `wantMesh` says so: it may be left empty
   * otherwise; of runs in pieces, of Piece of Pieces. Throws pixelexact::Error.
   */
  virtual pixelexact::SolverModel ReadModel(int step, bool wantMesh) = 0;

  /**
   * Whether each step has a mesh of its own, so that a new one asks for it. Otherwise steps share
   * it.
   */
  virtual bool StepsHaveMeshes() { return false; }

  /**
   * Whether these are the first bytes of a file of the reader's kind, gunzipped.
   */
  virtual bool IsHead(const std::string& head) = 0;

  /**
   * Times of the steps, ascending; empty for files without time. Throws pixelexact::Error.
   */
  virtual std::vector<double> ReadTimes();

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  std::string FileName;
  int Piece = 0;  ///< that is asked for
  int Pieces = 1; ///< of so many

private:
  vtkHighOrderFileReader(const vtkHighOrderFileReader&) = delete;
  void operator=(const vtkHighOrderFileReader&) = delete;

  pixelexact::CellLayout ChooseLayout(
    const pixelexact::Mesh& mesh, const pixelexact::SolverModel& model);
  pixelexact::SolverModel ReadPart(int step, bool wantMesh);
  int RequestedStep(vtkInformation* output);

  int Cells = LAGRANGE_CELLS;
  vtkIdType MaximumNumberOfNodes = 4'000'000;
  std::vector<double> Times;
  vtkSmartPointer<vtkHighOrderGrid> MeshGrid; ///< without fields; what steps share
  std::unique_ptr<pixelexact::CellLayout> MeshLayout;
  std::string LayoutNote; ///< why the cells are not those that were asked for; may be empty
  vtkTimeStamp MeshTime;
  int MeshStep = 0; ///< whose mesh it is, where steps have their own
  int MeshPiece = 0;
  int MeshPieces = 1;
};

#endif
