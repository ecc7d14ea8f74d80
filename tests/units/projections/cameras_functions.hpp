#pragma once

#include <umbral/projections/camera.hpp>

/// What the test of projections/cameras asks of a solution.
struct CamerasFunctions {
    std::unique_ptr<umbral::projections::Camera> (*base)();
    std::unique_ptr<umbral::projections::OrbitalCamera> (*orbital)(float, float, float);
};
