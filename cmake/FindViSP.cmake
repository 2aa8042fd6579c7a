# SPDX-License-Identifier: Apache-2.0
# ViSP::tt, its template trackers. ViSP's own package file comes with all of its modules only.
find_path(ViSP_INCLUDE_DIR visp3/tt/vpTemplateTracker.h)
find_library(ViSP_tt_LIBRARY NAMES visp_tt)
find_library(ViSP_core_LIBRARY NAMES visp_core)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(ViSP
  REQUIRED_VARS ViSP_tt_LIBRARY ViSP_core_LIBRARY ViSP_INCLUDE_DIR)
if(ViSP_FOUND AND NOT TARGET ViSP::tt)
  add_library(ViSP::tt UNKNOWN IMPORTED)
  set_target_properties(ViSP::tt PROPERTIES
    IMPORTED_LOCATION ${ViSP_tt_LIBRARY}
    INTERFACE_LINK_LIBRARIES ${ViSP_core_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${ViSP_INCLUDE_DIR})
endif()
