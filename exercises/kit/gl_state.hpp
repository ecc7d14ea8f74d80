#pragma once

#include <umbral/gl/opengl.hpp>

/// What state OpenGL is in, and which objects there are.
namespace umbral {

/// A parameter of OpenGL's state.
inline GLint integer(GLenum name)
{
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

/// How many of the first thousand names are names of such objects: glIsBuffer, glIsTexture …
inline int living(GLboolean (*is_one)(GLuint))
{
    int count = 0;
    for (GLuint name = 1; name <= 1000; ++name) count += is_one(name) == GL_TRUE ? 1 : 0;
    return count;
}

}
