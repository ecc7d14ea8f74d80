#include <glm/gtc/matrix_transform.hpp>
#include <kit/canonical.hpp>
#include <kit/numbers_changed.hpp>
#include <umbral/record/driver.hpp>

#include "gallery.hpp"
#include "tasks.hpp"

namespace umbral {
namespace {

using namespace raytracing;

float extent_of(const FlatPolygon& polygon)
{
    float extent = 0;
    for (const glm::vec3& corner : polygon) extent = std::max(extent, glm::distance(corner, polygon.front()));
    return extent;
}

// Without corners that rounding alone may add: as near to the line between their neighbours.
FlatPolygon without_flat_corners(const FlatPolygon& polygon)
{
    const float nearest = 1e-5F * extent_of(polygon);
    FlatPolygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::vec3& before = kept.empty() ? polygon.back() : kept.back();
        const glm::vec3 side = polygon[(i + 1) % polygon.size()] - before;
        const glm::vec3 across = glm::cross(polygon[i] - before, side);
        if (glm::length(across) > nearest * glm::length(side)) kept.push_back(polygon[i]);
    }
    return kept;
}

// So narrow that rounding decides whether it is there.
bool is_sliver(const FlatPolygon& polygon)
{
    glm::vec3 twice_area(0);
    for (std::size_t i = 2; i < polygon.size(); ++i)
        twice_area += glm::cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
    const float extent = extent_of(polygon);
    return glm::length(twice_area) < 2e-4F * extent * extent;
}

void append_corners(Recorder& out, std::string_view name, float first, float second, FlatPolygon polygon)
{
    polygon.resize(std::min<std::size_t>(polygon.size(), 40));
    polygon = from_extreme(polygon);
    for (std::size_t i = 0; i < polygon.size(); ++i)
        out.append(name, std::span<const float>(std::array{first, second, static_cast<float>(i), polygon[i].x,
                                                           polygon[i].y, polygon[i].z}));
}

FlatPolygon asked(Recorder& out, const ShadowTask& task)
{
    const auto& [light, caster, receiver, unit] = task;
    return times(ask<shadow_polygon>(out, times(light, unit), times(caster, unit), times(receiver, unit)), 1 / unit);
}

std::vector<MirrorView> asked(Recorder& out, const MirrorTask& task)
{
    std::vector<FlatPolygon> mirrors;
    for (const FlatPolygon& mirror : task.mirrors) mirrors.push_back(times(mirror, task.unit));
    std::vector<MirrorView> views = ask<mirror_views>(out, task.unit * task.eye, mirrors, task.levels);
    views.resize(std::min<std::size_t>(views.size(), 60));
    for (MirrorView& view : views) {
        view.eye /= task.unit;
        view.window = times(std::move(view.window), 1 / task.unit);
    }
    return views;
}

// Turned by quarters of a turn, which round nothing, if inputs are to vary.
FlatPolygon turned(const ExactMap& map, FlatPolygon polygon)
{
    for (glm::vec3& corner : polygon) corner = map.place(corner);
    return polygon;
}

std::vector<ShadowTask> turned(Variation& vary, std::vector<ShadowTask> tasks)
{
    for (auto& [light, caster, receiver, unit] : tasks) {
        const ExactMap map = vary.exact_map(0);
        light = map.place(light);
        caster = turned(map, caster);
        receiver = turned(map, receiver);
    }
    return tasks;
}

std::vector<MirrorTask> turned(Variation& vary, std::vector<MirrorTask> tasks)
{
    for (MirrorTask& task : tasks) {
        const ExactMap map = vary.exact_map(0);
        task.eye = map.place(task.eye);
        for (FlatPolygon& mirror : task.mirrors) mirror = turned(map, mirror);
    }
    return tasks;
}

// The same ones again, very small and very large.
template <class Task>
std::vector<Task> in_all_sizes(std::vector<Task> tasks)
{
    for (std::size_t i = 0, count = tasks.size(); i < count; ++i) {
        tasks.push_back(tasks[i]);
        tasks.back().unit = i % 2 == 0 ? 0x1p-16F : 0x1p16F;
    }
    return tasks;
}

// Rows [task, 0, corner, x, y, z].
void record_shadows(Recorder& out, const std::vector<ShadowTask>& tasks)
{
    out.text("corners.names", "shadow: -, corner");
    for (std::size_t i = 0; i < tasks.size(); ++i)
        append_corners(out, "corners", static_cast<float>(i), 0, asked(out, tasks[i]));
}

// A path as one number: the digits of its mirrors, from 1 on.
float path_number(const std::vector<std::size_t>& path)
{
    float number = 0;
    for (std::size_t i = 0; i < std::min<std::size_t>(path.size(), 6); ++i)
        number = 10 * number + static_cast<float>(path[i] % 9 + 1);
    return number;
}

// Rows [1, task, path, eye], in the order of the list, and [task, path, corner, x, y, z].
// In a hall of many mirrors windows end beside others' edges, or nearly.
void record_views(Recorder& out, const std::vector<MirrorTask>& tasks, bool leaves_slivers = false)
{
    out.text("eyes.names", "1 a path: task, path, eye/3");
    out.text("windows.names", "task: path, corner");
    for (std::size_t i = 0; i < tasks.size(); ++i) {
        const std::vector<MirrorView> views = asked(out, tasks[i]);
        const auto task = static_cast<float>(i);
        for (const MirrorView& view : views) {
            if (leaves_slivers && is_sliver(view.window)) continue;
            const float path = path_number(view.path);
            out.append("eyes",
                       std::span<const float>(std::array{1.0F, task, path, view.eye.x, view.eye.y, view.eye.z}));
            append_corners(out, "windows", task, path,
                           leaves_slivers ? without_flat_corners(view.window) : view.window);
        }
    }
}

std::vector<ShadowTask> random_shadows(Random& random)
{
    std::vector<ShadowTask> tasks;
    for (int i = 0; i < 150; ++i) tasks.push_back(random_shadow(random, i));
    return tasks;
}

std::vector<ShadowTask> far_shadows(Random& random)
{
    std::vector<ShadowTask> tasks;
    for (int i = 0; i < 80; ++i) tasks.push_back(far_shadow(random));
    return tasks;
}

std::vector<MirrorTask> random_halls(Random& random)
{
    std::vector<MirrorTask> tasks;
    for (int i = 0; i < 30; ++i) tasks.push_back(random_mirrors(random, 2 + random.below(3), 1 + i % 4));
    return tasks;
}

// The normal is not so short that little is left of the plane's distance.
bool is_plane(const glm::vec4& plane) { return glm::length(glm::vec3(plane)) > 0.1F * std::abs(plane.w); }

void record_matrices(Case& what, Recorder& out)
{
    const std::vector<glm::vec4> by_hand = {{0, 1, 0, 0}, {0, 0, 2, -6}, {-1, 0, 0, 4}, {3, 4, 0, 10}, {1, 1, 1, -3}};
    for (const glm::vec4& plane : by_hand) out.append("mirrors", ask<mirror_matrix>(out, plane));
    for (int i = 0; i < 60; ++i) {
        const glm::vec4 plane(random_plane(what.random, i));
        out.append("mirrors", ask<mirror_matrix>(out, plane));
    }
    for (int i = 0; i < 60; ++i) {
        const glm::vec4 plane(random_plane(what.random, i));
        const glm::vec3 from = 4.0F * what.random.in_cube();
        const glm::mat4 view = glm::lookAt(from, from + what.random.unit_vector(), glm::vec3(0.1F, 1, 0.2F));
        out.append("views", ask<mirrored_view>(out, view, plane));
        if (i % 4 != 0) continue;
        // The same view in other planes, of which some are level or upright, and another view in the last one.
        glm::vec4 last = plane;
        for (const glm::vec4& changed : numbers_changed(what.random, plane, 3, is_plane)) {
            out.append("mirrors", ask<mirror_matrix>(out, changed));
            out.append("views", ask<mirrored_view>(out, view, changed));
            last = changed;
        }
        const glm::mat4 beside = glm::translate(view, glm::vec3(what.random.uniform(1, 2), 0, 0));
        out.append("views", ask<mirrored_view>(out, beside, last));
    }
}

}

const Driver driver = {
    {"by hand", [](Case& c, Recorder& out) { record_shadows(out, in_all_sizes(turned(c.vary, shadows_by_hand()))); }},
    {"without", [](Case& c, Recorder& out) { record_shadows(out, in_all_sizes(turned(c.vary, without_shadow()))); }},
    {"random", [](Case& c, Recorder& out) { record_shadows(out, random_shadows(c.random)); }},
    {"far", [](Case& c, Recorder& out) { record_shadows(out, far_shadows(c.random)); }},
    {"matrices", record_matrices},
    {"two mirrors", [](Case& c, Recorder& out) { record_views(out, in_all_sizes(turned(c.vary, mirrors_by_hand()))); }},
    {"halls", [](Case& c, Recorder& out) { record_views(out, random_halls(c.random), true); }},
    {"gallery", [](Case& c, Recorder& out) { out.image("colours", gallery_picture(c.vary, out, 400, 300)); }},
};

}
