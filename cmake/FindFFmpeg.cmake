# SPDX-License-Identifier: Apache-2.0
# FFmpeg::avcodec, FFmpeg::avformat, FFmpeg::avutil, FFmpeg::swscale.
set(_required "")
foreach(_name avcodec avformat avutil swscale)
  find_path(FFmpeg_${_name}_INCLUDE_DIR lib${_name}/${_name}.h PATH_SUFFIXES ffmpeg)
  find_library(FFmpeg_${_name}_LIBRARY NAMES ${_name})
  list(APPEND _required FFmpeg_${_name}_LIBRARY FFmpeg_${_name}_INCLUDE_DIR)
endforeach()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(FFmpeg REQUIRED_VARS ${_required}
  REASON_FAILURE_MESSAGE "run scripts/setup")
foreach(_name avcodec avformat avutil swscale)
  if(FFmpeg_FOUND AND NOT TARGET FFmpeg::${_name})
    add_library(FFmpeg::${_name} UNKNOWN IMPORTED)
    set_target_properties(FFmpeg::${_name} PROPERTIES
      IMPORTED_LOCATION ${FFmpeg_${_name}_LIBRARY}
      INTERFACE_INCLUDE_DIRECTORIES ${FFmpeg_${_name}_INCLUDE_DIR})
  endif()
endforeach()
