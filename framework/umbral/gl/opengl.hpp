#pragma once

// Every function of OpenGL 1.0 to 4.5, compatibility profile, as libumbral-gl exports them. Include this, never
// <GL/gl.h> alone.

#ifndef GL_GLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES
#endif
#include <GL/gl.h>
#include <GL/glext.h>
