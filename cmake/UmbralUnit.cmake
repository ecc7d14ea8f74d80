# Builds what the grader loads for one unit, into ${CMAKE_BINARY_DIR}/units/<topic>/<unit>/:
# driver.so       the driver and the reference objects of the units in `uses` (their closure); the unit itself stays
# undefined
#   reference.so, oracle.so    the solutions whose answers students' are compared with
#   mistakes/*.so   known wrong solutions, loaded only to explain a failing result
#   exports.map, exports.txt   the names that a student's library may define: those of the reference object, no other
#
#   answers        an empty file, made when all but the mistakes are there
#   built          an empty file, made last: the unit can be used
#
# The target unit-<topic>-<unit> makes all of it, answers-<topic>-<unit> all but the mistakes, which are most of it.
#
# Units lie below UMBRAL_EXERCISES_ROOT, their solutions below UMBRAL_REFERENCE_ROOT; tests that bring units of their
# own set both.
#
# A unit's solutions are built alike and loaded alike, so that nothing can depend on who lives there.
#
# A unit that is half written stops no other: without its reference its own target fails, with the path that was
# expected.

include(UmbralManifest)

set(UMBRAL_UNITS_DIR ${CMAKE_BINARY_DIR}/units)
set(UMBRAL_EXERCISES_ROOT ${PROJECT_SOURCE_DIR}/exercises)
set(UMBRAL_REFERENCE_ROOT ${PROJECT_SOURCE_DIR}/reference)

# The units whose mistakes and tests `all` leaves out.
list(TRANSFORM UMBRAL_WHOLE_UNITS APPEND "/exercise.json" OUTPUT_VARIABLE whole_units)
list(TRANSFORM whole_units PREPEND ${UMBRAL_EXERCISES_ROOT}/)
if(whole_units)
  file(GLOB whole_units CONFIGURE_DEPENDS RELATIVE ${UMBRAL_EXERCISES_ROOT} ${whole_units})
endif()
file(GLOB UMBRAL_PARTIAL_UNITS CONFIGURE_DEPENDS RELATIVE ${UMBRAL_EXERCISES_ROOT}
  ${UMBRAL_EXERCISES_ROOT}/*/*/exercise.json)
list(REMOVE_ITEM UMBRAL_PARTIAL_UNITS "" ${whole_units})
list(TRANSFORM UMBRAL_PARTIAL_UNITS REPLACE "/exercise.json$" "")

# The flags of students' files, in one place: the precompiled header works only with exactly these. -g1 names functions
# and lines; what a debugger wants beyond (-g2, in grader/cli/debug) takes a third of the time of compiling.
# Where TBB is installed, <execution> would ask for its headers, which students' files are not shown, and for threads.
set(UMBRAL_STUDENT_FLAGS -std=c++20 -g1 -O1 -fPIC -fno-gnu-unique -ffp-contract=off -D_GLIBCXX_ASSERTIONS
  -D_GLIBCXX_USE_TBB_PAR_BACKEND=0)
# What must not be right by chance, where the compiler has it:
# - A variable that was never given a value holds -1.7e38, or the number of no element; grader/build/with_zeros builds
#   failing work with zeros instead, and different answers tell of such a variable. g++ leaves out what a function
#   returns by its name, what has a constructor, and parts that it keeps in registers, but for the next three flags.
#   Without the last it takes a variable that is set in one branch for set in all.
# - An index outside of an array, and a function that ends without its result, end the program.
include(CheckCXXCompilerFlag)
foreach(flags "-ftrivial-auto-var-init=pattern -fno-elide-constructors -fno-lifetime-dse -fno-tree-sra -fno-tree-fre"
    "-fsanitize=bounds,return -fsanitize-undefined-trap-on-error")
  string(MAKE_C_IDENTIFIER "UMBRAL_HAS${flags}" has)
  check_cxx_compiler_flag("${flags}" ${has})
  if(${has})
    separate_arguments(flags)
    list(APPEND UMBRAL_STUDENT_FLAGS ${flags})
  endif()
endforeach()

# One header before their first line, precompiled with exactly those flags by exercises/CMakeLists.txt. The headers that
# the unit's stubs include follow it.
set(UMBRAL_STUDENT_HEADER ${CMAKE_BINARY_DIR}/student/umbral_student.hpp)

# Added to the solutions of units with a check of the judge "cost": each basic block counts itself.
set(UMBRAL_COUNTED_FLAGS -fsanitize-coverage=trace-pc)

