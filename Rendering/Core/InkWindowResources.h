// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkWindowResources_h
#define InkWindowResources_h

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLResourceFreeCallback.h"

#include <memory>
#include <vector>

/// What a mapper keeps on the GPU, apart for each window that it is drawn in: made when it is first drawn
/// there, and destroyed, while the window's context is current, when the window releases its graphics
/// resources, whether or not the window still knows the mapper, or with this.
/// @tparam Resources are made from a vtkOpenGLRenderWindow*
template <class Resources>
class InkWindowResources
{
public:
  InkWindowResources() = default;
  InkWindowResources(const InkWindowResources&) = delete;
  void operator=(const InkWindowResources&) = delete;

  /// Those of a window whose context is current.
  Resources& Get(vtkOpenGLRenderWindow* window)
  {
    if (Resources* found = this->Find(window))
    {
      return *found;
    }
    std::erase_if(this->Holders, [](const auto& holder) { return !holder->Own; });
    return *this->Holders.emplace_back(std::make_unique<Holder>(window))->Own;
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
    explicit Holder(vtkOpenGLRenderWindow* window)
      : Window(window)
      , Own(std::make_unique<Resources>(window))
      , Callback(this, &Holder::Free)
    {
      this->Callback.RegisterGraphicsResources(window);
    }
    ~Holder() { this->Callback.Release(); }
    Holder(const Holder&) = delete;
    void operator=(const Holder&) = delete;
    /// By the callback, which has made the window's context current.
    void Free(vtkWindow*) { this->Own.reset(); }

    vtkWindow* Window; ///< only compared
    std::unique_ptr<Resources> Own;
    vtkOpenGLResourceFreeCallback<Holder> Callback;
  };

  std::vector<std::unique_ptr<Holder>> Holders;
};

#endif
