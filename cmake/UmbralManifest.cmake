# What CMake reads of a unit's manifest, exercise.json. The grader reads all of it, and says what is wrong in it
# (grader/manifest).

# umbral_read_manifest(FILE RESULT): its text. What is no JSON stops the configuration, naming the file.
function(umbral_read_manifest file result)
  file(READ ${file} json)
  string(JSON count ERROR_VARIABLE problem LENGTH "${json}")
  if(problem)
    message(FATAL_ERROR "${file}: error: expected JSON, got: ${problem}")
  endif()
  set(${result} "${json}" PARENT_SCOPE)
endfunction()

# umbral_manifest_list(JSON KEY RESULT): a list of texts; empty if it is not given.
function(umbral_manifest_list json key result)
  set(all)
  string(JSON count ERROR_VARIABLE none LENGTH "${json}" ${key})
  if(NOT none AND count GREATER 0)
    math(EXPR last "${count} - 1")
    foreach(i RANGE ${last})
      string(JSON one GET "${json}" ${key} ${i})
      list(APPEND all ${one})
    endforeach()
  endif()
  set(${result} ${all} PARENT_SCOPE)
endfunction()

# umbral_manifest_flag(JSON KEY RESULT): TRUE or FALSE, which it also is if it is not given.
function(umbral_manifest_flag json key result)
  string(JSON value ERROR_VARIABLE none GET "${json}" ${key})
  set(${result} FALSE PARENT_SCOPE)
  if(value STREQUAL "ON")
    set(${result} TRUE PARENT_SCOPE)
  endif()
endfunction()

# umbral_manifest_has_judge(JSON JUDGE RESULT): has a check this judge?
function(umbral_manifest_has_judge json judge result)
  set(found FALSE)
  string(JSON count ERROR_VARIABLE none LENGTH "${json}" checks)
  if(NOT none AND count GREATER 0)
    math(EXPR last "${count} - 1")
    string(JSON checks GET "${json}" checks)
    foreach(i RANGE ${last})
      string(JSON one ERROR_VARIABLE none GET "${checks}" ${i} judge)
      if(one STREQUAL judge)
        set(found TRUE)
      endif()
    endforeach()
  endif()
  set(${result} ${found} PARENT_SCOPE)
endfunction()

# umbral_expected_references(UNIT JSON ROOT RESULT): the files below ROOT in which the unit's reference is expected:
# ROOT/topic/my_unit.cpp, or of a unit in GLSL its shaders' names in the folder ROOT/topic/my_unit.
function(umbral_expected_references unit json root result)
  string(REPLACE "-" "_" place "${unit}")
  set(place ${root}/${place})
  umbral_manifest_list("${json}" files files)
  set(shaders ${files})
  list(FILTER shaders EXCLUDE REGEX "[.][ch]pp$")
  if(files STREQUAL shaders)
    list(TRANSFORM shaders PREPEND ${place}/)
    set(${result} ${shaders} PARENT_SCOPE)
  else()
    set(${result} ${place}.cpp PARENT_SCOPE)
  endif()
endfunction()
