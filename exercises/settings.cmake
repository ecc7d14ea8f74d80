# Solutions that are settings of their unit's knob (umbral bench accuracy) say so in a line "knob: …" of their head:
# reports show where they lie beside the student's. Known mistakes are libraries anyway; alternatives become some here.

# umbral_add_settings(TOPIC/UNIT): for a unit with a knob, settings/*.so and settings.txt, which names the libraries of
# all its settings, one a line: "mistakes/in_float".
function(umbral_add_settings unit)
  set(source ${UMBRAL_EXERCISES_ROOT}/${unit})
  set(folder ${UMBRAL_UNITS_DIR}/${unit})
  string(REPLACE "/" "-" id ${unit})
  umbral_read_manifest(${source}/exercise.json json)
  string(JSON knob ERROR_VARIABLE none GET "${json}" knob name)
  if(none OR NOT TARGET exports-${id})
    return()
  endif()
  file(GLOB solutions CONFIGURE_DEPENDS ${source}/mistakes/*.cpp ${source}/mistakes/*.change
    ${source}/alternatives/*.cpp)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${solutions})
  set(all)
  foreach(solution IN LISTS solutions)
    file(STRINGS ${solution} line LIMIT_COUNT 1 REGEX "^(// )?knob: ")
    get_filename_component(name ${solution} NAME_WE)
    if(line AND solution MATCHES "/mistakes/")
      string(APPEND all "mistakes/${name}\n")
    elseif(line)
      string(APPEND all "settings/${name}\n")
      umbral_add_setting(${unit} ${id} ${solution} ${name})
    endif()
  endforeach()
  file(CONFIGURE OUTPUT ${folder}/settings.txt CONTENT "${all}")
endfunction()

# An alternative as a library, compiled and linked as a student's file is.
function(umbral_add_setting unit id solution name)
  umbral_interfaces(${UMBRAL_EXERCISES_ROOT}/${unit} "${json}" interfaces)
  list(TRANSFORM interfaces PREPEND "SHELL:-include ")
  set(library setting-${id}-${name})
  umbral_unit_library(${library} ${folder}/settings ${name} ${solution})
  target_compile_options(${library} PRIVATE ${UMBRAL_STUDENT_FLAGS} -UNDEBUG "SHELL:-include ${UMBRAL_STUDENT_HEADER}"
    ${interfaces})
  set_source_files_properties(${solution} PROPERTIES OBJECT_DEPENDS ${UMBRAL_STUDENT_HEADER}.gch)
  target_link_options(${library} PRIVATE -Wl,-z,lazy -Wl,--version-script=${folder}/exports.map)
  set_target_properties(${library} PROPERTIES LINK_DEPENDS ${folder}/exports.map CXX_CLANG_TIDY "")
  add_dependencies(${library} exports-${id})
  add_dependencies(unit-${id} ${library})
endfunction()
