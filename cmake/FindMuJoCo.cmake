# SPDX-License-Identifier: Apache-2.0
# MuJoCo::MuJoCo, from an installed copy (MuJoCo_ROOT, system) or the one scripts/setup fetched.
set(_fetched ${PACER_DEPS_DIR}/mujoco)
find_path(MuJoCo_INCLUDE_DIR mujoco/mujoco.h HINTS ${_fetched}/include)
file(GLOB _versioned ${_fetched}/libmujoco.so.*)  # the wheel carries no plain .so link
find_library(MuJoCo_LIBRARY NAMES mujoco)
if(NOT MuJoCo_LIBRARY AND _versioned)
  list(GET _versioned 0 _first)
  set(MuJoCo_LIBRARY ${_first} CACHE FILEPATH "MuJoCo library" FORCE)
endif()
if(MuJoCo_INCLUDE_DIR)
  file(STRINGS ${MuJoCo_INCLUDE_DIR}/mujoco/mujoco.h _line REGEX "#define mjVERSION_HEADER")
  string(REGEX MATCH "[0-9]+$" _number "${_line}")
  math(EXPR _major "${_number} / 1000000")
  math(EXPR _minor "(${_number} / 1000) % 1000")
  math(EXPR _patch "${_number} % 1000")
  set(MuJoCo_VERSION ${_major}.${_minor}.${_patch})
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(MuJoCo
  REQUIRED_VARS MuJoCo_LIBRARY MuJoCo_INCLUDE_DIR VERSION_VAR MuJoCo_VERSION HANDLE_VERSION_RANGE
  REASON_FAILURE_MESSAGE "run scripts/setup, or set MuJoCo_ROOT")
if(MuJoCo_FOUND AND NOT TARGET MuJoCo::MuJoCo)
  add_library(MuJoCo::MuJoCo SHARED IMPORTED)
  set_target_properties(MuJoCo::MuJoCo PROPERTIES
    IMPORTED_LOCATION ${MuJoCo_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${MuJoCo_INCLUDE_DIR})
endif()
