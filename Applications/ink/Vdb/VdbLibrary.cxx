// SPDX-License-Identifier: BSD-3-Clause
#include "VdbLibrary.h"
#include "VdbParts.h"

extern "C" const ink::cli::VdbLibrary inkVdbLibrary = { ink::cli::readVdb, ink::cli::convertToVdb };
