# cmake -DROOT=… -DCOMPILER=… -DFOLDER=… -P: configurations that must stop, with the path that was expected; and one
# unit without a reference, which stops no other.
cmake_minimum_required(VERSION 3.25)

# expect_failure(SOURCE TEXT ARGUMENT…): configuring SOURCE fails, and says TEXT.
function(expect_failure source text)
  file(REMOVE_RECURSE ${FOLDER}/build)
  execute_process(COMMAND ${CMAKE_COMMAND} -G Ninja -S ${source} -B ${FOLDER}/build -DCMAKE_CXX_COMPILER=${COMPILER}
    -DBUILD_TESTING=OFF ${ARGN}
    RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
  string(REGEX REPLACE "[ \n]+" " " said "${said}")
  string(FIND "${said}" "${text}" at)
  if(status EQUAL 0 OR at LESS 0)
    message(SEND_ERROR "expected a failure that says '${text}', got status ${status} and: ${said}")
  endif()
endfunction()

file(REMOVE_RECURSE ${FOLDER})
expect_failure(${ROOT} "UMBRAL_UNITS: expected units ${ROOT}/exercises/nothing/*/exercise.json, found none"
  "-DUMBRAL_UNITS=raytracing/*\;nothing/*")

# copy_of_sources(COPY): the sources with one unit, of which nobody wrote the reference yet.
function(copy_of_sources copy)
  file(MAKE_DIRECTORY ${copy}/exercises/raytracing)
  foreach(part CMakeLists.txt cmake framework grader reference LICENSE docs)
    file(CREATE_LINK ${ROOT}/${part} ${copy}/${part} SYMBOLIC)
  endforeach()
  file(GLOB own ${ROOT}/exercises/*.txt ${ROOT}/exercises/*.cmake)
  file(COPY ${own} DESTINATION ${copy}/exercises)
  file(COPY ${ROOT}/exercises/raytracing/sphere/ DESTINATION ${copy}/exercises/raytracing/half-way)
endfunction()

copy_of_sources(${FOLDER}/broken)
file(WRITE ${FOLDER}/broken/exercises/raytracing/half-way/exercise.json "{\"format\": ")
expect_failure(${FOLDER}/broken "${FOLDER}/broken/exercises/raytracing/half-way/exercise.json: error: expected JSON")

copy_of_sources(${FOLDER}/begun)
execute_process(COMMAND ${CMAKE_COMMAND} -G Ninja -S ${FOLDER}/begun -B ${FOLDER}/begun-build
  -DCMAKE_CXX_COMPILER=${COMPILER} -DBUILD_TESTING=OFF
  RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(NOT status EQUAL 0)
  message(SEND_ERROR "a unit without a reference must not stop the others: ${said}")
endif()
if(said MATCHES "[Ww]arning")
  message(SEND_ERROR "expected a configuration without a warning, got: ${said}")
endif()
# What the first call waits for: nothing that only authors call, and no debugger's program. They are built when they are
# asked for. (A dry run of ninja stops where CMake would look for new files.)
foreach(target program umbral-authors)
  execute_process(COMMAND ${CMAKE_COMMAND} --build ${FOLDER}/begun-build --target ${target} -- -t commands
    RESULT_VARIABLE status OUTPUT_VARIABLE built_for_${target} ERROR_VARIABLE said)
  if(NOT status EQUAL 0)
    message(SEND_ERROR "expected the commands that build ${target}, got status ${status} and: ${said}")
  endif()
endforeach()
foreach(part mutants bench attack validate author-commands)
  if(built_for_program MATCHES "/umbral-${part}[.]dir/" OR
      NOT built_for_umbral-authors MATCHES "/umbral-${part}[.]dir/")
    message(SEND_ERROR "expected umbral-${part} to be built for umbral-authors, and not for the target program")
  endif()
endforeach()
if(built_for_program MATCHES "/umbral-debug" OR NOT built_for_program MATCHES "/umbral-commands[.]dir/")
  message(SEND_ERROR "expected umbral-commands to be built for the target program, and no umbral-debug")
endif()
# Warnings of a compiler that nobody tested stop nobody; the presets ask for more.
file(READ ${FOLDER}/begun-build/build.ninja rules)
if(rules MATCHES " -Werror" OR NOT rules MATCHES " -Wconversion")
  message(SEND_ERROR "expected warnings that are no errors where no preset asks for it")
endif()
file(READ ${ROOT}/CMakePresets.json presets)
string(JSON asked GET "${presets}" configurePresets 0 cacheVariables UMBRAL_WARNINGS_AS_ERRORS)
if(NOT asked STREQUAL "ON")
  message(SEND_ERROR
    "expected UMBRAL_WARNINGS_AS_ERRORS ON in the first preset, which all others inherit, got ${asked}")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} --build ${FOLDER}/begun-build --target unit-raytracing-half-way RESULT_VARIABLE
  status OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(status EQUAL 0 OR NOT said MATCHES
  "raytracing/half-way has no reference: expected [^ ]*/reference/raytracing/half_way.cpp")
  message(SEND_ERROR "expected a failed target that names the reference's path, got status ${status} and: ${said}")
endif()
