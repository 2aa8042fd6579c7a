# SPDX-License-Identifier: Apache-2.0
# One INTERFACE target says how this project is compiled; third-party targets never see it.
add_library(pacer_options INTERFACE)
target_compile_features(pacer_options INTERFACE cxx_std_20)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

option(PACER_WERROR "Treat warnings as errors" OFF)
option(PACER_COVERAGE "Count covered lines" OFF)
set(PACER_SANITIZE "" CACHE STRING "Sanitizers, e.g. address,undefined or thread")

set(_warnings
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wnon-virtual-dtor -Wold-style-cast
  -Woverloaded-virtual -Wdouble-promotion
  $<$<CXX_COMPILER_ID:GNU>:-Wduplicated-cond -Wlogical-op>
  # GCC 12 cries wolf over std::string (its bugs 105651, 105562); clang-tidy looks for the real ones
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-maybe-uninitialized>
  $<$<BOOL:${PACER_WERROR}>:-Werror>)
target_compile_options(pacer_options INTERFACE
  $<BUILD_INTERFACE:${_warnings}>
  $<BUILD_INTERFACE:-ffp-contract=off>)  # the same arithmetic with and without FMA
if(PACER_SANITIZE)
  # Null pointers end in the address sanitizer's hands anyway; to ask at each use of a pointer or a
  # reference whether it is null, aligned and of its type takes a quarter of the build.
  set(_sanitized -fsanitize=${PACER_SANITIZE} -fno-sanitize=null,alignment,vptr
    -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_compile_options(pacer_options INTERFACE "$<BUILD_INTERFACE:${_sanitized}>")
  target_link_options(pacer_options INTERFACE $<BUILD_INTERFACE:-fsanitize=${PACER_SANITIZE}>)
endif()
if(PACER_COVERAGE)
  target_compile_options(pacer_options INTERFACE $<BUILD_INTERFACE:--coverage>)
  target_link_options(pacer_options INTERFACE $<BUILD_INTERFACE:--coverage>)
endif()

# pacer_library(NAME source...): one static library a module, pacer_NAME, alias pacer::NAME. Under a
# sanitizer the modules that compose what others compute are not optimised, nor are test programs:
# that halves the time that building them takes.
set(_composing scenarios runs tracking_runs report progress studies)
function(pacer_library name)
  add_library(pacer_${name} STATIC ${ARGN})
  add_library(pacer::${name} ALIAS pacer_${name})
  set_target_properties(pacer_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_include_directories(pacer_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/generated>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/pacer>)
  target_link_libraries(pacer_${name} PUBLIC pacer_options)
  if(PACER_SANITIZE AND name IN_LIST _composing)
    target_compile_options(pacer_${name} PRIVATE -O0)
  endif()
endfunction()

# pacer_test(NAME LABEL label... LIBS target... SOURCES file... [TOGETHER suite...] [TIMEOUT s]
#   [THREADED filter]):
# GoogleTest, a process a test, but for the suites of TOGETHER: their tests share what is costly to
# make, so each such suite is one process. Under a sanitizer, where starting one costs more than most
# tests do, a whole program is.
function(pacer_test name)
  cmake_parse_arguments(ARG "" "TIMEOUT;THREADED" "LABEL;LIBS;SOURCES;TOGETHER" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 60)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE ${ARG_LIBS} GTest::gmock GTest::gtest_main)
  if("threads" IN_LIST ARG_LABEL)
    add_dependencies(threaded_tests ${name})
  endif()
  if(NOT "render" IN_LIST ARG_LABEL AND NOT "training" IN_LIST ARG_LABEL)
    add_dependencies(plain_tests ${name})
  endif()
  if(PACER_SANITIZE)
    target_compile_options(${name} PRIVATE -O0)
    set(filter "*")
    if(ARG_THREADED AND PACER_SANITIZE STREQUAL "thread")
      set(filter "${ARG_THREADED}")  # the rest shows it nothing, and takes minutes
    endif()
    add_test(NAME ${name} COMMAND ${name} "--gtest_filter=${filter}")
    set_tests_properties(${name} PROPERTIES LABELS "${ARG_LABEL}" TIMEOUT 900)
    return()
  endif()
  set(apart "*")
  if(ARG_TOGETHER)
    list(TRANSFORM ARG_TOGETHER APPEND ".*" OUTPUT_VARIABLE suites)
    list(JOIN suites ":" suites)
    set(apart "-${suites}")
  endif()
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST TEST_FILTER "${apart}"
    PROPERTIES TIMEOUT ${ARG_TIMEOUT})
  # Discovery takes a list of labels apart, so they are set once it is done.
  set(labels ${CMAKE_CURRENT_BINARY_DIR}/${name}_labels.cmake)
  file(WRITE ${labels} "if(${name}_TESTS)
  set_tests_properties(\${${name}_TESTS} PROPERTIES LABELS \"${ARG_LABEL}\")
endif()\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${labels})
  foreach(suite ${ARG_TOGETHER})
    add_test(NAME ${suite} COMMAND ${name} --gtest_filter=${suite}.*)
    set_tests_properties(${suite} PROPERTIES LABELS "${ARG_LABEL}" TIMEOUT ${ARG_TIMEOUT}
      FAIL_REGULAR_EXPRESSION "Running 0 tests")
  endforeach()
endfunction()
