#pragma once

#include <glm/gtc/matrix_transform.hpp>
#include <umbral/core/random.hpp>

/// Cameras for questions about points on planes.
namespace umbral::interaction {

inline int between(int low, int high, Random& random)
{
    return low + static_cast<int>(random.below(static_cast<std::uint32_t>(high - low + 1)));
}

inline double between(double low, double high, Random& random) { return low + (high - low) * random.uniform_double(); }

/// A camera, perspective or not, that looks from somewhere at something else.
struct SnapCamera {
    glm::mat4 view;
    glm::mat4 projection;
    glm::ivec2 size;
};

inline SnapCamera random_camera(Random& random)
{
    const glm::vec3 target = 4.0F * random.in_cube();
    const glm::vec3 away = random.in_cube() + glm::vec3(0, 0, random.below(2) == 0 ? 2.5F : -2.5F);
    const glm::ivec2 size(between(100, 900, random), between(100, 700, random));
    const glm::vec3 up = random.in_cube() + glm::vec3(0, 2, 0);
    const glm::mat4 view = glm::lookAt(target + 2.0F * away, target, up);
    const float near = random.uniform(0.05F, 1);
    const float half = random.uniform(1, 6);
    const float shift = random.uniform(-1, 1);
    const glm::mat4 orthographic = glm::ortho(shift - half, shift + half, -half, 0.7F * half, near, near + 60);
    const glm::mat4 perspective = glm::frustum(near * (0.1F * shift - 0.4F), near * (0.1F * shift + 0.5F), -0.3F * near,
                                               0.4F * near, near, 80.0F);
    return {view, random.below(3) == 0 ? orthographic : perspective, size};
}

/// The same camera in a world so many times as large, a power of two: exactly the same picture.
inline SnapCamera in_a_world_of(double size, SnapCamera camera)
{
    const auto factor = static_cast<float>(size);
    camera.view[3] = glm::vec4(factor * glm::vec3(camera.view[3]), 1);
    if (camera.projection[3][3] == 0) {
        camera.projection[3][2] *= factor;
    } else {
        for (int i = 0; i < 3; ++i) camera.projection[i] /= factor;
    }
    return camera;
}

}
