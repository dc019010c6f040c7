// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkActorResources_h
#define InkActorResources_h

#include "vtkActor.h"
#include "vtkRenderer.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <vector>

/// What a mapper keeps on the GPU for each actor in each renderer of a window.
template <class Resources>
class InkActorResources
{
public:
  /// Those of an actor in a renderer; null if there are none.
  Resources* Find(vtkRenderer* renderer, vtkActor* actor)
  {
    const auto found = std::find_if(this->Entries.begin(), this->Entries.end(),
      [&](const Entry& e) { return e.Renderer == renderer && e.Actor == actor; });
    return found == this->Entries.end() ? nullptr : &found->Own;
  }

  /// The same, made if there are none; those of actors and renderers that are gone go, for which the window's
  /// context must be current.
  Resources& Get(vtkRenderer* renderer, vtkActor* actor)
  {
    std::erase_if(this->Entries, [](const Entry& e) { return !e.Renderer || !e.Actor; });
    if (Resources* found = this->Find(renderer, actor))
    {
      return *found;
    }
    Entry& entry = this->Entries.emplace_back();
    entry.Renderer = renderer;
    entry.Actor = actor;
    return entry.Own;
  }

  /// Calls a function with the resources of each actor in each renderer.
  template <class Function>
  void ForEach(const Function& function) const
  {
    for (const Entry& entry : this->Entries)
    {
      function(entry.Own);
    }
  }

private:
  struct Entry
  {
    vtkWeakPointer<vtkRenderer> Renderer;
    vtkWeakPointer<vtkActor> Actor;
    Resources Own;
  };
  std::vector<Entry> Entries;
};

#endif
