# SPDX-License-Identifier: Apache-2.0
# Parquet::Parquet (with Arrow::Arrow), from an installed copy or the one scripts/setup fetched.
set(_fetched ${PACER_DEPS_DIR}/pyarrow)
find_path(Parquet_INCLUDE_DIR parquet/arrow/writer.h HINTS ${_fetched}/include)
foreach(_name arrow parquet)
  find_library(Parquet_${_name}_LIBRARY NAMES ${_name})
  file(GLOB _versioned ${_fetched}/lib${_name}.so.*)  # the wheel carries no plain .so link
  if(NOT Parquet_${_name}_LIBRARY AND _versioned)
    list(GET _versioned 0 _first)
    set(Parquet_${_name}_LIBRARY ${_first} CACHE FILEPATH "lib${_name}" FORCE)
  endif()
endforeach()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Parquet
  REQUIRED_VARS Parquet_parquet_LIBRARY Parquet_arrow_LIBRARY Parquet_INCLUDE_DIR
  REASON_FAILURE_MESSAGE "run scripts/setup, or set Parquet_ROOT")
if(Parquet_FOUND AND NOT TARGET Parquet::Parquet)
  add_library(Arrow::Arrow SHARED IMPORTED)
  set_target_properties(Arrow::Arrow PROPERTIES IMPORTED_LOCATION ${Parquet_arrow_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${Parquet_INCLUDE_DIR})
  add_library(Parquet::Parquet SHARED IMPORTED)
  set_target_properties(Parquet::Parquet PROPERTIES IMPORTED_LOCATION ${Parquet_parquet_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${Parquet_INCLUDE_DIR} INTERFACE_LINK_LIBRARIES Arrow::Arrow)
endif()
