// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkWindowResources_h
#define InkWindowResources_h

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

#include <functional>
#include <memory>
#include <utility>
#include <vector>

/// Hears when a window releases its graphics resources. VTK's callback for that is in a header that not all
/// of its packages install; a texture object, here one without a texture, has one.
class InkReleaseNotice : public vtkTextureObject
{
public:
  static InkReleaseNotice* New() { VTK_STANDARD_NEW_BODY(InkReleaseNotice); }
  vtkTypeMacro(InkReleaseNotice, vtkTextureObject);

  /// @param onRelease is called once, with the window's context current
  void Set(vtkOpenGLRenderWindow* window, std::function<void()> onRelease)
  {
    this->OnRelease = std::move(onRelease);
    this->SetContext(window);
  }
  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    if (const auto onRelease = std::exchange(this->OnRelease, nullptr))
    {
      onRelease();
    }
    this->Superclass::ReleaseGraphicsResources(window);
  }

protected:
  InkReleaseNotice() = default;
  ~InkReleaseNotice() override = default;

private:
  InkReleaseNotice(const InkReleaseNotice&) = delete;
  void operator=(const InkReleaseNotice&) = delete;

  std::function<void()> OnRelease;
};

/// What a mapper keeps on the GPU, apart for each window that it is drawn in: made when it is first drawn
/// there, and destroyed, while the window's context is current, when the window releases its graphics
/// resources, whether or not the window still knows the mapper, or with this.
template <class Resources>
class InkWindowResources
{
public:
  InkWindowResources() = default;
  InkWindowResources(const InkWindowResources&) = delete;
  void operator=(const InkWindowResources&) = delete;

  /// Those of a window whose context is current.
  /// @param make them from a window, as a std::unique_ptr
  template <class Make>
  Resources& Get(vtkOpenGLRenderWindow* window, const Make& make)
  {
    if (Resources* found = this->Find(window))
    {
      return *found;
    }
    std::erase_if(this->Holders, [](const auto& holder) { return !holder->Own; });
    return *this->Holders.emplace_back(std::make_unique<Holder>(window, make(window)))->Own;
  }

  /// Those of a window, or null.
  Resources* Find(vtkWindow* window) const
  {
    for (const auto& holder : this->Holders)
    {
      if (holder->Own && holder->Window == window)
      {
        return holder->Own.get();
      }
    }
    return nullptr;
  }

  /// Destroys those of a window. VTK names none where a prop has no window yet: that changes nothing.
  void Release(vtkWindow* window)
  {
    std::erase_if(
      this->Holders, [&](const auto& holder) { return !holder->Own || holder->Window == window; });
  }

  /// Calls a function with the resources of each window.
  template <class Function>
  void ForEach(const Function& function) const
  {
    for (const auto& holder : this->Holders)
    {
      if (holder->Own)
      {
        function(*holder->Own);
      }
    }
  }

private:
  struct Holder
  {
    Holder(vtkOpenGLRenderWindow* window, std::unique_ptr<Resources> own)
      : Window(window)
      , Own(std::move(own))
    {
      this->Notice->Set(window, [this] { this->Own.reset(); });
    }
    /// With the window's context current, if there still is one.
    ~Holder() { this->Notice->SetContext(nullptr); }
    Holder(const Holder&) = delete;
    void operator=(const Holder&) = delete;

    vtkWindow* Window; ///< only compared
    std::unique_ptr<Resources> Own;
    vtkNew<InkReleaseNotice> Notice;
  };

  std::vector<std::unique_ptr<Holder>> Holders;
};

#endif
