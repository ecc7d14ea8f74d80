# All options of the build, and the flags that hold for every target. CONTRIBUTING.md has the same list; BUILD_TESTING
# is CTest's.

set(UMBRAL_UNITS "*/*" CACHE STRING
  "The units to build, as glob patterns: meshes/*;pipeline/clip-line. Of the tests only theirs are built then")
set(UMBRAL_WHOLE_UNITS "*/*" CACHE STRING
  "The units that `all` holds with their known mistakes and tests; mistakes of others are compiled on demand")
option(UMBRAL_WARNINGS_AS_ERRORS "Stop at a warning; on in the presets, whose compilers are tested" OFF)
set(UMBRAL_SANITIZERS "" CACHE STRING "Sanitizers for everything but students' files, as for -fsanitize=")
option(UMBRAL_SANITIZE_ENGINE
  "Also what reads nothing foreign: units, the engine, all that draws with OpenGL; `./umbral test --all` does" OFF)
set(UMBRAL_FP_CONTRACT off CACHE STRING
  "-ffp-contract: off everywhere; `fast` only in the preset that shows what survives it")
set(UMBRAL_TEST_PARTS "" CACHE STRING
  "Folders of tests/ whose tests are built; empty: all. `./umbral test` takes those whose turn it is")
option(UMBRAL_FUZZ "Build fuzz targets instead of their replays; needs clang" OFF)
set(UMBRAL_COMPILE_TOGETHER 0 CACHE STRING
  "How many files of a library are compiled as one: 24 takes less than half of the time; 0: each alone")
set(UMBRAL_PACKAGE_CONTACT "Umbral <umbral@localhost>" CACHE STRING
  "Who maintains the packages that cpack makes, as NAME <ADDRESS>")

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_VISIBILITY_PRESET default)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib)
# Programs find our libraries from where they lie themselves: bin, lib and units lie beside each other here as in an
# installation.
set(CMAKE_BUILD_RPATH_USE_ORIGIN ON)

# -O2 instead of -O3: what users wait for is the first build, and the hot loops here are in OSMesa and OpenCV.
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")

# umbral_compile_quickly(TARGET…): what waits for compilers, runs and disks, or only arranges text, gains nothing from
# -O2, and compiles in two thirds of the time at -Og. (-O0 takes as long as -Og.)
function(umbral_compile_quickly)
  foreach(target IN LISTS ARGV)
    umbral_compile_at(-Og ${target})
  endforeach()
endfunction()

# umbral_compile_driver(TARGET): what draws pictures in software. At -O1 it draws three to seven times as fast as at
# -Og, and compiles a quarter longer; at -O2 up to twice as fast again, in twice the time.
function(umbral_compile_driver target)
  umbral_compile_at(-O1 ${target})
endfunction()

function(umbral_compile_at level target)
  # Of std::optional, g++ at -Og and -O1 believes that what was never made is destroyed.
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:${level}>
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endfunction()

# umbral_compile_together(TARGET…): several files as one, which reads headers and makes templates once for all of them.
# Their anonymous namespaces become one: a second helper of the same name in a folder needs another name.
function(umbral_compile_together)
  if(UMBRAL_COMPILE_TOGETHER)
    set_target_properties(${ARGV} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${UMBRAL_COMPILE_TOGETHER})
    # g++ takes each file for a header then, where a test's fixture in an anonymous namespace would be a mistake.
    foreach(target IN LISTS ARGV)
      target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
    endforeach()
  endif()
endfunction()

find_program(CCACHE ccache)
find_program(ENV_PROGRAM env)
if(CCACHE AND ENV_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Without this sloppiness, ccache keeps nothing that is compiled with a precompiled header. What a file includes it
  # reads off the compiler's own list (DEPEND) instead of preprocessing it first, and what a precompiled header of
  # 90 MB holds it hashes once, not for each file (INODECACHE): together two thirds of what a miss costs.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${ENV_PROGRAM} CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_DEPEND=1
    CCACHE_INODECACHE=1 ${CCACHE})
endif()
find_program(MOLD mold)
if(MOLD)
  add_link_options(-fuse-ld=mold)
endif()

# A fused multiply-add rounds once where the source says twice: results would depend on the compiler's mood.
add_compile_options(-ffp-contract=${UMBRAL_FP_CONTRACT})
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # g++ collects its garbage less often: a tenth to a quarter of the time of large files, for a third more memory (1.1
  # GB instead of 0.8 at most).
  add_compile_options("SHELL:--param ggc-min-expand=400" "SHELL:--param ggc-min-heapsize=1000000")
endif()
if(UMBRAL_FP_CONTRACT STREQUAL "fast")
  add_compile_options(-mfma)
endif()
# Template statics marked unique would be shared between libraries that must not see each other.
# clang-tidy reads g++'s command line, and does not know this.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT CMAKE_CXX_CLANG_TIDY)
  add_compile_options(-fno-gnu-unique)
endif()
if(UMBRAL_SANITIZERS)
  add_compile_options(-fsanitize=${UMBRAL_SANITIZERS} -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
  add_link_options(-fsanitize=${UMBRAL_SANITIZERS})
endif()

# Where files are compiled together, a name in one may hide a constant of another: no reason to warn.
add_library(umbral-warnings INTERFACE)
target_compile_options(umbral-warnings INTERFACE -Wall -Wextra -Wconversion
  $<$<NOT:$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>>:-Wshadow>
  $<$<BOOL:${UMBRAL_WARNINGS_AS_ERRORS}>:-Werror>)
# g++ 12 warns of overlapping copies inside std::string at -O3 where there are none (GCC bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13 AND NOT CMAKE_CXX_CLANG_TIDY)
  target_compile_options(umbral-warnings INTERFACE -Wno-restrict)
endif()
# Sanitized, what std::regex moves looks uninitialized to g++; the other presets keep the warning.
if(UMBRAL_SANITIZERS)
  target_compile_options(umbral-warnings INTERFACE -Wno-maybe-uninitialized)
endif()
