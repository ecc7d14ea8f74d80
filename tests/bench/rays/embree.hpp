#pragma once

#include <embree3/rtcore.h>

#include <memory>
#include <span>

#include "raytrace/hierarchy.hpp"

namespace umbral::raytrace::bench {

/// The same questions to Embree: robust, one ray at a time, one thread. Another engine altogether.
class EmbreeScene {
public:
    explicit EmbreeScene(std::span<const Corners> triangles);

    [[nodiscard]] Hit first_hit(const Ray& ray) const;
    [[nodiscard]] bool is_blocked(const Ray& ray) const;

private:
    std::unique_ptr<RTCDeviceTy, void (*)(RTCDevice)> device_;
    std::unique_ptr<RTCSceneTy, void (*)(RTCScene)> scene_;
};

}
