#include <fstream>
#include <iterator>
#include <kit/color.hpp>
#include <optional>

#include "fixture.hpp"
#include "raytracing/fragment-shader/scenes.hpp"

// The unit raytracing/fragment-shader: its ray tracer against a recursive one in double, and its march against the
// digits of the sponge's points.
namespace umbral::raytracing {
namespace {

Case reference()
{
    Case what{"test", Random(1), {}};
    for (const char* name : {"ray_tracer.frag", "distance_field.frag"}) {
        std::ifstream file(std::string(UMBRAL_FRAGMENT_SHADER_REFERENCE "/") + name);
        EXPECT_TRUE(file) << name;
        what.sources[name] = {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    }
    return what;
}

struct Met {
    double t = 1e30;
    glm::dvec3 normal{0};
    glm::dvec3 color{0};
    double mirror = 0;
};

std::optional<Met> first_met(const BallScene& scene, const glm::dvec3& o, const glm::dvec3& u)
{
    Met met;
    const double to_floor = -o.y / u.y;
    const glm::dvec3 on_floor = o + to_floor * u;
    if (to_floor > 1e-3 && std::hypot(on_floor.x, on_floor.z) < double{scene.floor_radius}) {
        const auto odd = static_cast<std::size_t>(
            (static_cast<long>(std::floor(on_floor.x)) + static_cast<long>(std::floor(on_floor.z))) & 1);
        met = {to_floor, {0, 1, 0}, glm::dvec3(scene.tiles[odd]), double{scene.floor_mirror}};
    }
    for (const TracedBall& ball : scene.balls) {
        const glm::dvec3 centre(ball.sphere);
        const double radius = ball.sphere.w;
        const double b = dot(o - centre, u);
        const double discriminant = b * b - dot(o - centre, o - centre) + radius * radius;
        const double t = -b - std::sqrt(discriminant);
        if (!(t > 1e-3 && t < met.t)) continue;
        met = {t, (o + t * u - centre) / radius, glm::dvec3(ball.color), double{ball.mirror}};
    }
    if (met.t > 1e29) return std::nullopt;
    return met;
}

glm::dvec3 radiance(const BallScene& scene, const glm::dvec3& o, const glm::dvec3& u, int levels)
{
    if (levels == 0) return glm::dvec3(0);
    const std::optional<Met> met = first_met(scene, o, u);
    if (!met) return mix(glm::dvec3(scene.look.horizon), glm::dvec3(scene.look.zenith), std::max(0.0, u.y));
    const glm::dvec3 p = o + met->t * u;
    const glm::dvec3 to_light = glm::dvec3(scene.light_position) - p;
    const std::optional<Met> between = first_met(scene, p, normalize(to_light));
    const bool lit = !between || between->t > length(to_light);
    const double cosine = std::max(0.0, dot(met->normal, normalize(to_light)));
    const glm::dvec3 local = glm::dvec3(scene.look.ambient) + (lit ? cosine : 0.0) * glm::dvec3(scene.light_color);
    return met->color * local + met->mirror * radiance(scene, p, u - 2 * dot(u, met->normal) * met->normal, levels - 1);
}

template <class Scene>
glm::dvec3 direction_of(const OneRay<Scene>& ray)
{
    const double half = ray.scene.look.half_height;
    return normalize(glm::dmat3(axes_of(ray.scene.look)) *
                     glm::dvec3(half * double{ray.place.x}, half * double{ray.place.y}, -1));
}

using FragmentShader = gl::GlTest;

// But for a few rays in a hundred, which pass a border of light or of a tile by less than float can tell.
TEST_F(FragmentShader, rays_see_what_recursion_in_double_sees)
{
    const auto program = compile_ray_tracer(reference());
    int wrong = 0;
    int all = 0;
    for (const std::uint64_t seed : {8101U, 8102U, 8103U, 8104U}) {
        Random random(seed);
        const std::vector<OneRay<BallScene>> rays = random_ball_rays(random, 250);
        const std::vector<glm::vec3> colors = colors_of_rays(*program, rays);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const BallScene& scene = rays[i].scene;
            const glm::dvec3 expected =
                srgb_encoded(radiance(scene, glm::dvec3(scene.look.eye), direction_of(rays[i]), scene.levels));
            const glm::dvec3 off = abs(glm::dvec3(colors[i]) - expected);
            wrong += std::max({off.x, off.y, off.z}) > 0.01 ? 1 : 0;
            ++all;
        }
    }
    EXPECT_LE(wrong, all / 100);
}

// Whether a point lies in the sponge: in no step do two of its coordinates lie in the middle third.
bool in_sponge(glm::dvec3 p, int depth)
{
    p = (p + 1.0) / 2.0;
    for (int i = 0; i < 3; ++i)
        if (p[i] < 0 || p[i] > 1) return false;
    for (int step = 0; step < depth; ++step) {
        p *= 3.0;
        int middle = 0;
        for (int i = 0; i < 3; ++i) {
            const double digit = std::min(2.0, std::floor(p[i]));
            middle += digit == 1 ? 1 : 0;
            p[i] -= digit;
        }
        if (middle >= 2) return false;
    }
    return true;
}

// Walked in steps of a thousandth: who meets the sponge, who what the ball left, who nothing.
TEST_F(FragmentShader, marches_meet_the_sponge_where_its_digits_say)
{
    const auto program = compile_distance_field(reference());
    Random random(8201);
    std::vector<OneRay<SpongeScene>> rays = random_sponge_rays(random, 400);
    for (OneRay<SpongeScene>& ray : rays) {
        ray.scene.look.ambient = glm::vec3(1);
        ray.scene.look.horizon = ray.scene.look.zenith = glm::vec3(0, 0, 1);
        ray.scene.sponge_color = {1, 0, 0};
        ray.scene.ball_color = {0, 1, 0};
        ray.scene.sun_color = glm::vec3(0);
    }
    const std::vector<glm::vec3> colors = colors_of_rays(*program, rays);
    int wrong = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const SpongeScene& scene = rays[i].scene;
        const glm::dvec3 o(scene.look.eye);
        const glm::dvec3 u = direction_of(rays[i]);
        const glm::dvec3 centre(scene.ball);
        glm::vec3 expected(0, 0, 1);
        bool before_in_ball = false;
        for (double t = 0; t < 30; t += 0.001) {
            const glm::dvec3 p = o + t * u;
            const bool in_ball = distance(p, centre) < double{scene.ball.w};
            if (!in_ball && in_sponge(p, scene.depth)) {
                expected = before_in_ball ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
                break;
            }
            before_in_ball = in_ball;
        }
        wrong += colors[i] == expected ? 0 : 1;
    }
    EXPECT_LE(wrong, 4);
}

}
}
