// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkWindowResources_h
#define InkWindowResources_h

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"

#include <memory>
#include <vector>

/// What a mapper keeps on the GPU, apart for each window that it is drawn in: made when it is first drawn
/// there, and destroyed, with the window's context current, when the window is deleted, which may no longer
/// know the mapper, when the mapper is told to release it, or with this.
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
    {
      this->Observer->SetClientData(this);
      this->Observer->SetCallback(
        [](vtkObject*, unsigned long, void* holder, void*) { static_cast<Holder*>(holder)->Free(); });
      this->Tag = window->AddObserver(vtkCommand::DeleteEvent, this->Observer);
    }
    ~Holder() { this->Free(); }
    Holder(const Holder&) = delete;
    void operator=(const Holder&) = delete;

    void Free()
    {
      if (this->Own)
      {
        this->Window->RemoveObserver(this->Tag);
        this->Window->PushContext();
        this->Own.reset();
        this->Window->PopContext();
      }
    }

    vtkOpenGLRenderWindow* Window; ///< there as long as Own is
    std::unique_ptr<Resources> Own;
    vtkNew<vtkCallbackCommand> Observer;
    unsigned long Tag = 0;
  };

  std::vector<std::unique_ptr<Holder>> Holders;
};

#endif
