#pragma once

#include <umbral/projections/fit.hpp>

/// What the test of projections/fit-frustum asks of a solution.
struct Fit {
    umbral::projections::ViewVolume (*cube)(float, float, const umbral::projections::PictureSize&);
    umbral::projections::ViewVolume (*sphere)(float, float, const umbral::projections::PictureSize&);
    umbral::projections::PlacedVolume (*cube_to_fovy)(const glm::vec3&, float, float,
                                                      const umbral::projections::PictureSize&);
};
