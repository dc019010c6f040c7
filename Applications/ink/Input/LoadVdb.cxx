// SPDX-License-Identifier: BSD-3-Clause
#include "Vdb/VdbLibrary.h"

#include "Errors.h"

#include <dlfcn.h>

namespace ink::cli
{
namespace
{

const VdbLibrary* load()
{
  // Found as the libraries that ink is linked with are.
  void* library = dlopen(INK_VDB_LIBRARY, RTLD_NOW | RTLD_LOCAL);
  const void* found = library ? dlsym(library, "inkVdbLibrary") : nullptr;
  if (!found)
  {
    throw Failure(std::string("cannot load what reads and writes OpenVDB files: ") + dlerror());
  }
  return static_cast<const VdbLibrary*>(found);
}

} // namespace

const VdbLibrary& vdbLibrary()
{
  static const VdbLibrary* const library = load();
  return *library;
}

} // namespace ink::cli
