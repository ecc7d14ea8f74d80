#include "spoil.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>
#include <vector>

namespace umbral::bench::scenes {
namespace {

float distance_of(const Model& m) { return glm::length(m.camera.eye - m.camera.target); }

glm::mat4 matrix(const Model& m, const Batch& batch)
{
    const Camera& c = m.camera;
    const float aspect = static_cast<float>(m.width) / static_cast<float>(m.height);
    const float half = c.ortho_height / 2;
    const glm::mat4 projection = half > 0 ? glm::ortho(-half * aspect, half * aspect, -half, half, c.near, c.far)
                                          : glm::perspective(glm::radians(c.fovy_degrees), aspect, c.near, c.far);
    return projection * glm::lookAt(c.eye, c.target, c.up) * batch.model;
}

/// Places in normalised device coordinates of `count` corners from `first` on; empty where one lies behind the camera.
std::vector<glm::vec3> on_screen(const Batch& batch, const glm::mat4& m, std::size_t first, std::size_t count)
{
    std::vector<glm::vec3> places;
    for (std::size_t i = first; i < first + count; ++i) {
        const glm::vec4 clip = m * glm::vec4(batch.corners[i].position, 1);
        if (clip.w <= 0) return {};
        places.push_back(glm::vec3(clip) / clip.w);
    }
    return places;
}

float area(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Does a triangle of any mesh lie in front of this place?
bool is_hidden(const Model& m, const glm::vec3& at)
{
    for (const Batch& batch : m.batches) {
        if (batch.edge_corners > 0 || batch.blend != Blend::none) continue;
        const glm::mat4 seen = matrix(m, batch);
        for (std::size_t i = 0; i + 2 < batch.corners.size(); i += 3) {
            const std::vector<glm::vec3> t = on_screen(batch, seen, i, 3);
            if (t.empty()) continue;
            const float whole = area(t[0], t[1], t[2]);
            const glm::vec3 share = glm::vec3(area(at, t[1], t[2]), area(t[0], at, t[2]), area(t[0], t[1], at)) / whole;
            if (std::abs(whole) > 1e-9F && share.x >= 0 && share.y >= 0 && share.z >= 0 &&
                dot(share, glm::vec3(t[0].z, t[1].z, t[2].z)) < at.z - 1e-5F)
                return true;
        }
    }
    return false;
}

/// A triangle or line that could be dropped.
struct Candidate {
    float size;
    glm::vec3 middle;
    Batch* batch;
    std::size_t first;
};

/// Drops the largest triangle or longest line that is seen, of the batches with the most of them.
void drop_one(Model& m, bool edges)
{
    std::size_t most = 0;
    for (const Batch& batch : m.batches)
        if ((batch.edge_corners > 0) == edges) most = std::max(most, batch.corners.size());
    std::vector<Candidate> candidates;
    for (Batch& batch : m.batches) {
        if ((batch.edge_corners > 0) != edges || batch.corners.size() < most) continue;
        const std::size_t count = edges ? batch.edge_corners : 3;
        const glm::mat4 seen = matrix(m, batch);
        for (std::size_t i = 0; i + count <= batch.corners.size(); i += count) {
            const std::vector<glm::vec3> t = on_screen(batch, seen, i, count);
            if (t.empty()) continue;
            const glm::vec3 middle = edges ? (t[0] + t[1]) / 2.0F : (t[0] + t[1] + t[2]) / 3.0F;
            const float size = edges ? glm::length(t[1] - t[0]) : area(t[0], t[1], t[2]);
            if (size > 0 && std::abs(middle.x) < 1 && std::abs(middle.y) < 1)
                candidates.push_back({size, middle, &batch, i});
        }
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.size > b.size; });
    const auto shown = std::find_if(candidates.begin(), candidates.end(),
                                    [&](const Candidate& one) { return !is_hidden(m, one.middle); });
    if (shown == candidates.end()) return;
    const auto at = shown->batch->corners.begin() + static_cast<std::ptrdiff_t>(shown->first);
    shown->batch->corners.erase(at, at + static_cast<std::ptrdiff_t>(edges ? shown->batch->edge_corners : 3));
}

/// Moves the corners of each triangle towards its centre by so many pixels, or away from it.
void shrink(Model& m, float pixels)
{
    const float pixel =
        (m.camera.ortho_height > 0 ? m.camera.ortho_height
                                   : 2 * std::tan(glm::radians(m.camera.fovy_degrees) / 2) * distance_of(m)) /
        static_cast<float>(m.height);
    for (Batch& batch : m.batches) {
        if (batch.edge_corners > 0) continue;
        const float scale = glm::length(glm::vec3(batch.model[0]));
        for (std::size_t i = 0; i + 2 < batch.corners.size(); i += 3) {
            const glm::vec3 centre =
                (batch.corners[i].position + batch.corners[i + 1].position + batch.corners[i + 2].position) / 3.0F;
            for (std::size_t k = i; k < i + 3; ++k) {
                const glm::vec3 inwards = centre - batch.corners[k].position;
                const float size = glm::length(inwards);
                if (size > 0) batch.corners[k].position += inwards * std::min(pixels * pixel / scale / size, 0.4F);
            }
        }
    }
}

void flatten(Batch& batch)
{
    for (std::size_t i = 0; i + 2 < batch.corners.size(); i += 3) {
        Vertex* t = &batch.corners[i];
        const glm::vec3 n = glm::cross(t[1].position - t[0].position, t[2].position - t[0].position);
        for (int k = 0; k < 3; ++k) {
            if (glm::length(n) > 0) t[k].normal = glm::normalize(n);
            t[k].color = t[2].color;
        }
    }
}

void drop_crossing(const Model& m, Batch& batch)
{
    const glm::mat4 seen = matrix(m, batch);
    const auto outside = [&](const Vertex& v) {
        const glm::vec4 clip = seen * glm::vec4(v.position, 1);
        return clip.z < -clip.w;
    };
    Triangles kept;
    for (std::size_t i = 0; i + 2 < batch.corners.size(); i += 3)
        if (!outside(batch.corners[i]) && !outside(batch.corners[i + 1]) && !outside(batch.corners[i + 2]))
            kept.insert(kept.end(), {batch.corners[i], batch.corners[i + 1], batch.corners[i + 2]});
    batch.corners = kept;
}

/// The last triangle first, and the last batch; of what is blended only.
void reverse_layers(Model& m)
{
    const auto layers = std::stable_partition(m.batches.begin(), m.batches.end(),
                                              [](const Batch& b) { return b.blend == Blend::none; });
    std::reverse(layers, m.batches.end());
    for (auto batch = layers; batch != m.batches.end(); ++batch) {
        Triangles turned;
        for (std::size_t i = batch->corners.size(); i >= 3; i -= 3)
            turned.insert(turned.end(), {batch->corners[i - 3], batch->corners[i - 2], batch->corners[i - 1]});
        batch->corners = turned;
    }
}

void spoil_batch(const Model& m, Batch& batch, Flaw flaw)
{
    const bool blended = batch.blend != Blend::none;
    if (flaw == Flaw::front_faces_culled) batch.cull = Cull::front;
    if (flaw == Flaw::back_faces_shown) batch.cull = Cull::none;
    if (flaw == Flaw::flat_for_smooth) flatten(batch);
    if (flaw == Flaw::near_clipping_missing) drop_crossing(m, batch);
    if (flaw == Flaw::z_fighting) batch.depth_offset = 0;
    if (flaw == Flaw::depth_test_off) batch.depth_test = false;
    if (flaw == Flaw::shininess_halved) batch.material.shininess /= 2;
    if (flaw == Flaw::additive_for_over && blended) batch.blend = Blend::add;
    if (flaw == Flaw::over_for_additive && blended) batch.blend = Blend::over;
    if (flaw == Flaw::depth_written_by_layers && blended) batch.depth_write = true;
}

void spoil_camera(Model& m, Flaw flaw)
{
    Camera& c = m.camera;
    spoil_view(c, flaw);
    if (flaw == Flaw::fov_3_percent_wrong) c.ortho_height *= 1.03F;
    if (flaw == Flaw::aspect_ignored) c.takes_square = true;
    if (flaw == Flaw::near_plane_too_far) c.near = 0.97F * distance_of(m);
    if (flaw == Flaw::far_plane_too_near) c.far = 1.08F * distance_of(m);
    if (flaw == Flaw::near_plane_tiny) c.near = 1e-4F;
}

}

void spoil(Model& m, Flaw flaw)
{
    if (flaw == Flaw::missing_triangle) drop_one(m, false);
    if (flaw == Flaw::missing_edge) drop_one(m, true);
    if (flaw == Flaw::cracks) shrink(m, 0.7F);
    if (flaw == Flaw::overlapping_seams) shrink(m, -1.0F);
    if (flaw == Flaw::half_pixel_centre) m.moved = {0.5F, 0.5F};
    if (flaw == Flaw::sample_at_corner) m.moved = {-0.5F, -0.5F};
    if (flaw == Flaw::depth_inverted) m.farthest_wins = true;
    if (flaw == Flaw::one_light_missing && !m.lights.empty()) m.lights.pop_back();
    if (flaw == Flaw::ambient_missing) m.ambient = glm::vec3(0);
    if (flaw == Flaw::ambient_twice) m.ambient *= 2.0F;
    if (flaw == Flaw::blend_order || flaw == Flaw::depth_written_by_layers) reverse_layers(m);
    if (flaw == Flaw::line_width_wrong) m.line_width *= 2;
    if (flaw == Flaw::blank) m.batches.clear();
    for (Texture& texture : m.textures) {
        if (flaw == Flaw::clamp_for_repeat) texture.repeat = false;
        if (flaw == Flaw::nearest_for_linear) texture.linear = false;
        if (flaw == Flaw::no_mipmaps) texture.mipmaps = false;
    }
    spoil_camera(m, flaw);
    for (Batch& batch : m.batches) spoil_batch(m, batch, flaw);
}

}
