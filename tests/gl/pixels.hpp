#pragma once

#include <array>
#include <umbral/gl/mesh.hpp>
#include <umbral/gl/program.hpp>

/// Small things to draw.
namespace umbral::gl {

inline const char* const plain_vertex =
    "#version 330\nin vec3 position;\nvoid main() { gl_Position = vec4(position, 1.0); }\n";
inline const char* const plain_fragment =
    "#version 330\nuniform vec4 color;\nout vec4 result;\nvoid main() { result = color; }\n";

inline ShaderSource vertex_source(const char* text) { return {"test.vert", text}; }
inline ShaderSource fragment_source(const char* text) { return {"test.frag", text}; }

/// The rectangle [left, right] x [bottom, top] at depth `z`, in normalised device coordinates.
inline Mesh rectangle(float left, float right, float bottom, float top, float z = 0)
{
    const std::array positions = {glm::vec3(left, bottom, z), glm::vec3(right, bottom, z), glm::vec3(right, top, z),
                                  glm::vec3(left, top, z)};
    const std::array<std::uint32_t, 6> indices = {0, 1, 2, 0, 2, 3};
    return Mesh(positions, {}, indices);
}

}
