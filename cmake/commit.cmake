# Run at every build: keeps the commit in a file that changes only when it does.
cmake_minimum_required(VERSION 3.25)  # the policies of the project, which a script does not inherit
execute_process(COMMAND git -C ${SOURCE} rev-parse --short=12 HEAD OUTPUT_VARIABLE commit
  OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT commit)
  set(commit unknown)
endif()
file(CONFIGURE OUTPUT ${FILE} CONTENT "@commit@\n" @ONLY)
