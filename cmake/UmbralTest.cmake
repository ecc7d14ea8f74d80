include(GoogleTest)

# Reading GoogleTest, the standard library and JSON takes most of the time of compiling a test: they are read once.
function(umbral_test_headers)
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/tests/headers.cpp CONTENT
    "// Holds the precompiled headers of the tests.\n")
  add_executable(umbral-test-headers ${CMAKE_BINARY_DIR}/tests/headers.cpp)
  target_link_libraries(umbral-test-headers PRIVATE umbral-warnings nlohmann_json::nlohmann_json GTest::gtest
    GTest::gtest_main)
  umbral_compile_quickly(umbral-test-headers)
  target_precompile_headers(umbral-test-headers PRIVATE <algorithm> <cmath> <filesystem> <fstream> <functional>
    <glm/glm.hpp> <gtest/gtest.h> <map>
    <nlohmann/json.hpp> <optional> <random> <set> <span> <sstream> <string> <vector>)
endfunction()

# umbral_ctest(NAME COMMAND word... PROPERTIES name value...)
# One of ctest's tests, as add_test has them, where the folder's tests are run: UMBRAL_RUN_TESTS.
function(umbral_ctest name)
  cmake_parse_arguments(arg "" "" "COMMAND;PROPERTIES" ${ARGN})
  if(UMBRAL_RUN_TESTS)
    add_test(NAME ${name} COMMAND ${arg_COMMAND})
    set_tests_properties(${name} PROPERTIES ${arg_PROPERTIES})
  endif()
endfunction()

# umbral_ctests(PROGRAM ...): its cases as one test each, likewise; what follows is as for gtest_discover_tests.
function(umbral_ctests program)
  if(UMBRAL_RUN_TESTS)
    gtest_discover_tests(${program} DISCOVERY_TIMEOUT 60 ${ARGN})
  endif()
endfunction()

# umbral_test(NAME [ONE_PROCESS] SOURCES file... LIBRARIES target... [LABELS label...] [TIMEOUT seconds])
# One test executable; every case becomes a ctest test, or all of them one: where what they share takes long to make.
function(umbral_test name)
  cmake_parse_arguments(arg "ONE_PROCESS" "TIMEOUT" "SOURCES;LIBRARIES;LABELS" ${ARGN})
  if(NOT arg_TIMEOUT AND arg_ONE_PROCESS)
    set(arg_TIMEOUT 600)
  elseif(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 300)
  endif()
  add_executable(${name} ${arg_SOURCES})
  # support/, and model/scratch.hpp
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests ${PROJECT_SOURCE_DIR}/grader)
  target_link_libraries(${name} PRIVATE umbral-warnings ${arg_LIBRARIES} GTest::gtest GTest::gtest_main)
  umbral_compile_quickly(${name})
  # Solutions that a unit's tests take in have names of their own.
  list(LENGTH arg_SOURCES sources)
  if(sources GREATER 1 AND NOT "${arg_SOURCES}" MATCHES "(^|;)(/|[.][.]/)")
    umbral_compile_together(${name})
  endif()
  target_precompile_headers(${name} REUSE_FROM umbral-test-headers)
  if(arg_ONE_PROCESS)
    umbral_ctest(${name} COMMAND ${name} PROPERTIES LABELS "${arg_LABELS}" TIMEOUT ${arg_TIMEOUT} COST 60)
  else()
    umbral_ctests(${name} PROPERTIES LABELS "${arg_LABELS}" TIMEOUT ${arg_TIMEOUT})
  endif()
endfunction()
