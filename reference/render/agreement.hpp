#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "render/compare.hpp"
#include "render/renderers.hpp"
#include "scene/scene.hpp"

namespace umbral::render {

/// Two renderers' pictures of one scene. What two right ones share depends on where they compute the light.
struct PairComparison {
    std::string first;
    std::string second;
    bool same_light = false;  ///< both at pixels or both at vertices: then colours must agree too
    Agreement allowed;        ///< by how much they may differ
    Comparison comparison;
    NormalComparison normals;
};

/// One scene drawn by all.
struct SceneAgreement {
    std::string title;
    std::vector<PairComparison> pairs;
    std::vector<std::string> differences;  ///< one sentence for each class of differences that this scene can show
    std::vector<std::string> missing;      ///< who cannot draw it, and why
};

/// Draws a scene by all renderers (not more often than once each, and twice more for its normals) and compares
/// software with gl, both with gl-fixed, gl-fixed with light at vertices in software, and software with rays.
[[nodiscard]] SceneAgreement compare_renderers(Studio& studio, const scene::Scene& scene, bool all_kernels, int width,
                                               int height);

[[nodiscard]] bool agrees(const PairComparison& pair);
[[nodiscard]] bool agrees(const SceneAgreement& agreement);

/// A Markdown table, a row a pair; the head is not in a row's text.
[[nodiscard]] std::string agreement_head();
[[nodiscard]] std::string agreement_rows(const SceneAgreement& agreement);
/// What the scene's differences come from, and the verdict.
[[nodiscard]] std::string agreement_notes(const SceneAgreement& agreement);

[[nodiscard]] nlohmann::json to_json(const SceneAgreement& agreement);

}
