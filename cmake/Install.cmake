# SPDX-License-Identifier: Apache-2.0
# What `cmake --install` puts where, so that another project can say
#   find_package(pacer CONFIG REQUIRED)
#   target_link_libraries(mine PRIVATE pacer::learning)
# and include "learning/affordance/train.h". The command goes to bin/.
include(CMakePackageConfigHelpers)
set(_modules core learning sim dataset scenarios runs)
set(_package ${CMAKE_INSTALL_LIBDIR}/cmake/pacer)

set(_targets pacer_options pacer_baselines pacer_exemplar pacer_report pacer_tracking pacer_tracking_runs)
foreach(_module ${_modules})
  list(APPEND _targets pacer_${_module})
  install(DIRECTORY ${_module} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/pacer
    FILES_MATCHING PATTERN "*.h")
endforeach()
install(FILES ${PROJECT_BINARY_DIR}/generated/core/version.h
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/pacer/core)
set_target_properties(pacer_options PROPERTIES EXPORT_NAME options)
install(TARGETS ${_targets} EXPORT pacerTargets)
install(EXPORT pacerTargets NAMESPACE pacer:: DESTINATION ${_package})

# The wheels' libraries stay where they are: the command and the package look for them there.
set_target_properties(pacer PROPERTIES INSTALL_RPATH
  "$<TARGET_FILE_DIR:MuJoCo::MuJoCo>;$<TARGET_FILE_DIR:Parquet::Parquet>;$<TARGET_FILE_DIR:Arrow::Arrow>")
install(TARGETS pacer)
install(DIRECTORY scenarios DESTINATION ${CMAKE_INSTALL_DATADIR}/pacer FILES_MATCHING PATTERN "*.yaml")

configure_package_config_file(cmake/pacerConfig.cmake.in ${PROJECT_BINARY_DIR}/pacerConfig.cmake
  INSTALL_DESTINATION ${_package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/pacerConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/pacerConfig.cmake ${PROJECT_BINARY_DIR}/pacerConfigVersion.cmake
  cmake/FindFFmpeg.cmake cmake/FindMuJoCo.cmake cmake/FindParquet.cmake DESTINATION ${_package})
