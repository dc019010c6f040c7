# SPDX-License-Identifier: BSD-3-Clause
# cmake -DFOLDER=FOLDER -P StartCapturing.cmake: an empty folder.
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")
