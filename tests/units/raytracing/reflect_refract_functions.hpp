#pragma once

#include <umbral/raytracing/reflect_refract.hpp>

/// What a module of raytracing/reflect-refract exports.
struct ReflectRefractFunctions {
    glm::vec3 (*mirrored)(const glm::vec3&, const glm::vec3&);
    std::optional<glm::vec3> (*refracted)(const glm::vec3&, const glm::vec3&, float, float);
    std::optional<float> (*critical_angle)(float, float);
};
