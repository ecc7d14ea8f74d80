include(GoogleTest)

# umbral_test(NAME SOURCES file... LIBRARIES target... [LABELS label...])
# One test executable; every case becomes a ctest test.
function(umbral_test name)
  cmake_parse_arguments(arg "" "" "SOURCES;LIBRARIES;LABELS" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests ${PROJECT_SOURCE_DIR}/grader)  # support/, and model/scratch.hpp
  target_link_libraries(${name} PRIVATE umbral-warnings ${arg_LIBRARIES} GTest::gtest GTest::gtest_main)
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 PROPERTIES LABELS "${arg_LABELS}" TIMEOUT 300)
endfunction()
