// alternative: walks from the light to the point, and stops short of the surface (a sun gets a ray that ends there)
#include <umbral/raytracing/shadows.hpp>

namespace umbral::raytracing {
namespace {

class Receiver {
public:
    explicit Receiver(const ShadedPoint& point)
        : normal_(point.normal), raised_(glm::dvec3(point.position) + 5.0 * double{point.error} * normal_)
    {
    }

    [[nodiscard]] bool faces(const glm::dvec3& towards) const { return dot(normal_, towards) > 0; }
    [[nodiscard]] glm::vec3 place() const { return glm::vec3(raised_); }

private:
    glm::dvec3 normal_;
    glm::dvec3 raised_;
};

}

bool sees_light(const ShadedPoint& point, const glm::vec4& light, const ShadowCasters& casters)
{
    const Receiver receiver(point);
    bool blocked = false;
    if (light.w > 0.5F) {
        if (!receiver.faces(glm::dvec3(light) - glm::dvec3(point.position))) return false;
        // The end of this ray is the receiver only but for rounding: so its own end decides where it starts.
        const glm::vec3 end = receiver.place();
        const Ray back{end, glm::vec3(light) - end, 0, 1};
        for (const ShadowBall& ball : casters.balls) blocked = blocked || meets(ball, back);
        for (const ShadowTriangle& triangle : casters.triangles) blocked = blocked || meets(triangle, back);
        return !blocked;
    }
    if (!receiver.faces(glm::dvec3(light))) return false;
    // Against the sun: the same line with the direction turned round, and all that has a negative t.
    Ray ray;
    ray.origin = receiver.place();
    ray.direction = -glm::vec3(light);
    ray.t_min = -ray.t_max;
    ray.t_max = 0;
    return !meets_any(casters, ray);
}

}
