#pragma once

#include <kit/numbers_changed.hpp>
#include <umbral/record/variation.hpp>

#include "scenes.hpp"

/// What the unit is asked beside its pictures.
namespace umbral::raytracing {

struct LensQuestion {
    LensCamera camera;
    PictureSize size;
    glm::vec2 place;
    glm::vec2 lens;
};

/// Cameras along the axes, and places and points of the lens with few digits.
inline std::vector<LensQuestion> lenses_by_hand(Variation& vary)
{
    const ExactMap map = vary.exact_map(0);
    const LensCamera front{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0.5F, 0.5F, 4, 0, 0};
    LensCamera pinhole = front;
    pinhole.lens_radius = 0;
    const LensCamera down{{1, 5, 2}, {1, 0, 0}, {0, 0, -1}, {0, 1, 0}, 1, 0.25F, 2, 0, 0};
    const LensCamera aside{{-3, 1, 0}, {0, 0, -1}, {0, 1, 0}, {1, 0, 0}, 0.25F, 0.125F, 8, 0, 0};
    const PictureSize square{100, 100};
    const PictureSize wide{200, 100};
    const PictureSize tall{60, 80};
    std::vector<LensQuestion> questions{{front, square, {50, 50}, {0, 0}},      {front, square, {50, 50}, {1, 0}},
                                        {front, square, {50, 50}, {0, -1}},     {front, square, {100, 50}, {0, 0}},
                                        {front, square, {0, 0}, {0.5F, 0.5F}},  {front, wide, {200, 50}, {0, 0}},
                                        {front, wide, {50, 75}, {-0.5F, 0}},    {front, tall, {30, 0}, {0, 1}},
                                        {front, tall, {60, 60}, {0.6F, -0.8F}}, {pinhole, square, {25, 75}, {1, 0}},
                                        {down, square, {50, 0}, {0, 1}},        {down, wide, {0, 100}, {0.5F, 0.5F}},
                                        {aside, tall, {60, 40}, {-1, 0}},       {aside, square, {10, 20}, {0, 0.5F}}};
    for (auto& [camera, size, place, lens] : questions)
        for (glm::vec3* vector : {&camera.eye, &camera.right, &camera.up, &camera.back}) *vector = map.place(*vector);
    return questions;
}

inline std::vector<LensQuestion> random_lenses(Random& random, int count)
{
    std::vector<LensQuestion> questions;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 eye = 4.0F * random.in_cube();
        glm::vec3 view = random.unit_vector();
        view.y *= 0.7F;
        const float half = random.uniform(0.2F, 1);
        const float focus = random.uniform(1, 10);
        LensCamera camera = camera_towards(eye, eye - view, half, {random.uniform(0, 0.5F), focus, 0, 1});
        // Every other one is rolled about its view: its right side need not be level, nor its up point upwards.
        if (i % 2 == 1) {
            const float roll = random.uniform(0, 6.28F);
            const glm::vec3 right = std::cos(roll) * camera.right + std::sin(roll) * camera.up;
            camera.up = std::cos(roll) * camera.up - std::sin(roll) * camera.right;
            camera.right = right;
        }
        const PictureSize size{20 + static_cast<int>(random.below(400)), 20 + static_cast<int>(random.below(300))};
        const float x = random.uniform(0, static_cast<float>(size.width));
        const glm::vec2 place(x, random.uniform(0, static_cast<float>(size.height)));
        const float angle = random.uniform(0, 6.28F);
        questions.push_back({camera, size, place, random.uniform() * glm::vec2(std::cos(angle), std::sin(angle))});
    }
    return questions;
}

/// From a random question others, each with one number or size changed: eyes and places with a coordinate of 0, the
/// focus nearer than 1, the same camera with another lens, the same place in another picture, which is 1 wide at last.
inline std::vector<LensQuestion> changed_lenses(Random& random, const LensQuestion& question)
{
    const LensCamera& camera = question.camera;
    std::vector<LensQuestion> all = numbers_changed(random, question, 8, [&](const LensQuestion& changed) {
        const LensCamera& other = changed.camera;
        return other.right == camera.right && other.up == camera.up && other.back == camera.back &&
               other.half_height > 0 && other.focus_depth > 0.5F && other.shutter_closes >= other.shutter_opens &&
               changed.place.x < static_cast<float>(changed.size.width) &&
               changed.place.y < static_cast<float>(changed.size.height) && length(changed.lens) < 1;
    });
    LensQuestion resized = all.back();
    const auto other_size = [&] {
        resized.place = min(resized.place, glm::vec2(resized.size.width, resized.size.height));
        all.push_back(resized);
    };
    resized.size.width += 1 + static_cast<int>(random.below(200));
    other_size();
    resized.size.height += 1 + static_cast<int>(random.below(200));
    other_size();
    (random.below(2) == 0 ? resized.size.width : resized.size.height) = 1;
    other_size();
    return all;
}

/// Shares and moments of points of the disc, for their means; `next` is the one that is drawn after it.
inline std::array<float, 12> disc_values(const glm::vec2& point, const glm::vec2& next)
{
    const float square = dot(point, point);
    return {point.x, point.y, point.x * point.x, point.y * point.y, point.x * point.y, square > 0.5F ? 1.0F : 0.0F,
            point.x * square, point.x > 0 && point.y > 0 ? 1.0F : 0.0F,
            // Beyond the rim by more than roundings.
            square > 1.0001F ? 1.0F : 0.0F,
            // Of independent points these are 0 in the mean.
            point.x * next.x, point.y * next.y, (square - 0.5F) * (dot(next, next) - 0.5F)};
}

