# SPDX-License-Identifier: BSD-3-Clause
# GDCM::MSFF, which decompresses the pixels of DICOM files. GDCM's own package wants its programs installed, too.
find_path(GDCM_INCLUDE_DIR gdcmImage.h PATH_SUFFIXES gdcm-3.0 REQUIRED)
mark_as_advanced(GDCM_INCLUDE_DIR)
if (NOT TARGET GDCM::MSFF)
  add_library(GDCM::MSFF INTERFACE IMPORTED)
  target_include_directories(GDCM::MSFF SYSTEM INTERFACE "${GDCM_INCLUDE_DIR}")
  foreach (library IN ITEMS MSFF DSED Common)
    find_library(GDCM_${library}_LIBRARY gdcm${library} REQUIRED)
    mark_as_advanced(GDCM_${library}_LIBRARY)
    target_link_libraries(GDCM::MSFF INTERFACE "${GDCM_${library}_LIBRARY}")
  endforeach ()
endif ()
