// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPixelExactNektarReader
 * @brief   opens Nektar++ sessions and fields in ParaView, with what lies beside them
 *
 * Of a session (NAME.xml) the fields are in NAME.fld, else in NAME_0.chk, NAME_1.chk and so on,
 * which are time steps, else in NAME.rst; without these there is the mesh alone. Of fields (.fld,
 * .chk, .rst; several are time steps) the session is NAME.xml, NAME being theirs without a number
 * behind an underscore. See vtkNektarReader.
 */

#ifndef vtkPixelExactNektarReader_h
#define vtkPixelExactNektarReader_h

#include "vtkPixelExactReader.h"

class vtkNektarReader;

class PIXELEXACTPARAVIEWREADERS_EXPORT vtkPixelExactNektarReader : public vtkPixelExactReader
{
public:
  static vtkPixelExactNektarReader* New();
  vtkTypeMacro(vtkPixelExactNektarReader, vtkPixelExactReader);

  ///@{
  /**
   * Sessions and fields that lie elsewhere, in the place of those that would be found.
   */
  void AddSessionFileName(const char* name);
  void RemoveAllSessionFileNames();
  void AddFieldFileName(const char* name);
  void RemoveAllFieldFileNames();
  ///@}

  int CanReadFile(const char* name) override;

protected:
  vtkPixelExactNektarReader();
  ~vtkPixelExactNektarReader() override;

  vtkAlgorithm* GetSource() override;
  void Prepare() override;

private:
  vtkPixelExactNektarReader(const vtkPixelExactNektarReader&) = delete;
  void operator=(const vtkPixelExactNektarReader&) = delete;

  std::vector<std::string> Sessions;
  std::vector<std::string> FieldFiles;
  vtkNew<vtkNektarReader> Reader;
};

#endif
