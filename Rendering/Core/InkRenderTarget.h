// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkRenderTarget_h
#define InkRenderTarget_h

#include "vtkInkRenderingCoreModule.h" // for the export macro

#include "vtkNew.h"

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkTextureObject;

/// An image that is drawn into and read from, with a further image and depth beside it as needed.
class VTKINKRENDERINGCORE_EXPORT InkRenderTarget
{
public:
  enum class Format
  {
    Float2, ///< two 32-bit floats a pixel
    Float4,
    Half4, ///< four 16-bit floats
    Byte4,
    Depth ///< a 32-bit z-buffer; by itself only depth is drawn
  };

  /// @param beside is drawn into at the same time, as the second image, or null
  /// @param depth the z-buffer for drawing into this, or null; both of the same size and outliving this
  InkRenderTarget(vtkOpenGLRenderWindow* window, Format format, int width, int height,
    InkRenderTarget* beside = nullptr, InkRenderTarget* depth = nullptr);
  ~InkRenderTarget();
  InkRenderTarget(const InkRenderTarget&) = delete;
  void operator=(const InkRenderTarget&) = delete;

  /// False when this OpenGL cannot draw into such images.
  bool IsComplete() const { return this->Complete; }

  /// Makes this the target of drawing, with a viewport that fills it.
  void Bind();

  /// What this shows, into another image of the same size and format.
  void CopyTo(InkRenderTarget& other);

  /// Makes this what glReadPixels reads.
  void BindForReading();

  /// Binds a texture to a texture unit while it lives, for a shader's sampler.
  class VTKINKRENDERINGCORE_EXPORT Reading
  {
  public:
    explicit Reading(vtkTextureObject& texture);
    ~Reading();
    Reading(const Reading&) = delete;
    void operator=(const Reading&) = delete;
    int GetUnit() const;

  private:
    vtkTextureObject* Texture;
  };

  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  vtkTextureObject* GetTexture() const { return this->Texture; }

private:
  /// Draws into this one's images from now on.
  void ActivateDrawBuffers();

  vtkOpenGLRenderWindow* Window; // outlives this: released with the window's resources
  int Width;
  int Height;
  int NumberOfColors; ///< images that are drawn into at once
  vtkNew<vtkTextureObject> Texture;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  bool Complete;
};

#endif
