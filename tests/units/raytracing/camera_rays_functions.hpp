#pragma once

#include <umbral/raytracing/camera_rays.hpp>

/// What a module of raytracing/camera-rays exports.
struct CameraRaysFunctions {
    umbral::Ray (*primary_ray)(const umbral::raytracing::PrimaryCamera&, int, int, const glm::vec2&);
    std::vector<glm::vec2> (*pixel_samples)(int, int, int);
    umbral::Grid<glm::vec3> (*render_picture)(const umbral::raytracing::PrimaryCamera&, int, int, int,
                                              const umbral::raytracing::LightAlongRay&);
};
