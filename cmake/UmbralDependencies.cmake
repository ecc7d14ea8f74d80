# Every library from outside; their headers are SYSTEM, so that our warnings are ours. docs/dependencies.md says why
# each.

find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(glm REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(PNG REQUIRED)
find_package(tinyobjloader REQUIRED)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
# Debian keeps OpenCV's CMake and pkg-config files in libopencv-dev, which pulls 700 MB; the three modules are found by
# hand.
# Only tests read pictures with it: imgcodecs pulls in a hundred libraries.
set(opencv_modules core imgproc)
if(BUILD_TESTING)
  list(APPEND opencv_modules imgcodecs)
endif()
find_package(OpenCV QUIET COMPONENTS ${opencv_modules})
if(NOT OpenCV_FOUND)
  find_path(OPENCV_INCLUDE opencv2/core.hpp PATH_SUFFIXES opencv4 REQUIRED)
  foreach(module IN LISTS opencv_modules)
    find_library(OPENCV_${module} opencv_${module} REQUIRED)
    add_library(opencv_${module} UNKNOWN IMPORTED)
    set_target_properties(opencv_${module} PROPERTIES IMPORTED_LOCATION ${OPENCV_${module}}
      INTERFACE_INCLUDE_DIRECTORIES ${OPENCV_INCLUDE})
  endforeach()
endif()
pkg_check_modules(SECCOMP REQUIRED IMPORTED_TARGET libseccomp)
# A demangler that can be stopped: the C++ library's own writes as much as a name asks for.
find_library(LIBERTY iberty REQUIRED)
pkg_check_modules(DW REQUIRED IMPORTED_TARGET libdw libelf)
pkg_check_modules(ARCHIVE REQUIRED IMPORTED_TARGET libarchive)
if(BUILD_TESTING)
  find_package(GTest REQUIRED)
  # The engine's rays are compared with its; without it those tests are not built.
  find_package(embree 3 QUIET)
endif()
