# SPDX-License-Identifier: Apache-2.0
# Installs the built tree aside, builds another project against what was installed, and runs both.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGN}: ended with ${status}\n${said}")
  endif()
  set(said "${said}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${SCRATCH})
set(prefix ${SCRATCH}/prefix)
run(${CMAKE_COMMAND} --install ${BUILD} --config ${CONFIG} --prefix ${prefix})
run(${CMAKE_COMMAND} -G ${GENERATOR} -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${SCRATCH}/build
  -D CMAKE_BUILD_TYPE=${CONFIG} -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_PREFIX_PATH=${prefix})
run(${CMAKE_COMMAND} --build ${SCRATCH}/build)
run(${SCRATCH}/build/consumer ${prefix}/share/pacer/scenarios/follow.yaml)
if(NOT said STREQUAL "follow: straight on is 1500 us, 6 action types\n")
  message(FATAL_ERROR "the other project said: ${said}")
endif()
run(${prefix}/bin/pacer inspect ${prefix}/share/pacer/scenarios/follow.yaml)
file(REMOVE_RECURSE ${SCRATCH})
