# SPDX-License-Identifier: BSD-3-Clause
# VTK 9.7 writes $<COMPILE_ONLY:...>, which CMake knows from 3.27 on, into the link interface of a few of
# its targets. Older CMakes need it taken out; what it names are headers of other packages (X11).
if (CMAKE_VERSION VERSION_LESS 3.27)
  foreach (_ink_target IN ITEMS VTK::x11)
    if (TARGET ${_ink_target})
      get_target_property(_ink_interface ${_ink_target} INTERFACE_LINK_LIBRARIES)
      if (_ink_interface)
        string(REGEX REPLACE "\\$<COMPILE_ONLY:[^>]*>;?" "" _ink_interface "${_ink_interface}")
        set_target_properties(${_ink_target} PROPERTIES INTERFACE_LINK_LIBRARIES "${_ink_interface}")
      endif ()
    endif ()
  endforeach ()
endif ()
