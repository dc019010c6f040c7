// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVInkIsoValueInformation
 * @brief   the iso-value that suits an image on the data server, or that a representation draws it at
 *
 * The one that `ink info` suggests, see ink::suggestIsoValues, of an algorithm's output. On several processes
 * it is the suggestion of the one that holds the most voxels. Of a vtkInkRepresentation it is the value used
 * last, given or chosen.
 */
#ifndef vtkPVInkIsoValueInformation_h
#define vtkPVInkIsoValueInformation_h

#include "vtkInkPluginRepresentationsModule.h" // for the export macro
#include "vtkPVInformation.h"

#include <string> // for the array's name

class vtkMultiProcessController;

class VTKINKPLUGINREPRESENTATIONS_EXPORT vtkPVInkIsoValueInformation : public vtkPVInformation
{
public:
  static vtkPVInkIsoValueInformation* New();
  vtkTypeMacro(vtkPVInkIsoValueInformation, vtkPVInformation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * What is asked for: an output port, and a point array of one component; an empty name stands for the
   * active scalars. Of a representation: the port is an index into its used values. Default: 0, empty.
   */
  void SetPort(int port);
  void SetArrayName(const std::string& name);
  ///@}

  /// Whether there is an image with such an array and two different values in it, or such a surface.
  bool GetFound() const;
  /// The value where there is one, else 0.
  double GetValue() const;

  /// Makes what each process found that of all of them, for symmetric batches: ParaView lets each of their
  /// processes know only its own. All have to call it.
  void Share(vtkMultiProcessController* controller);

  void CopyFromObject(vtkObject* algorithm) override;
  void AddInformation(vtkPVInformation* other) override;
  void CopyToStream(vtkClientServerStream* stream) override;
  void CopyFromStream(const vtkClientServerStream* stream) override;
  void CopyParametersToStream(vtkMultiProcessStream& stream) override;
  void CopyParametersFromStream(vtkMultiProcessStream& stream) override;

protected:
  vtkPVInkIsoValueInformation();
  ~vtkPVInkIsoValueInformation() override;

private:
  vtkPVInkIsoValueInformation(const vtkPVInkIsoValueInformation&) = delete;
  void operator=(const vtkPVInkIsoValueInformation&) = delete;

  int Port = 0;
  std::string ArrayName;
  double Value = 0.0;
  double Voxels = 0.0; ///< that it was found of; 0: none was found
};

#endif
