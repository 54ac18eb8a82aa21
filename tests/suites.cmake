# Tests of a program of GoogleTest, one for each of its suites: `riffle_discover_suites(test_sph LABELS unit)` names them
# sph.Suite. A process for each of 2500 tests, as gtest_discover_tests has, takes half as much time again. `ctest -R Suite` runs
# a suite, `bin/test_sph --gtest_filter=Suite.Test` a single test.
#
# Included, it defines that function. As a script (-P) it writes the tests of a program that has just been linked.

if(CMAKE_SCRIPT_MODE_FILE)
  execute_process(COMMAND ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE listed RESULT_VARIABLE status)
  if(status)
    message(FATAL_ERROR "${PROGRAM} --gtest_list_tests failed (${status}), so its tests are not known; run it by hand.")
  endif()
  string(REGEX MATCHALL "(^|\n)[^ \n][^ \n]*\\.( |\n)" lines "${listed}")
  set(tests "")
  foreach(line ${lines})
    string(STRIP "${line}" suite)
    string(REGEX REPLACE "\\.$" "" name "${PREFIX}.${suite}")
    string(APPEND tests "add_test([==[${name}]==] [==[${PROGRAM}]==] [==[--gtest_filter=${suite}*]==] --gtest_brief=1)\n"
      "set_tests_properties([==[${name}]==] PROPERTIES LABELS ${LABELS} WORKING_DIRECTORY [==[${DIRECTORY}]==]\n"
      # A suite whose every test is skipped has not passed; ctest asks this first, so no failure, "[  FAILED", may stand before.
      "  SKIP_REGULAR_EXPRESSION [==[^[^[]*(\\[[^ ][^[]*)*\\[  PASSED  \\] 0 tests\\.\n\\[  SKIPPED ]==])\n")
  endforeach()
  if(tests STREQUAL "")
    message(FATAL_ERROR "${PROGRAM} --gtest_list_tests names no test.")
  endif()
  file(WRITE ${OUTPUT} "${tests}")
  return()
endif()

set(riffle_suites_script ${CMAKE_CURRENT_LIST_FILE})

function(riffle_discover_suites program)
  cmake_parse_arguments(suites "" "LABELS" "" ${ARGN})
  set(tests ${CMAKE_CURRENT_BINARY_DIR}/${program}_suites.cmake)
  string(REGEX REPLACE "^test_" "" prefix ${program})
  add_custom_command(TARGET ${program} POST_BUILD BYPRODUCTS ${tests} VERBATIM
    COMMAND ${CMAKE_COMMAND} -D PROGRAM=$<TARGET_FILE:${program}> -D LABELS=${suites_LABELS} -D PREFIX=${prefix} -D OUTPUT=${tests}
      -D DIRECTORY=${CMAKE_CURRENT_BINARY_DIR} -P ${riffle_suites_script})
  # A program that is not built yet fails as one test of its name.
  set(include ${CMAKE_CURRENT_BINARY_DIR}/${program}_include.cmake)
  file(WRITE ${include} "if(EXISTS \"${tests}\")\n  include(\"${tests}\")\nelse()\n  add_test(${program}_is_not_built ${program}_is_not_built)\nendif()\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${include})
endfunction()
