// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkStyle
 * @brief   a way of drawing: what it takes, how it makes marks of it, how these are drawn, and its parameters
 *
 * A style draws a data object in two steps. Make, which needs no camera, makes the marks where the data is,
 * as pieces of poly data; Show hands such pieces, perhaps delivered from another process, to the style's
 * mapper. Draw does both, and GetActor is what a renderer takes:
 *
 *     auto style = vtkSmartPointer<vtkInkStyle>::Take(vtkInkStyle::CreateStyle("stipple"));
 *     style->SetParameter("Sharpness", 0.7);
 *     style->Draw(image);
 *     renderer->AddActor(style->GetActor());
 *
 * A parameter of the recipe takes effect with the next Make, all others with the next picture. Every
 * parameter has a name, a type, a range, a default, a unit and a sentence, from the style's parameters.json;
 * it can be set by name, and all of them together can be written and read as JSON. A name or a value that is
 * wrong is an error that says which, what was found and what was expected, and changes nothing.
 *
 * @sa vtkInkStippleStyle vtkInkSplattingLinesStyle
 */
#ifndef vtkInkStyle_h
#define vtkInkStyle_h

#include "vtkInkStylesModule.h" // for the export macro
#include "vtkObject.h"
#include "vtkPoints.h"       // for the frame
#include "vtkSmartPointer.h" // for the pieces

#include <functional> // for progress and the camera
#include <limits>     // for what marks suit
#include <memory>     // for std::shared_ptr
#include <string>     // for messages
#include <utility>    // for std::pair
#include <vector>     // for the pieces

class InkIsoSurface;
class InkOriginalImage;
class InkStyleProcesses;
class vtkActor;
class vtkAlgorithm;
class vtkAlgorithmOutput;
class vtkCamera;
class vtkDataObject;
class vtkImageData;
class vtkInformation;
class vtkInkIsoSurfaceAlgorithm;
class vtkInkSurfaceSampler;
class vtkLight;
class vtkMapper;
class vtkPoints;
class vtkPolyData;
class vtkScalarsToColors;
struct InkLeaves;
struct InkParameter;
struct InkParameterTable;
struct InkParameterValue;

