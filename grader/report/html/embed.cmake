# cmake -DOUTPUT=file.cpp -DFOLDER=resources -P embed.cmake
# Writes the page's skeleton, its styles and its scripts as C++ texts, so that reports depend on no file of the
# installation.
set(text
  "// Made by embed.cmake from the files in grader/report/html/resources.\n#include \"report/html/resources.hpp\"\n\n")
string(APPEND text "namespace umbral::grader::html::resources {\n")
foreach(entry "page:page.html" "style:base.css;report.css;evidence.css;class.css;notices.css;catalogue.css"
  "script:page.js;pictures.js;magnifier.js;class.js")
  string(FIND "${entry}" ":" colon)
  string(SUBSTRING "${entry}" 0 ${colon} name)
  math(EXPR colon "${colon} + 1")
  string(SUBSTRING "${entry}" ${colon} -1 files)
  string(APPEND text "const std::string_view ${name} = ")
  foreach(file IN LISTS files)
    file(READ ${FOLDER}/${file} content)
    string(APPEND text "R\"resource(${content})resource\"\n")
  endforeach()
  string(APPEND text ";\n")
endforeach()
string(APPEND text "}\n")
file(WRITE ${OUTPUT} "${text}")
