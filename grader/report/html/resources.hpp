#pragma once

#include <string_view>

namespace umbral::grader::html::resources {

// The files of resources/, embedded when the project is built (embed.cmake).
extern const std::string_view page;    ///< page.html, with {{name}} where something goes in
extern const std::string_view style;   ///< all .css files
extern const std::string_view script;  ///< all .js files

}