# … and how they are linked: what they move, fill, compare and search by these functions counts too, and how much memory
# they hold. The same list as in grader/build/counted.hpp.
set(UMBRAL_COUNTED_CALLS memmove memcpy memset memcmp memchr _Znwm _Znam _ZnwmRKSt9nothrow_t _ZdlPv _ZdlPvm _ZdaPv
  _ZdaPvm)
list(TRANSFORM UMBRAL_COUNTED_CALLS PREPEND -Wl,--wrap= OUTPUT_VARIABLE UMBRAL_COUNTED_LINK)

# umbral_reference_objects(UNIT RESULT [FLAGS…]): the object library of a unit's reference, made on first need.
function(umbral_reference_objects unit result)
  string(REPLACE "/" "-" target "reference-${unit}")
  string(REPLACE "-" "_" file "${unit}")
  if(ARGN)
    string(APPEND target "-counted")
  endif()
  if(NOT TARGET ${target})
    add_library(${target} OBJECT ${UMBRAL_REFERENCE_ROOT}/${file}.cpp)
    target_compile_options(${target} PRIVATE ${ARGN})
    target_link_libraries(${target} PRIVATE umbral-framework umbral-warnings)
  endif()
  set(${result} ${target} PARENT_SCOPE)
endfunction()

# umbral_uses_closure(UNIT PATH RESULT): all units that UNIT uses, directly or not. A cycle stops the configuration,
# naming its path.
function(umbral_uses_closure unit path result)
  if(unit IN_LIST path)
    list(JOIN path " -> " shown)
    message(FATAL_ERROR "Units use each other in a circle: ${shown} -> ${unit}. Take one out of `uses`.")
  endif()
  list(APPEND path ${unit})
  set(all)
  umbral_read_manifest(${UMBRAL_EXERCISES_ROOT}/${unit}/exercise.json json)
  umbral_manifest_list("${json}" uses uses)
  foreach(used IN LISTS uses)
    umbral_uses_closure(${used} "${path}" below)
    list(APPEND all ${used} ${below})
  endforeach()
  list(REMOVE_DUPLICATES all)
  set(${result} ${all} PARENT_SCOPE)
endfunction()

# Reading what a driver asks and records with takes a third of the time of compiling it: it is read once for all.
function(umbral_driver_headers)
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/driver-headers.cpp CONTENT
    "// Holds the precompiled headers of the drivers.\n")
  add_library(umbral-driver-headers STATIC ${CMAKE_BINARY_DIR}/driver-headers.cpp)
  target_link_libraries(umbral-driver-headers PRIVATE umbral-framework umbral-warnings)
  umbral_compile_driver(umbral-driver-headers)
  target_precompile_headers(umbral-driver-headers PRIVATE <algorithm> <array> <cmath> <glm/glm.hpp>
    <glm/gtc/matrix_transform.hpp> <numbers> <optional> <span> <string> <umbral/record/ask.hpp>
    <umbral/record/driver.hpp> <vector>)
endfunction()

function(umbral_unit_library target folder name)
  add_library(${target} MODULE ${ARGN})
  set_target_properties(${target} PROPERTIES PREFIX "" OUTPUT_NAME ${name} LIBRARY_OUTPUT_DIRECTORY ${folder})
  target_link_libraries(${target} PRIVATE umbral-framework)
endfunction()

# umbral_export_of_driver(ID FOLDER OBJECTS): a driver exports its cases, and what students may call of used units,
# whose OBJECTS it is linked from. Nothing else that it is made of, such as GLM's functions, can be found in it by name.
function(umbral_export_of_driver id folder objects)
  set(map ${PROJECT_SOURCE_DIR}/cmake/driver.map)
  if(objects)
    set(map ${folder}/driver.map)
    add_custom_command(OUTPUT ${map}
      COMMAND ${CMAKE_COMMAND} -DNM=${CMAKE_NM} "-DOBJECTS=${objects}" -DFOLDER=${folder} -DNAME=driver
        -DALSO=_ZN6umbral6driverE -P ${PROJECT_SOURCE_DIR}/cmake/exports.cmake
      DEPENDS ${objects} ${PROJECT_SOURCE_DIR}/cmake/exports.cmake VERBATIM)
    add_custom_target(driver-exports-${id} DEPENDS ${map})
    add_dependencies(driver-${id} driver-exports-${id})
  endif()
  target_link_options(driver-${id} PRIVATE -Wl,--version-script=${map})
  set_property(TARGET driver-${id} APPEND PROPERTY LINK_DEPENDS ${map})