inline std::vector<std::string> disc_names()
{
    return {"x",
            "y",
            "The square of x",
            "The square of y",
            "x times y",
            "The share of points in the outer half of the area",
            "x times the squared radius",
            "The share of points with positive x and y",
            "The share of points beyond the rim",
            "The product of two successive x",
            "The product of two successive y",
            "The product of two successive squared radii, less their means"};
}

/// A question about the light of a lamp, at a time.
struct PenumbraQuestion {
    std::string name;
    LitPoint at;
    AreaLamp lamp;
    float time;
    int samples = 12;
};

/// A lamp over a table, with a screen that covers half of the view, a ball that flies by, and points all over: fully
/// lit, in the penumbra, in the dark, tilted, near, far, behind the lamp. A scrap of paper lies on a surface between
/// table and lamp, so close to it that what it hides depends on which end of the segment is the surface. All is
/// stretched along the axes: what is hidden stays hidden.
inline StillLife penumbra_scene(const glm::vec3& stretch = glm::vec3(1))
{
    StillLife life;
    constexpr glm::vec3 light(2, 0.5F, 3);  // takes no part
    life.add(SolidQuad{stretch * glm::vec3(-2, 0.5F, -2), stretch * glm::vec3(2, 0, 0), stretch * glm::vec3(0, 0, 4)},
             Paint{glm::vec3(0.5F)});
    life.add(SolidBall{stretch * glm::vec3(1.5F, 0.6F, -2), 0.35F, stretch * glm::vec3(0, 0, 2)},
             Paint{glm::vec3(0.5F)});
    life.add(SolidQuad{stretch * glm::vec3(0.248F, 1.0004F, -0.001F), stretch * glm::vec3(0, 0, 0.002F),
                       stretch * glm::vec3(0.00184F, 0, 0)},
             Paint{glm::vec3(0.5F)});
    life.add_lamp({stretch * glm::vec3(-0.5F, 2, -0.75F),
                   stretch * glm::vec3(1, 0, 0),
                   stretch * glm::vec3(0, 0, 1.5F),
                   {1, 1, 1}});
    life.add_lamp(
        {stretch * glm::vec3(5, 1, -1), stretch * glm::vec3(0, 0, 2), stretch * glm::vec3(0, 2, 0), {1, 1, 1}});
    // Far from being a rectangle.
    life.add_lamp({stretch * glm::vec3(2.5F, 1.5F, 2.5F), stretch * glm::vec3(1.2F, 0, 0),
                   stretch * glm::vec3(0.8F, 0, 0.7F), light});
    // Along no axis.
    life.add_lamp({stretch * glm::vec3(-4, 1, 3), stretch * glm::vec3(0.6F, 0.5F, 0.2F),
                   stretch * glm::vec3(-0.3F, 0.4F, 0.9F), light});
    return life;
}

/// How much, if inputs are to vary: by so much along two axes that the light is hardly ever nearly the same twice.
inline glm::vec3 varied_stretch(Variation& vary) { return {vary.scaled(1.0F, 1.6F), vary.scaled(1.0F, 1.4F), 1}; }

inline std::vector<PenumbraQuestion> penumbra_questions(const glm::vec3& stretch = glm::vec3(1))
{
    const StillLife life = penumbra_scene(stretch);
    const AreaLamp over = life.lamps()[0];
    const AreaLamp aside = life.lamps()[1];
    const AreaLamp slanted = life.lamps()[2];
    const AreaLamp askew = life.lamps()[3];
    const auto at = [&](glm::vec3 position, glm::vec3 normal) {
        return LitPoint{stretch * position, normalize(normal), glm::vec3(0.25F, 0.5F, 0.75F), glm::vec3(3)};
    };
    constexpr glm::vec3 up(0, 1, 0);
    return {{"The light beside the screen", at({0.75F, 0, 0.25F}, up), over, 0},
            {"The light at the outer end of the penumbra", at({0.1F, 0, 0}, up), over, 0},
            {"The light in the middle of the penumbra", at({0, 0, 0}, up), over, 0},
            {"The light at the inner end of the penumbra", at({-0.1F, 0, 0.5F}, up), over, 0},
            {"The light in the shadow", at({-1, 0, 0}, up), over, 0},
            {"The light on a tilted surface", at({1.25F, 0.5F, 1}, {-1, 1, -1}), over, 0},
            {"The light on a wall beside the lamp", at({1, 1.5F, 0.25F}, {-1, 0, 0}), over, 0},
            {"The light near the lamp", at({0.25F, 1.6F, 0.1F}, up), over, 0, 64},
            {"The light behind the lamp", at({0, 3, 0}, {0, -1, 0}), over, 0},
            {"The light behind the lamp on what faces away", at({0, 3, 0}, up), over, 0},
            {"The light from the side", at({2.5F, 0, -0.5F}, up), aside, 0.25F},
            {"The light before the ball has come", at({1.9F, 0, 0.1F}, up), over, 0},
            {"The light while the ball is there", at({1.9F, 0, 0.1F}, up), over, 1},
            {"The light on a surface whose horizon cuts the lamp", at({0.2F, 0.75F, 0.2F}, {1, 0, 0}), over, 0},
            {"The light of a slanted lamp", at({3.5F, 0, 3}, up), slanted, 0.5F},
            {"The light at the edge of a scrap of paper", at({0.25F, 1, 0}, up), over, 0},
            {"The light at another edge of it", at({0.249F, 1, 0.00112F}, up), over, 0},
            {"The light at the outer end of the penumbra, by one sample", at({0.1F, 0, 0}, up), over, 0, 1},
            {"The light at the inner end of the penumbra, by one sample", at({-0.1F, 0, 0.5F}, up), over, 0, 1},
            {"The light of a lamp along no axis", at({-3.8F, 0, 3.6F}, up), askew, 0.5F},
            {"The light of another lamp at the same place", at({-3.8F, 0, 3.6F}, up), over, 0.5F}};
}

}
