#pragma once

#include <umbral/raytracing/cylinder_cone.hpp>

/// What a module of raytracing/cylinder-cone exports.
struct CylinderConeFunctions {
    float (*cylinder_field)(const glm::vec3&);
    float (*cone_field)(const glm::vec3&);
    std::optional<float> (*intersect_cylinder)(const umbral::Ray&);
    std::optional<float> (*intersect_cone)(const umbral::Ray&);
};