endfunction()

# umbral_finish_unit(UNIT ANSWERS MISTAKES): the targets of a unit, and the files that say that all parts are there.
# With them comes what a unit is graded with.
function(umbral_finish_unit unit answers mistakes)
  string(REPLACE "/" "-" id ${unit})
  set(folder ${UMBRAL_UNITS_DIR}/${unit})
  add_custom_command(OUTPUT ${folder}/answers COMMAND ${CMAKE_COMMAND} -E touch ${folder}/answers DEPENDS ${answers}
    VERBATIM)
  add_custom_target(answers-${id} ALL DEPENDS ${folder}/answers)
  add_dependencies(answers-${id} unit-kit)
  add_custom_command(OUTPUT ${folder}/built COMMAND ${CMAKE_COMMAND} -E touch ${folder}/built
    DEPENDS ${folder}/answers ${mistakes} VERBATIM)
  if(unit IN_LIST UMBRAL_PARTIAL_UNITS)
    set_target_properties(${mistakes} PROPERTIES EXCLUDE_FROM_ALL ON)
    add_custom_target(unit-${id} DEPENDS ${folder}/built)
  else()
    add_custom_target(unit-${id} ALL DEPENDS ${folder}/built)
  endif()
  add_dependencies(unit-${id} answers-${id})
endfunction()

