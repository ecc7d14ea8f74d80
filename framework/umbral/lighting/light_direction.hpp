#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <umbral/core/not_implemented.hpp>
#include <umbral/lighting/light_frame.hpp>

/// Directional lights that are given by two angles and turned by keys, as in the fourth lab of the course. Directions
/// point **towards** the light.
namespace umbral::lighting {

/// Where a light is seen in the sky of its frame. In degrees, as in the course, so that steps of 5 are exact.
struct LightAngles {
    float longitude_degrees = 0;  ///< α, about the y axis: 0 is the direction +z, 90 is +x
    float latitude_degrees = 0;   ///< β, from the plane y = 0 upwards: 90 is +y
};

/// The unit vector towards the light, (cos β sin α, sin β, cos β cos α), for all finite angles. Guarantee of the
/// reference: each component within 1e-7. Course: lab 4, light sources (0 and 0 is +z).
[[nodiscard]] glm::vec3 light_direction(const LightAngles& angles);

/// The angles of a direction of any length: the longitude in [0, 360), the latitude in [-90, 90]. Straight up or down
/// the longitude is 0, and of the null vector both angles are 0; zeros may have either sign. Guarantee of the
/// reference: each angle within 1 ulp of the exact one, where 360 is the same as 0; for all finite floats.
[[nodiscard]] LightAngles light_angles(const glm::vec3& direction);

/// The unit vector towards the light in camera coordinates, as OpenGL wants it. `view` leads from world to camera
/// coordinates and is rigid: a rotation, then a translation. The frame says in which of the two the angles are counted.
/// Guarantee of the reference: each component within 1e-7 of what the matrix's entries give. Course: lab 4,
/// "fijas al marco de la cámara"; class FuenteLuz, in world coordinates.
[[nodiscard]] glm::vec3 direction_in_camera(const LightAngles& angles, LightFrame frame, const glm::mat4& view);

/// The unit vector towards the same light in world coordinates: the other way round, with the same guarantee.
[[nodiscard]] glm::vec3 direction_in_world(const LightAngles& angles, LightFrame frame, const glm::mat4& view);

/// A light that the keys of lab 4 turn.
class LightControl {
public:
    virtual ~LightControl() = default;

    /// A key was pressed, given as its character, in capitals or not: A adds a step to the latitude, Z takes one off; X
    /// adds a step to the longitude, C takes one off. The latitude stops at 90 and -90; the longitude goes round. All
    /// other characters do nothing. Whether the light was turned, and the picture must be drawn again.
    virtual bool press(char key) = 0;

    /// Where the light is now: the longitude in [0, 360), the latitude in [-90, 90]. Guarantee of the reference, after
    /// 10⁶ keys: within 1e-6 degrees and one rounding to float; exact if the angles and the step are whole numbers.
    [[nodiscard]] virtual LightAngles angles() const = 0;
};

/// A light that stands at `initial`, whose longitude may be any finite number and whose latitude is in [-90, 90], and
/// is turned by `step_degrees`, above 0 and up to 180. It shares nothing with those made before. Course: lab 4, keys A,
/// Z, X, C; FuenteLuz::gestionarEventoTeclaEspecial.
[[nodiscard]] std::unique_ptr<LightControl> make_light_control(const LightAngles& initial, float step_degrees);

}
