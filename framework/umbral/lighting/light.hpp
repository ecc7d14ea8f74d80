#pragma once

#include <glm/glm.hpp>

/// What takes part in the local illumination model. All of it is in one frame, whichever: the world's, or the eye's.
namespace umbral::lighting {

/// A source of light: with w = 1 a place (positional), with w = 0 a direction **towards** the light, of any length
/// (directional). No other w occurs. Its light does not weaken with the distance. Course: section C 1.7, "fuente
/// posicional / direccional".
struct Light {
    glm::vec4 position{0, 0, 1, 0};
    glm::vec3 color{1};  ///< S, the light that it sends: linear, at least 0, without an upper bound
};

/// How a surface looks. Reflectances lie in [0, 1]; emission has no upper bound.
struct Material {
    glm::vec3 emission{0};  ///< M_E, what it sends out by itself
    glm::vec3 ambient{0};   ///< M_A
    glm::vec3 diffuse{0};   ///< M_D
    glm::vec3 specular{0};  ///< M_S
    float shininess = 1;    ///< e, the exponent of the highlight, 0 to 10⁴
};

/// A place on a surface, and the surface's normal there: of any length, on the side that is lit.
struct SurfacePoint {
    glm::vec3 position{0};
    glm::vec3 normal{0, 0, 1};
};

}
