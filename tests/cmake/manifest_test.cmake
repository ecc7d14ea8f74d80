# cmake -DROOT=… -P: cmake/UmbralManifest.cmake on manifests written in several ways.
cmake_minimum_required(VERSION 3.25)
include(${ROOT}/cmake/UmbralManifest.cmake)

function(expect what got expected)
  if(NOT "${got}" STREQUAL "${expected}")
    message(SEND_ERROR "${what}: expected '${expected}', got '${got}'")
  endif()
endfunction()

set(spread [[{"files": ["a.cpp"], "uses": ["x/y", "x/z"], "glfw" : true, "gl": false,
  "checks": [{"judge": "numbers"}, {"judge"
     :   "cost", "case": "a [b]; c"}]}]])
set(misleading [[{"files": ["a.vert", "b.frag"], "title": {"en": "\"judge\": \"cost\""},
  "checks": [{"why": "judge", "judge": "image"}, {}]}]])

umbral_manifest_has_judge("${spread}" cost found)
expect("the judge on a line of its own" "${found}" TRUE)
umbral_manifest_has_judge("${misleading}" cost found)
expect("a title that quotes it" "${found}" FALSE)
umbral_manifest_has_judge("{}" cost found)
expect("no checks" "${found}" FALSE)

umbral_manifest_list("${spread}" uses uses)
expect("uses" "${uses}" "x/y;x/z")
umbral_manifest_list("${misleading}" uses uses)
expect("no uses" "${uses}" "")
foreach(flag glfw gl gl_calls)
  umbral_manifest_flag("${spread}" ${flag} ${flag})
endforeach()
expect("flags" "${glfw} ${gl} ${gl_calls}" "TRUE FALSE FALSE")

umbral_expected_references(some-topic/my-unit "${spread}" /a-folder/r files)
expect("a reference in C++" "${files}" "/a-folder/r/some_topic/my_unit.cpp")
umbral_expected_references(topic/my-unit "${misleading}" /r files)
expect("a reference in GLSL" "${files}" "/r/topic/my_unit/a.vert;/r/topic/my_unit/b.frag")