# umbral_add_unit(TOPIC/UNIT)
function(umbral_add_unit unit)
  set(source ${UMBRAL_EXERCISES_ROOT}/${unit})
  set(folder ${UMBRAL_UNITS_DIR}/${unit})
  string(REPLACE "/" "-" id ${unit})
  string(REPLACE "-" "_" file ${unit})
  set(reference ${UMBRAL_REFERENCE_ROOT}/${file})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source}/exercise.json)
  umbral_read_manifest(${source}/exercise.json json)

  umbral_uses_closure(${unit} "" used)
  umbral_unit_library(driver-${id} ${folder} driver ${source}/driver.cpp)
  target_include_directories(driver-${id} PRIVATE ${PROJECT_SOURCE_DIR}/exercises)
  target_link_libraries(driver-${id} PRIVATE umbral-warnings)
  target_link_options(driver-${id} PRIVATE -Wl,-Bsymbolic -s)
  target_precompile_headers(driver-${id} REUSE_FROM umbral-driver-headers)
  # g++ 12 finds texts that are put together too long for their place where <string> is precompiled (GCC bug 105651).
  target_compile_options(driver-${id} PRIVATE -Wno-array-bounds -Wno-stringop-overflow)
  umbral_compile_driver(driver-${id})
  set(objects_used)
  foreach(other IN LISTS used)
    umbral_reference_objects(${other} objects)
    target_link_libraries(driver-${id} PRIVATE ${objects})
    list(APPEND objects_used $<TARGET_OBJECTS:${objects}>)
  endforeach()
  umbral_export_of_driver(${id} ${folder} "${objects_used}")
  set(parts driver-${id})
  foreach(library gl glfw)
    umbral_manifest_flag("${json}" ${library} needed)
    if(needed)
      target_link_libraries(driver-${id} PRIVATE umbral-${library})
    endif()
  endforeach()

  umbral_expected_references(${unit} "${json}" ${UMBRAL_REFERENCE_ROOT} expected)
  set(missing ${expected})
  file(GLOB there CONFIGURE_DEPENDS ${expected} ${reference}_oracle.cpp)
  list(REMOVE_ITEM missing ${there} "")
  if(missing)
    list(JOIN missing ", " missing)
    add_custom_target(unit-${id} ALL COMMAND ${CMAKE_COMMAND} -E echo
      "error: the unit ${unit} has no reference: expected ${missing}"
      COMMAND ${CMAKE_COMMAND} -E false VERBATIM)
    return()
  endif()
  if(NOT ${reference}.cpp IN_LIST expected)
    umbral_finish_unit(${unit} "${parts}" "")
    return()
  endif()
  set(counted)
  set(counted_link)
  umbral_manifest_has_judge("${json}" cost has_cost)
  if(has_cost)
    set(counted ${UMBRAL_COUNTED_FLAGS})
    set(counted_link ${UMBRAL_COUNTED_LINK})
  endif()
  umbral_reference_objects(${unit} objects ${counted})
  umbral_unit_library(reference-library-${id} ${folder} reference $<TARGET_OBJECTS:${objects}>)
  set_target_properties(reference-library-${id} PROPERTIES LINKER_LANGUAGE CXX)
  target_link_options(reference-library-${id} PRIVATE ${counted_link})
  add_custom_command(OUTPUT ${folder}/exports.map ${folder}/exports.txt
    COMMAND ${CMAKE_COMMAND} -DNM=${CMAKE_NM} "-DOBJECTS=$<TARGET_OBJECTS:${objects}>" -DFOLDER=${folder} -P
      ${PROJECT_SOURCE_DIR}/cmake/exports.cmake
    DEPENDS $<TARGET_OBJECTS:${objects}> ${PROJECT_SOURCE_DIR}/cmake/exports.cmake COMMAND_EXPAND_LISTS VERBATIM)
  add_custom_target(exports-${id} ALL DEPENDS ${folder}/exports.map)
  list(APPEND parts reference-library-${id} ${folder}/exports.map)

  if(${reference}_oracle.cpp IN_LIST there)
    umbral_unit_library(oracle-library-${id} ${folder} oracle ${reference}_oracle.cpp)
    target_link_libraries(oracle-library-${id} PRIVATE umbral-warnings)
    target_include_directories(oracle-library-${id} PRIVATE ${PROJECT_SOURCE_DIR}/reference)
    list(APPEND parts oracle-library-${id})
  endif()

  umbral_interfaces(${source} "${json}" interfaces)
  umbral_manifest_list("${json}" uses may_call)
  foreach(other IN LISTS may_call)
    umbral_read_manifest(${UMBRAL_EXERCISES_ROOT}/${other}/exercise.json other_json)
    umbral_interfaces(${UMBRAL_EXERCISES_ROOT}/${other} "${other_json}" other_interfaces)
    list(APPEND interfaces ${other_interfaces})
  endforeach()
  list(REMOVE_DUPLICATES interfaces)
  list(TRANSFORM interfaces PREPEND "SHELL:-include ")
  file(GLOB mistakes CONFIGURE_DEPENDS ${source}/mistakes/*.cpp ${source}/mistakes/*.change)
  file(GLOB alternatives CONFIGURE_DEPENDS ${source}/alternatives/*.cpp)
  set(compiled)
  foreach(mistake IN LISTS mistakes)
    get_filename_component(name ${mistake} NAME_WE)
    if(mistake MATCHES "[.]change$")
      set(derived ${folder}/derived/${name}.cpp)
      file(MAKE_DIRECTORY ${folder}/derived)
      add_custom_command(OUTPUT ${derived} COMMAND umbral-derive ${mistake} ${reference}.cpp ${derived}
        DEPENDS umbral-derive ${mistake} ${reference}.cpp ${alternatives} VERBATIM)
      set(mistake ${derived})
    endif()
    umbral_unit_library(mistake-${id}-${name} ${folder}/mistakes ${name} ${mistake})
    list(APPEND compiled mistake-${id}-${name})
    set_target_properties(mistake-${id}-${name} PROPERTIES CXX_CLANG_TIDY "")  # wrong on purpose
    # As a student's file, with the precompiled header, which is also why NDEBUG must go: it takes a fifth of the time.
    target_compile_options(mistake-${id}-${name} PRIVATE ${UMBRAL_STUDENT_FLAGS} -UNDEBUG ${counted}
      "SHELL:-include ${UMBRAL_STUDENT_HEADER}" ${interfaces})
    set_source_files_properties(${mistake} PROPERTIES OBJECT_DEPENDS ${UMBRAL_STUDENT_HEADER}.gch)
    # Linked like a student's file too, so that `umbral validate` can grade what explanations are made from.
    target_link_options(mistake-${id}-${name} PRIVATE -Wl,-z,lazy -Wl,--version-script=${folder}/exports.map
      ${counted_link})
    set_target_properties(mistake-${id}-${name} PROPERTIES LINK_DEPENDS ${folder}/exports.map)
    add_dependencies(mistake-${id}-${name} exports-${id})
  endforeach()
  umbral_finish_unit(${unit} "${parts}" "${compiled}")
  # What students may call of the units in `uses` is read from their exports.
  foreach(other IN LISTS used)
    string(REPLACE "/" "-" other ${other})
    add_dependencies(answers-${id} exports-${other})
  endforeach()
endfunction()
