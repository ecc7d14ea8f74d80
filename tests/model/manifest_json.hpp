#pragma once

#include <nlohmann/json.hpp>

namespace umbral::grader::test {

/// A manifest that uses every field and is right.
inline nlohmann::json manifest()
{
    return nlohmann::json::parse(R"({
        "format": "umbral-exercise", "version": 1, "id": "lighting/phong-2", "files": ["phong.vert", "phong_2.cpp"],
        "points": 4.875,
        "uses": ["transforms/rotation", "lighting/lambert"], "forbid": ["glm::lookAt", "operator new"], "gl": true,
        "title": {"en": "Phong", "es": "Sombreado de Phong"}, "course": ["problem 4.1"], "order": 12.5,
        "limits": {"wall_seconds": 7.5, "memory_mib": 1024},
        "knob": {"name": "ray-sphere", "check": "views/matrix", "case": "picture"},
        "checks": [
            {"case": "head-on", "value": "t", "judge": "numbers", "points": 2.005, "hard": true, "pairs": true,
             "tolerance": {"absolute": 1e-6, "relative": 2e-6, "ulps": 4, "band_ulps": 2}, "full": 0.9, "zero": 0.5,
             "why": "one root rounds"},
            {"case": "views", "value": "matrix", "judge": "matrices", "points": 1, "tolerance": {"ulps": 0},
            "why": "exact"},
            {"case": "head-on", "value": "ids", "judge": "buffer", "points": 0.12, "hidden": true},
            {"case": "picture", "value": "normals", "judge": "image", "points": 1, "range": [-1, 1]},
            {"case": "frames", "value": "later frames", "judge": "trace", "points": 0.5,
             "rules": ["draw calls", "uploaded bytes"]},
            {"case": "growth", "value": "blocks", "judge": "cost", "points": 0.25, "growth": 1.5}
        ]})");
}

}
