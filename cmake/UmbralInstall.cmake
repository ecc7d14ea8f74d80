# `cmake --install` and `cpack`: two components, which are two Debian packages.
#
#   umbral              what students get: programs, units compiled, statements, stubs, interface headers. No source of
#                       an answer
#   umbral-instructor   beside it: the sources of reference, drivers, mistakes and alternatives, the sample class,
#                       attacks for `umbral doctor --attack`, the commands of authors, and the programs that hold the
#                       reference's engine
#
# Below the prefix lie bin/umbral (a link), lib/umbral (bin, lib, units, as in a build) and share/umbral (exercises,
# framework, …, as in a checkout); grader/cli/layout.hpp finds them from the program's own place. All names below the
# prefix are fixed: below Debian's lib/x86_64-linux-gnu, which the compiler must read, students' files could be compiled
# against the answers.
#
# The target `installable` builds all of it; nothing else need be built.

set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY TRUE)
set(private lib/umbral)
set(data share/umbral)
get_property(units GLOBAL PROPERTY UMBRAL_BUILT_UNITS)
set(students COMPONENT umbral)
set(instructors COMPONENT umbral-instructor)

# Before anything is copied: is all of it there?
list(TRANSFORM units PREPEND ${UMBRAL_UNITS_DIR}/ OUTPUT_VARIABLE needed)
list(TRANSFORM needed APPEND /built)
foreach(component umbral umbral-instructor)
  install(CODE "foreach(file IN ITEMS ${CMAKE_BINARY_DIR}/packaged/made ${needed})
    if(NOT EXISTS \${file})
      message(FATAL_ERROR \"\${file} is missing. Build what is installed first: \"
        \"cmake --build ${CMAKE_BINARY_DIR} --target installable\")
    endif()
  endforeach()" COMPONENT ${component})
endforeach()

# What grading reads of the answers' sources, written down while they are there.
set(packaged ${CMAKE_BINARY_DIR}/packaged)
set(exercises ${PROJECT_SOURCE_DIR}/exercises)
file(GLOB_RECURSE read CONFIGURE_DEPENDS ${exercises}/*.json ${exercises}/*.cpp ${exercises}/*.hpp
  ${exercises}/*.change ${exercises}/*.vert ${exercises}/*.frag)
file(GLOB_RECURSE shaders CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/reference/*.vert
  ${PROJECT_SOURCE_DIR}/reference/*.frag)
add_custom_command(OUTPUT ${packaged}/made
  COMMAND umbral-pack ${exercises} ${PROJECT_SOURCE_DIR}/reference ${packaged} ${units}
  COMMAND ${CMAKE_COMMAND} -E touch ${packaged}/made
  DEPENDS umbral-pack ${read} ${shaders} COMMENT "Writing down what packages hold of the units" VERBATIM)
add_custom_target(packaged DEPENDS ${packaged}/made)
add_custom_target(installable DEPENDS program packaged umbral-debug umbral-debug-gl umbral-authors umbral-render
  umbral-bench-accuracy umbral-bench-scenes)

foreach(program umbral umbral-spawner umbral-spawner-gl umbral-confine umbral-inspect umbral-unpack umbral-debug
    umbral-debug-gl)
  install(PROGRAMS $<TARGET_FILE:${program}> DESTINATION ${private}/bin ${students})
endforeach()
install(PROGRAMS $<TARGET_FILE:umbral-as> DESTINATION ${private}/bin/assembler ${students})
foreach(library umbral-framework umbral-gl umbral-glfw)
  install(FILES $<TARGET_FILE:${library}> DESTINATION ${private}/lib ${students})
endforeach()
install(FILES ${CMAKE_BINARY_DIR}/version.txt ${CMAKE_BINARY_DIR}/commit.txt DESTINATION ${private} ${students})
install(FILES ${UMBRAL_UNITS_DIR}/framework-exports.txt DESTINATION ${private}/units ${students})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/framework/
  DESTINATION ${data}/framework ${students} FILES_MATCHING PATTERN *.hpp
  PATTERN generate EXCLUDE PATTERN shared EXCLUDE)
install(FILES ${exercises}/topics.txt DESTINATION ${data}/exercises ${students})
install(FILES ${UMBRAL_STUDENT_HEADER} DESTINATION ${data}/student ${students})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION share/doc/umbral RENAME copyright ${students})
install(FILES ${PROJECT_SOURCE_DIR}/docs/students.md ${PROJECT_SOURCE_DIR}/docs/glossary.md
  DESTINATION share/doc/umbral ${students})

foreach(program umbral-authors umbral-render umbral-bench-accuracy umbral-bench-scenes)
  install(PROGRAMS $<TARGET_FILE:${program}> DESTINATION ${private}/bin ${instructors})
endforeach()
get_property(painters GLOBAL PROPERTY UMBRAL_BENCH_SCENES_BUILDS)
foreach(painter IN LISTS painters)
  install(FILES ${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/libumbral-bench-scenes-${painter}.so
    DESTINATION ${private}/lib ${instructors})
endforeach()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/reference DESTINATION ${data} ${instructors} PATTERN CMakeLists.txt EXCLUDE)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/tests/class DESTINATION ${data} ${instructors})
install(FILES ${PROJECT_SOURCE_DIR}/tests/demo-units.txt DESTINATION ${data} ${instructors})
file(GLOB attacks CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/attacks/*)
foreach(theme IN LISTS attacks)
  if(IS_DIRECTORY ${theme})
    install(DIRECTORY ${theme} DESTINATION ${data}/attacks ${instructors})
  endif()
endforeach()
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION share/doc/umbral-instructor RENAME copyright ${instructors})
install(FILES ${PROJECT_SOURCE_DIR}/docs/instructors.md DESTINATION share/doc/umbral-instructor ${instructors})
file(GLOB shared CONFIGURE_DEPENDS RELATIVE ${exercises} ${exercises}/*.hpp ${exercises}/*/*.hpp)
foreach(header IN LISTS shared)
  get_filename_component(folder ${header} DIRECTORY)
  install(FILES ${exercises}/${header} DESTINATION ${data}/exercises/${folder} ${instructors})
endforeach()

foreach(unit IN LISTS units)
  string(REPLACE "/" "-" id ${unit})
  add_dependencies(installable unit-${id})
  set(source ${exercises}/${unit})
  file(READ ${source}/exercise.json json)
  string(JSON count LENGTH "${json}" files)
  math(EXPR last "${count} - 1")
  set(files ${source}/exercise.json ${packaged}/${unit}/packaged.json)
  foreach(i RANGE ${last})
    string(JSON file GET "${json}" files ${i})
    list(APPEND files ${source}/${file})
  endforeach()
  file(GLOB statements ${source}/README*.md)
  install(FILES ${files} ${statements} DESTINATION ${data}/exercises/${unit} ${students})

  # As in the build, but for derived sources and libraries of mistakes that are no more. Of a unit in GLSL only the
  # driver is compiled.
  set(built ${UMBRAL_UNITS_DIR}/${unit})
  install(FILES ${built}/driver.so DESTINATION ${private}/units/${unit} ${students})
  string(REPLACE "-" "_" reference ${unit})
  set(reference ${PROJECT_SOURCE_DIR}/reference/${reference})
  if(EXISTS ${reference}.cpp)
    install(FILES ${built}/reference.so ${built}/exports.map ${built}/exports.txt
      DESTINATION ${private}/units/${unit} ${students})
    if(EXISTS ${reference}_oracle.cpp)
      install(FILES ${built}/oracle.so DESTINATION ${private}/units/${unit} ${students})
    endif()
    file(GLOB mistakes CONFIGURE_DEPENDS ${source}/mistakes/*.cpp ${source}/mistakes/*.change)
    foreach(mistake IN LISTS mistakes)
      get_filename_component(name ${mistake} NAME_WE)
      install(FILES ${built}/mistakes/${name}.so DESTINATION ${private}/units/${unit}/mistakes ${students})
    endforeach()
  else()
    install(FILES ${packaged}/${unit}/shaders DESTINATION ${private}/units/${unit} ${students})
  endif()

  file(GLOB headers CONFIGURE_DEPENDS ${source}/*.hpp)
  install(FILES ${source}/driver.cpp ${headers} DESTINATION ${data}/exercises/${unit} ${instructors})
  foreach(answers mistakes alternatives)
    if(IS_DIRECTORY ${source}/${answers})
      install(DIRECTORY ${source}/${answers} DESTINATION ${data}/exercises/${unit} ${instructors})
    endif()
  endforeach()
endforeach()

# Libraries of answers were compiled with debug information, which names places in their sources, and some hold shaders
# as texts.
install(CODE "set(UMBRAL_STRIP \"${CMAKE_STRIP}\")\nset(UMBRAL_VEIL $<TARGET_FILE:umbral-pack>)" ${students})
install(SCRIPT ${PROJECT_SOURCE_DIR}/cmake/finish_install.cmake ${students})

# `umbral bench accuracy` opens these by itself; behind the veiling of the others.
set(measured ${UMBRAL_UNITS_DIR}/raytracing/sphere)
if(raytracing/sphere IN_LIST units)
  install(FILES ${measured}/reference.so ${measured}/oracle.so
    DESTINATION ${private}/units/raytracing/sphere ${instructors})
endif()
install(CODE "set(UMBRAL_STRIP \"${CMAKE_STRIP}\")\nset(UMBRAL_VEIL)" ${instructors})
install(SCRIPT ${PROJECT_SOURCE_DIR}/cmake/finish_install.cmake ${instructors})

include(UmbralPackages)
