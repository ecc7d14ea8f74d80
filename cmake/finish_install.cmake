# Run by `cmake --install` when a component's files are there: takes symbols and debug information out of them, veils
# libraries of answers
# (grader/worker/packaged_unit.hpp), and puts the program where a shell finds it.
set(prefix $ENV{DESTDIR}${CMAKE_INSTALL_PREFIX})
file(GLOB_RECURSE binaries LIST_DIRECTORIES false ${prefix}/lib/umbral/bin/* ${prefix}/lib/umbral/*.so)
if(binaries)
  execute_process(COMMAND ${UMBRAL_STRIP} --strip-unneeded --remove-section=.comment ${binaries} COMMAND_ERROR_IS_FATAL
    ANY)
endif()
if(UMBRAL_VEIL)
  execute_process(COMMAND ${UMBRAL_VEIL} --veil ${prefix}/lib/umbral/units COMMAND_ERROR_IS_FATAL ANY)
endif()
if(EXISTS ${prefix}/lib/umbral/bin/umbral)
  file(MAKE_DIRECTORY ${prefix}/bin)
  file(CREATE_LINK ../lib/umbral/bin/umbral ${prefix}/bin/umbral SYMBOLIC)
endif()
