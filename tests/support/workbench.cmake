# Tests that build and run students' files: they know where this build lies, and depend on all that a grading needs.
if(NOT TARGET umbral-workbench)
  list(JOIN UMBRAL_STUDENT_FLAGS " " flags)
  add_library(umbral-workbench STATIC ${CMAKE_CURRENT_LIST_DIR}/workbench.cpp)
  target_include_directories(umbral-workbench PUBLIC ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(umbral-workbench PUBLIC UMBRAL_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
    UMBRAL_BUILD_DIR="${PROJECT_BINARY_DIR}"
    UMBRAL_COMPILER="${CMAKE_CXX_COMPILER}" "UMBRAL_TEST_STUDENT_FLAGS=\"${flags}\"")
  target_link_libraries(umbral-workbench PUBLIC umbral-class umbral-validate umbral-manifest PRIVATE umbral-warnings)
  add_dependencies(umbral-workbench unit-kit unit-raytracing-sphere unit-projections-view-matrix)
endif()
