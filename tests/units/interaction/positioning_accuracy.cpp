// positioning-accuracy: the table of the statement of interaction/positioning. Points of planes in front of 20,000
// random perspective cameras, against the same in long double; errors in parts of the distance over the sine of the
// angle.

#include <algorithm>
#include <cstdio>
#include <glm/gtc/matrix_transform.hpp>
#include <umbral/core/random.hpp>
#include <umbral/interaction/positioning.hpp>
#include <vector>

namespace {

using namespace umbral;
using namespace umbral::interaction;

template <class Number>
using Vec3 = glm::vec<3, Number>;

/// Where the ray through the pixel's centre meets the plane, and the sine of their angle.
template <class Number>
std::pair<Vec3<Number>, Number> point_in(glm::ivec2 pixel, const glm::mat4& view, const glm::mat4& projection,
                                         const SnapPlane& plane)
{
    using Vec4 = glm::vec<4, Number>;
    using Mat4 = glm::mat<4, 4, Number>;
    const Mat4 back = glm::inverse(Mat4(projection) * Mat4(view));
    const glm::vec<2, Number> share = (glm::vec<2, Number>(pixel) + Number(0.5)) / glm::vec<2, Number>(640, 480);
    const glm::vec<2, Number> ndc(2 * share.x - 1, 1 - 2 * share.y);
    const Vec4 a = back * Vec4(ndc, -1, 1);
    const Vec4 b = back * Vec4(ndc, 1, 1);
    const Vec3<Number> from = Vec3<Number>(a) / a.w;
    const Vec3<Number> along = Vec3<Number>(b) / b.w - from;
    const Vec3<Number> normal(plane.normal);
    const Number slope = glm::dot(normal, along);
    return {from + along * ((Number(plane.offset) - glm::dot(normal, from)) / slope),
            std::abs(slope) / (glm::length(normal) * glm::length(along))};
}

}

int main()
{
    std::vector<double> in_double;
    std::vector<double> in_float;
    Random random(1);
    for (int i = 0; i < 20'000; ++i) {
        const glm::vec3 eye = 10.0F * random.in_cube();
        const glm::mat4 view = glm::lookAt(eye, eye + random.in_cube() + glm::vec3(0, 0, 1.5F), {0, 1, 0});
        const glm::mat4 projection = glm::perspective(0.8F, 4.0F / 3, 0.1F, 100.0F);
        const glm::ivec2 pixel(random.below(640), random.below(480));
        const SnapPlane plane{glm::dvec3(random.in_cube()), random.uniform(-5, 5)};
        const auto [right, sine] = point_in<long double>(pixel, view, projection, plane);
        const auto point = point_on_plane(pixel, {640, 480}, view, projection, plane);
        if (!point || sine < 1e-3L) continue;
        const long double unit = glm::length(right - Vec3<long double>(eye)) / sine;
        in_double.push_back(static_cast<double>(glm::length(Vec3<long double>(*point) - right) / unit));
        const Vec3<long double> rough(point_in<float>(pixel, view, projection, plane).first);
        in_float.push_back(static_cast<double>(glm::length(rough - right) / unit));
    }
    const auto quantile = [](std::vector<double> errors, double share) {
        std::sort(errors.begin(), errors.end());
        return errors[static_cast<std::size_t>(share * static_cast<double>(errors.size() - 1))];
    };
    for (const auto& [name, share] : {std::pair{"median", 0.5}, {"99 %", 0.99}, {"largest", 1.0}})
        std::printf("| %s | %.1e | %.1e |\n", name, quantile(in_double, share), quantile(in_float, share));
    std::printf("%zu points\n", in_double.size());
}
