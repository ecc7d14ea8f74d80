#pragma once

// GLFW's own header without the OpenGL header that it would include: OpenGL's functions come from
// <umbral/gl/opengl.hpp>.
#ifndef GLFW_INCLUDE_NONE
#define GLFW_INCLUDE_NONE
#endif
#include <GLFW/glfw3.h>
