#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace umbral::gl::generate {

struct Parameter {
    std::string declaration;  ///< as in the header: "const GLfloat m[16]"
    std::string name;         ///< "m"
};

/// One function of OpenGL as a header declares it.
struct Prototype {
    std::string result;  ///< "void", "const GLubyte *"
    std::string name;    ///< "glClear"
    std::vector<Parameter> parameters;
};

/// The text without comments; line ends stay, so that preprocessor lines can still be told.
[[nodiscard]] std::string without_comments(std::string_view text);

/// What lies between `#ifndef GL_VERSION_x_y` and its end, for every version up to `major`.`minor`. Empty for a header
/// without such blocks.
[[nodiscard]] std::string core_versions(std::string_view text, int major, int minor);

/// Every `GLAPI result APIENTRY name(parameters);` of the text, but for names with a vendor's suffix (ARB, EXT, …).
/// Throws std::runtime_error on a parameter it cannot read.
[[nodiscard]] std::vector<Prototype> prototypes(const std::string& text);

}