class VTKINKSTYLES_EXPORT vtkInkStyle : public vtkObject
{
public:
  vtkTypeMacro(vtkInkStyle, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// When something changed last that the marks depend on; what only changes how they look is not among it,
  /// and neither is making them.
  vtkMTimeType GetMTime() override;

  ///@{
  /// All styles there are, the default first: "illustration", "contours", "line-art", "splatting-lines",
  /// "stipple". CreateStyle returns null for an unknown name.
  static int GetNumberOfStyles();
  static const char* GetStyleName(int style); ///< null out of range
  VTK_NEWINSTANCE
  static vtkInkStyle* CreateStyle(const char* name);
  ///@}

  ///@{
  /// What this style is called, by programs and by people, and what it does, in a sentence.
  virtual const char* GetName() = 0;
  virtual const char* GetLabel() = 0;
  virtual const char* GetDescription() = 0;
  ///@}

  ///@{
  /// Whether the style can draw a data object; if not, what was expected and what was found, else an empty
  /// text.
  bool Accepts(vtkDataObject* data) { return this->GetReasonAgainst(data).empty(); }
  virtual std::string GetReasonAgainst(vtkDataObject* data) = 0;
  ///@}

  /// Makes marks of a data object, shows them, or both. False, after one error, if there are none. What was
  /// chosen by the way is among the notes.
  bool Make(vtkDataObject* data);
  void Show();
  bool Draw(vtkDataObject* data);
  /// As Draw, but tells what is wrong in place of an error.
  std::string TryDraw(vtkDataObject* data);

  ///@{
  /// As Draw and TryDraw, of what an algorithm makes. An image that takes more than about half of
  /// MaximumMemory is read a few slices at a time, by styles that need no more of it than points of its
  /// surfaces: illustration and splatting lines. Others refuse it.
  bool Draw(vtkAlgorithmOutput* source);
  std::string TryDraw(vtkAlgorithmOutput* source);
  ///@}

  /// As Draw, by these styles, of the surfaces that a sampler makes of an image that it asks for in parts, or
  /// of an OpenVDB file. It is given the style's parameters of surfaces. Where no IsoValues are given one is
  /// chosen for an image; Smoothing and Subdivision that are automatic, which need all of the volume, are
  /// none.
  bool DrawSurfaces(vtkInkIsoSurfaceAlgorithm* sampler);

  /// A data object, with what it comes from where parts of it have to be asked for.
  struct Input
  {
    vtkDataObject* Data = nullptr;
    vtkAlgorithmOutput* Port = nullptr; ///< null: Data is whole
    vtkInformation* Request = nullptr;  ///< the piece and time of it, as vtkAlgorithm::Update takes it
    bool IsGathered = false;            ///< whether it is all processes' mesh, curved by now (CurvedMeshes)
    double Diagonal = 0.0;              ///< of the bounds of what it was made of; 0: its own
    vtkInkIsoSurfaceAlgorithm* Surfaces = nullptr; ///< in place of Data, see DrawSurfaces
    bool IsOriginal = false; ///< whether Data has been looked at for samples that were made of others
  };
  /// As Make, for a part of the data of several processes, which all call this at once, also without data.
  /// @return what is wrong with the data, or went wrong; marks may be there all the same
  std::string MakeMarks(const Input& input);
  /// The processes that hold parts of the data; null (default): this one holds all.
  void SetProcesses(std::shared_ptr<InkStyleProcesses> processes);

  ///@{
  /// The marks that were made: pieces of poly data that can be delivered to other processes, one of each from
  /// every process appended. The first piece has the points that are drawn.
  virtual int GetNumberOfPieces() = 0;
  virtual const char* GetPieceName(int piece) = 0;
  vtkPolyData* GetPiece(int piece); ///< null out of range
  ///@}

  /// The points that a picture of the last marks is fitted to: those of a mesh, of an image's iso-surfaces
  /// without the parts that are left out, or else of the marks. The same in all styles, so that their
  /// pictures register. Null before the first Make. See vtkInkCameraFit.
  vtkPoints* GetFramePoints() { return this->FramePoints; }
  /// Whether the last marks are those of voxels, not of a surface: what lies behind them is seen, too.
  virtual bool IsSeenThrough() { return false; }

  /// Hands pieces to the mapper; null, or all of them empty, shows nothing.
  virtual void ShowPieces(const std::vector<vtkPolyData*>& pieces) = 0;

  ///@{
  /// What the last Make chose or found that its user may want to know, each a sentence without its dot.
  int GetNumberOfNotes();
  const char* GetNote(int note);
  ///@}

  ///@{
  /// What draws, of the style itself: always the same objects.
  virtual vtkMapper* GetMapper() = 0;
  virtual vtkActor* GetActor() = 0;
  ///@}

  /// The light that the style is drawn in, to be added to a renderer in place of its own lights; null where
  /// it needs none.
  virtual vtkLight* GetLight() { return nullptr; }

  /// The color of what lies around and behind the drawing, RGB in 0..1.
  virtual void GetBackgroundColor(double color[3]) = 0;

  /// The piece whose scalars marks can be colored by.
  virtual int GetColoredPiece() { return 0; }
  ///@{
  /// Whether marks are colored by the scalars that they have. Default: off.
  virtual void SetColorByScalars(bool byScalars) = 0;
  virtual bool GetColorByScalars() = 0;
  ///@}

  ///@{
  /// How many pixels are rendered for each of the picture on either side: 2 for a picture that is rendered
  /// twice as large and made smaller then, less than 1 for one in tiles, which enlarge what is in pixels.
  /// Parameters are in the picture's pixels. 0.001 to 16; default: 1.
  void SetPixelScale(double scale);
  vtkGetMacro(PixelScale, double);
  ///@}

  ///@{
  /// The larger side of the picture in its pixels, as far as the data fills it, or would fill a larger one of
  /// which this is a part: how many marks are made follows from it. Interactive marks are made again only
  /// where others would be. 1 to 100000; default: 600.
  void SetPictureSize(double pixels);
  vtkGetMacro(PictureSize, double);
  ///@}

  ///@{
  /// The height of that picture in its pixels, which lengths in thousandths are relative to. 1 to 100000;
  /// default: 600.
  void SetPictureHeight(double pixels);
  vtkGetMacro(PictureHeight, double);
  ///@}
  /// PictureSize in PictureHeights.
  double GetRelativeSize() const { return this->PictureSize / this->PictureHeight; }

  /// The camera of a still picture, once it is known which points it frames. Its explicit aspect ratio is the
  /// picture's.
  using StillCamera = std::function<vtkSmartPointer<vtkCamera>(vtkPoints* frame)>;
  /// A style may make no marks that such a picture does not show, as line art does: beyond its sides, or
  /// hidden by surfaces. Not for views that move. Default: none.
  void SetStillCamera(StillCamera camera);

  ///@{
  /// The memory in MiB that may be taken for an image, or its surfaces, and the marks; 0: no limit. See Draw
  /// of an algorithm. 0 to 16777216 (16 TiB); default: 0.
  vtkSetClampMacro(MaximumMemory, int, 0, 16777216);
  vtkGetMacro(MaximumMemory, int);
  ///@}
  /// MaximumMemory of a number with a unit, as "800MiB" or "1.5 GiB"; 0 if it is none, or less than 128 MiB.
  static int ParseMemory(const char* size);

  ///@{
  /// Whether parameters change while the marks stay as they are: how many are made then depends on no
  /// parameter that needs no new ones. Default: off.
  vtkSetMacro(Interactive, bool);
  vtkGetMacro(Interactive, bool);
  vtkBooleanMacro(Interactive, bool);
  ///@}

  ///@{
  /// Draw coarse meshes as the smooth surfaces that their point normals describe, with edges as curved PN
  /// triangles have them (Vlachos et al. 2001), instead of as polygons. Edges are curved that are longer than
  /// a hundredth of the diagonal; sharp edges stay sharp. Taken as they are: meshes of more than a million
  /// triangles, and by splatting lines those whose own points are drawn (NumberOfSamples 0). Default: on.
  vtkSetMacro(CurvedMeshes, bool);
  vtkGetMacro(CurvedMeshes, bool);
  vtkBooleanMacro(CurvedMeshes, bool);
  ///@}

  ///@{
  /// How far Make is, from 0 to 1, and with what; a ProgressEvent says when it changes. AbortMake, called
  /// from there, stops it.
  vtkGetMacro(Progress, double);
  const char* GetProgressText() { return this->ProgressText.c_str(); }
  void AbortMake() { this->Aborted = true; }
  ///@}

  ///@{
  /// The presets, the first of which is the default; a style may have none. They set the parameter Preset.
  int GetNumberOfPresets();
  const char* GetPresetName(int preset); ///< null out of range
  bool ApplyPreset(const char* name);
  ///@}

  ///@{
  /// The rows of the style's table, each by its index; names that begin with `GetParameter` give null, 0 or
  /// "" out of range. Type: bool, int, double, enum, color, colors, vector, list or string. Range: of each
  /// number, infinite where there is none. Level: whether it is essential, or advanced.
  int GetNumberOfParameters();
  const char* GetParameterName(int parameter);
  const char* GetParameterLabel(int parameter);
  const char* GetParameterType(int parameter);
  void GetParameterRange(int parameter, double range[2]);
  const char* GetParameterDefault(int parameter); ///< as text
  const char* GetParameterUnit(int parameter);
  const char* GetParameterGroup(int parameter);
  const char* GetParameterText(int parameter);
  bool IsParameterEssential(int parameter);
  int GetNumberOfParameterEntries(int parameter);
  const char* GetParameterEntry(int parameter, int entry); ///< null out of range
  ///@}

  ///@{
  /// Sets a parameter, by its name, to numbers or to what is written: numbers with commas between them, on or
  /// off, an entry's name, colors by name or as #rrggbb. False, after one error, if it is refused.
  bool SetParameter(const char* name, double value);
  bool SetParameter(const char* name, double first, double second);
  bool SetParameter(const char* name, double first, double second, double third);
  bool SetParameterAsString(const char* name, const char* text);
  ///@}

  ///@{
  /// A parameter's value as text that SetParameterAsString takes, or its first number; "" and 0 for an
  /// unknown name.
  std::string GetParameterAsString(const char* name);
  double GetParameter(const char* name);
  ///@}

  /// All parameters as they are by default.
  void ResetParameters();

  ///@{
  /// All parameters as JSON, {"style": "stipple", "parameters": {"Preset": "bone", ...}}; and some or all of
  /// them from it. Those that are read are set together: what a parameter implies, as ToneColor implies
  /// ColorByTone, holds unless it is given, too.
  /// @return what is wrong, with the key, what was found and what was expected; nothing is set then. Empty if
  /// all is right
  std::string GetParametersAsJSON();
  std::string SetParametersFromJSON(const std::string& json);
  ///@}

  /// Parameters by name, with their values.
  using Settings = std::vector<std::pair<std::string, InkParameterValue>>;
  /// Sets them together, as SetParametersFromJSON does. @return what is wrong; empty if all is right
  std::string SetParameters(const Settings& given);

  /// The name of the style that such JSON is for, known or not; empty if it says none.
  static std::string FindStyleInJSON(const std::string& json);

  /// The row of that name, null if there is none. @return what is wrong then
  std::string FindParameterRow(const std::string& name, const InkParameter*& row);
  /// The table that all of these are made from.
  virtual const InkParameterTable& GetParameterTable() = 0;

protected:
  vtkInkStyle();
  ~vtkInkStyle() override;

  /// When the algorithms of the recipe were changed last.
  virtual vtkMTimeType GetRecipeMTime() = 0;
  /// Fills the pieces and returns what is wrong, or nothing.
  virtual std::string MakePieces(const Input& input) = 0;
  /// Whether it is the surfaces of an image that are drawn, not its voxels.
  virtual bool DrawsSurfaces(const Input&) const { return true; }
  /// What samples the surfaces of an image that is not in memory as a whole, as their points are all that is
  /// drawn; null where they are not.
  virtual InkIsoSurface* GetSampledSurface() { return nullptr; }
  /// Called when the pixel scale has changed.
  virtual void UpdatePixels() {}
  /// What follows from parameters that were given together.
  virtual void FollowParameters(const Settings&) {}

  void AddNote(const std::string& note);
  /// Says of the marks being made that they are the same for pictures of which PictureSize measures from
  /// `least` to `most` PictureHeights; of several calls all count. Least above most: for no other.
  void LimitPictures(double least, double most);
  /// Of the bounds of all processes' data, in world units; 0: unknown, as where the style is not Interactive.
  double GetDataDiagonal() const { return this->DataDiagonal; }
  /// Where the frame is not that of the first piece's points; for MakePieces.
  void SetFramePoints(vtkPoints* points) { this->FramePoints = points; }
  /// That of the still picture, null where all may be seen; for MakePieces, once the frame is known.
  vtkSmartPointer<vtkCamera> FindStillCamera();
  InkStyleProcesses& GetProcesses();
  /// Lets another style make its marks for this one: for the same picture and processes, with its progress
  /// and its notes as this style's. @return what is wrong
  std::string MakeMarksOf(vtkInkStyle* part, const Input& input);
  /// Brings an algorithm up to date, with the progress as this style's and its errors caught.
  /// @param text what it does, "placing stipples"
  /// @param update calls its Update
  /// @return its first error; empty if there was none
  template <class Update>
  std::string Follow(vtkAlgorithm* algorithm, const char* text, const Update& update)
  {
    const std::shared_ptr<void> following = this->StartFollowing(algorithm, text);
    update();
    return this->AlgorithmError;
  }
  std::string Follow(vtkAlgorithm* algorithm, const char* text);
  /// Begins a step of what is made. @return takes how far it is, from 0 to 1, and tells whether to go on
  std::function<bool(double)> StartStep(const char* text);

  /// The surfaces of leaves as one mesh, as TakeSurface makes it; of several processes all on the first one.
  /// All take part.
  vtkSmartPointer<vtkPolyData> GatherMesh(const InkLeaves& leaves);
  /// The mesh as it is to be drawn: of lines tubes (InkTubes.h), with a note; curved where that is asked for
  /// (InkCurvedMesh), with a note if it had no normals; or itself.
  vtkSmartPointer<vtkPolyData> TakeSurface(vtkPolyData* mesh);
  /// Takes a mesh with point normals, those of one side at feature edges (InkWithFeatureNormals): its own
  /// ones, or an array "Normals", or, with a note, those of its polygons.
  /// @param piece becomes the mesh
  /// @return what is wrong; empty if nothing is
  std::string TakeMeshWithNormals(vtkPolyData* mesh, vtkPolyData* piece);
  /// Takes points without polygons as discs, with their own normals and radii or, with a note, estimated
  /// ones.
  /// @param sampler with its settings
  /// @param piece becomes the discs
  /// @return what is wrong; empty if nothing is
  std::string TakeDiscs(vtkInkSurfaceSampler* sampler, vtkPolyData* points, vtkPolyData* piece);

private:
  friend class InkContourSurface;
  friend class InkIsoSurface;
  friend class InkSilhouetteMethod;
  vtkInkStyle(const vtkInkStyle&) = delete;
  void operator=(const vtkInkStyle&) = delete;

  void NoteMissingNormals(vtkPolyData* mesh);
  /// Observes an algorithm until the returned pointer goes.
  std::shared_ptr<void> StartFollowing(vtkAlgorithm* algorithm, const char* text);
  const InkParameter* FindParameter(int parameter);
  std::string SetOne(const std::string& name, const InkParameterValue& value);
  bool ReportProblem(const std::string& problem);

  std::string TryPieces(const Input& input);
  /// The same, but with what an image in memory was made of, if it was enlarged (InkOriginalImage.h), and a
  /// note: by repeating samples, unless LabelMap is off, or by interpolating slices, if surfaces are drawn
  /// and ShapeBasedInterpolation is automatic.
  Input TakeOriginal(const Input& input);
  void SetPicture(double& side, double pixels);
  double FindDiagonal(vtkDataObject* data);
  /// MakePieces, of points where there are surfaces in place of data.
  std::string MakePiecesOrSurfaces(const Input& input);
  std::string RefuseParts(vtkInkIsoSurfaceAlgorithm* sampler);
  /// Why so many points cannot be drawn; empty if they can.
  std::string FindMemoryProblem(vtkIdType points) const;

  std::unique_ptr<InkOriginalImage> Original;
  std::vector<vtkSmartPointer<vtkPolyData>> Pieces;
  vtkSmartPointer<vtkPoints> FramePoints;
  vtkMTimeType TimeBeforeMaking = 0;
  vtkMTimeType TimeAfterMaking = 0; ///< of the recipe, which is given inputs and more for as long as it runs
  std::vector<std::string> Notes;
  std::shared_ptr<InkStyleProcesses> Processes;
  StillCamera Still;
  double PixelScale = 1.0;
  double PictureSize = 600.0;
  double PictureHeight = 600.0;
  double DataDiagonal = 0.0;
  double LeastRelativeSize = 0.0; ///< of pictures that the marks suit
  double MostRelativeSize = std::numeric_limits<double>::infinity();
  int MaximumMemory = 0;
  bool Interactive = false;
  bool CurvedMeshes = true;
  double Progress = 0.0;
  std::string ProgressText;
  std::string AlgorithmError;
  bool Aborted = false;
};

#endif
