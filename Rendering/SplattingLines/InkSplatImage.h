// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkSplatImage_h
#define InkSplatImage_h

#include "vtkNew.h"

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkTextureObject;

/// An image that is drawn into and read from, with further images and depth beside it as needed.
class InkSplatImage
{
public:
  enum class Format
  {
    Float2, ///< two 32-bit floats a pixel
    Float4,
    Half4, ///< four 16-bit floats
    Byte4,
    Depth ///< a 32-bit z-buffer; cannot be drawn into by itself
  };

  /// @param beside is drawn into at the same time, as the second image, or null
  /// @param depth the z-buffer for drawing into this, or null; both of the same size and outliving this
  InkSplatImage(vtkOpenGLRenderWindow* window, Format format, int width, int height,
    InkSplatImage* beside = nullptr, InkSplatImage* depth = nullptr);
  ~InkSplatImage();
  InkSplatImage(const InkSplatImage&) = delete;
  void operator=(const InkSplatImage&) = delete;

  /// False when this OpenGL cannot draw into such images.
  bool IsComplete() const { return this->Complete; }

  /// Makes this the target of drawing, with a viewport that fills it.
  void Bind();

  /// What this shows, into another image of the same size and format.
  void CopyTo(InkSplatImage& other);

  /// Makes this what glReadPixels reads.
  void BindForReading();

  /// Binds a texture to a texture unit while it lives, for a shader's sampler.
  class Reading
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
  vtkOpenGLRenderWindow* Window; // outlives this: released with the window's resources
  int Width;
  int Height;
  int NumberOfTargets;
  vtkNew<vtkTextureObject> Texture;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  bool Complete = true;
};

#endif
