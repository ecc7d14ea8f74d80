#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <umbral/core/not_implemented.hpp>

namespace umbral::interaction {

/// What the controls of a three-mode camera change. Course: ModoCam.
enum class CameraMode {
    examine,  ///< the observer goes round the attention point (modo orbital o examinar)
    move,     ///< first person: observer and attention point go along the camera's axes together
    turn,     ///< first person: the observer stays, and turns his head
};

/// Where a three-mode camera begins, and how far it may go. Angles in radians.
struct ThreeModeSettings {
    glm::dvec3 attention{0};     ///< what it looks at: always in the middle of the picture
    double azimuth = 0;          ///< round the world's y axis: 0 stands on the side of +z, π/2 on that of +x
    double elevation = 0;        ///< above the plane y = attention.y; |elevation| <= π/2
    double distance = 3;         ///< from the attention point; 1.001 min_distance <= distance <= max_distance
    double min_distance = 0.1;   ///< > 0; steps come nearer and nearer to it
    double max_distance = 1000;  ///< > min_distance
    double zoom_step = 0.1;      ///< > 0: a step backwards makes the way to min_distance longer by this part
    CameraMode mode = CameraMode::examine;
};

/// A camera with three modes. Course: class Camara3Modos.
///
/// Its state is an attention point a and spherical coordinates: azimuth α, elevation β, distance r. The observer stands
/// at a + n with n = r (cos β sin α, sin β, cos β cos α). The camera's axes in the world are x = (cos α, 0, -sin α),
/// z = n / r and y = z × x, at the poles too. **β stays within ±π/2** and **r within 1.001 min_distance and
/// max_distance**, in all that follows: what goes beyond is lost, so that the way back begins at once. Calls with a NaN
/// or an infinity are ignored as a whole; all others count and end at once, however large their numbers are.
class ThreeModeCamera {
public:
    virtual ~ThreeModeCamera() = default;

    /// To the right by `right` and up by `up`: the camera's arrow keys. Course: desplRotarXY(Δa, Δb).
    ///
    /// - examine: α grows by `right` and β by `up`; the attention point stays.
    /// - move: a goes by right x + up y.
    /// - turn: α grows by `right` and β by `up`; the observer stays, and a moves instead.
    virtual void move_xy(double right, double up) = 0;

    /// Backwards by `steps`, or parts of a step; negative: forwards. Course: moverZ(Δz).
    ///
    /// - examine: r becomes min_distance + (r - min_distance) (1 + zoom_step)^steps.
    /// - move and turn: a goes by steps z.
    virtual void move_z(double steps) = 0;

    /// Turns the camera where it stands until `point` is in the middle of the picture, and changes to `examine`.
    /// Course: mirarHacia.
    ///
    /// The observer stays, and the new angles and distance are those to `point`, which thereby becomes the attention
    /// point; a distance under 1.001 min_distance or over max_distance becomes that. A point within 1e-6 of the
    /// observer is in no direction: the call is ignored, and the mode stays. If the point lies straight above or below
    /// (the sine of the angle to the vertical is under 1e-6), α stays as it is, and the attention point lies
    /// beside `point`: as far from the vertical through the observer, but in the direction that α has.
    virtual void look_toward(const glm::dvec3& point) = 0;

    /// From examine to move, from move to turn, from turn to examine; nothing else changes. Course: siguienteModo.
    virtual void next_mode() = 0;

    [[nodiscard]] virtual CameraMode mode() const = 0;

    /// The attention point a. Course: puntoAtencion.
    [[nodiscard]] virtual glm::dvec3 attention_point() const = 0;

    /// The matrix that takes the world to camera coordinates (the camera at the origin, looking along -z), at any
    /// moment. Guarantee of the reference, for |a| up to 1e6 and after 100,000 calls that turn by up to π each:
    /// rotation within 1e-7 in every entry, and translation within 1e-7 of |a| + r.
    [[nodiscard]] virtual glm::mat4 view() const = 0;
};

/// A new camera, as its settings say; it shares nothing with those made before, and outlives its settings.
[[nodiscard]] std::unique_ptr<ThreeModeCamera> make_three_mode_camera(const ThreeModeSettings& settings);

}
