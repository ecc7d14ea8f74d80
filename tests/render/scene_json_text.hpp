#pragma once

#include <exception>
#include <nlohmann/json.hpp>
#include <string>

#include "scene/scene_json.hpp"

namespace umbral::scene::test {

/// A scene with one of everything, and every field given somewhere.
inline nlohmann::json document()
{
    return nlohmann::json::parse(R"({
  "format": "umbral-scene", "version": 1, "title": "One of each",
  "camera": {"eye": [0, 1, 5], "target": [0, 0, 0], "up": [0, 1, 0], "fovy_degrees": 45, "near": 0.2, "far": 50,
             "lens_radius": 0.1, "focus_distance": 4, "shutter_seconds": 0.5},
  "background": {"top": [0, 0, 0.5], "bottom": [1, 1, 1]},
  "ambient": [0.1, 0.1, 0.1], "bounces": 2, "depth": 5, "seconds": 4,
  "lights": [{"name": "sun", "towards": [1, 1, 1], "color": [1, 0.9, 0.8], "half_angle_degrees": 1},
             {"name": "lamp", "position": [0, 3, 0], "radius": 0.2}],
  "textures": {
    "squares": {"kind": "checker", "size": 64, "cells": 8, "colors": [[1, 1, 1], [0, 0, 0]], "filter": "nearest",
    "wrap": "clamp"},
    "bars": {"kind": "stripes", "size": 16, "cells": 4, "colors": [[1, 0, 0], [0, 0, 1]]},
    "map": {"kind": "uv-grid", "size": 32, "cells": 4},
    "oak": {"kind": "wood", "size": 16, "cells": 2, "colors": [[0.6, 0.4, 0.2], [0.3, 0.2, 0.1]]}
  },
  "materials": {
    "dull": {},
    "shiny": {"emission": [0, 0, 0], "ambient": [0.1, 0.1, 0.1], "diffuse": [0.5, 0.5, 0.5], "specular": [1, 1, 1],
    "exponent": 40,
              "texture": "squares", "texture_scale": [2, 2], "mirror": [0.1, 0.1, 0.1], "transmit": [0, 0, 0.5],
              "index": 1.5, "bump": "oak", "bump_height": 0.1}
  },
  "geometries": {
    "ball": {"kind": "sphere", "rings": 8, "sectors": 16},
    "ring": {"kind": "torus", "rings": 8, "sectors": 8, "tube": 0.2},
    "floor": {"kind": "wave", "rows": 4, "columns": 4, "amplitude": 0.1, "waves": [1, 2]},
    "bare": {"kind": "triangles", "positions": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "triangles": [[0, 1, 2]]},
    "tri": {"kind": "triangles", "positions": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "triangles": [[0, 1, 2]],
            "uvs": [[0, 0], [1, 0], [0, 1]]},
    "vase": {"kind": "revolution", "profile": [[0, 0], [1, 0], [1, 2]], "sectors": 8},
    "wheel": {"kind": "cylinder", "sectors": 8},
    "pot": {"kind": "teapot", "subdivisions": 3},
    "scan": {"kind": "mesh", "file": "scan.ply", "package": "scan-data", "fit": true},
    "statue": {"kind": "distance-field", "field": "mandelbulb", "cells": 16}
  },
  "groups": {
    "cart": [{"name": "left", "geometry": "wheel", "material": "dull",
              "transforms": [{"spin": {"axis": [0, 1, 0], "degrees_per_second": 90}}, {"translate": [-1, 0, 0]}]},
             {"name": "right", "geometry": "wheel", "material": "dull", "transforms": [{"translate": [1, 0, 0]}]}],
    "train": [{"name": "front", "group": "cart"},
              {"name": "back", "group": "cart", "transforms": [{"translate": [0, 0, -2]}]}]
  },
  "instances": [
    {"name": "first", "geometry": "ball", "material": "dull", "shading": "flat", "sides": "both",
     "transforms": [{"scale": [1, 2, 1]}, {"rotate": {"axis": [0, 1, 0], "degrees": 30}}, {"translate": [1, 0, 0]}]},
    {"name": "second", "geometry": "tri", "material": "shiny"},
    {"name": "train", "group": "train",
     "transforms": [{"move": [1, 0, 0]}, {"bob": {"by": [0, 1, 0], "period": 2, "phase": 0.25}},
                    {"swing": {"axis": [1, 0, 0], "degrees": 20, "period": 4}}]}
  ]
})");
}

/// What reading it complains of.
inline std::string message_of(const std::string& text)
{
    try {
        (void)parse_scene(text, "s.json");
    } catch (const std::exception& error) {
        return error.what();
    }
    return "nothing was thrown";
}

}
