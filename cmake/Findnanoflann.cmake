# SPDX-License-Identifier: Apache-2.0
# nanoflann is one header: nanoflann_INCLUDE_DIR.
find_path(nanoflann_INCLUDE_DIR nanoflann.hpp)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(nanoflann REQUIRED_VARS nanoflann_INCLUDE_DIR)
mark_as_advanced(nanoflann_INCLUDE_DIR)
