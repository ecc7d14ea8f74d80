#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "../estimates.hpp"
#include "pixels.hpp"
#include "questions.hpp"

namespace umbral {
namespace {

using namespace raytracing;

void introduce(Recorder& out, const StillLife& scene, const char* name)
{
    if (Questions* const questions = out.questions()) questions->set_object(&scene, name, "");
}

void record_lenses(Recorder& out, const std::vector<LensQuestion>& lenses)
{
    for (const auto& [camera, size, place, lens] : lenses) {
        const Ray ray = ask<lens_ray>(out, camera, size, place, lens);
        // Where the ray begins, and its interval, whose end no number tells.
        out.append("origin", std::array{ray.origin.x, ray.origin.y, ray.origin.z, ray.t_min, 1 / ray.t_max});
        out.append("direction", ray.direction);
    }
    out.text("origin.names", numbered_names({"x", "y", "z", "t_min", "1 / t_max"}));
}

void record_random_lenses(Random& random, Recorder& out)
{
    std::vector<LensQuestion> lenses = random_lenses(random, 300);
    for (const LensQuestion& question : random_lenses(random, 30)) {
        const std::vector<LensQuestion> changed = changed_lenses(random, question);
        lenses.insert(lenses.end(), changed.begin(), changed.end());
    }
    record_lenses(out, lenses);
}

void record_disc(Random& random, Recorder& out)
{
    for (int replicate = 0; replicate < 500; ++replicate) {
        Random own = own_random(random);
        constexpr int points = 16;
        std::array<float, 12> row{};
        glm::vec2 point = ask<disc_point>(out, own);
        for (int i = 0; i < points; ++i) {
            const glm::vec2 next = ask<disc_point>(out, own);
            const std::array<float, 12> values = disc_values(point, next);
            for (std::size_t j = 0; j < row.size(); ++j) row[j] += values[j] / points;
            point = next;
        }
        out.append("moments", row);
    }
    out.text("moments.names", numbered_names(disc_names()));
}

void record_penumbra(Case& c, Recorder& out)
{
    const glm::vec3 stretch = varied_stretch(c.vary);
    const StillLife scene = penumbra_scene(stretch);
    introduce(out, scene, "penumbra_scene");
    const std::vector<PenumbraQuestion> questions = penumbra_questions(stretch);
    std::vector<std::string> names;
    for (const PenumbraQuestion& question : questions) names.push_back(question.name);
    for (int replicate = 0; replicate < 256; ++replicate) {
        std::vector<float> row;
        for (const PenumbraQuestion& question : questions) {
            Random own = own_random(c.random);
            row.push_back(
                ask<lamp_light>(out, scene, question.at, question.lamp, question.time, question.samples, own));
        }
        out.append("light", row);
    }
    out.text("light.names", numbered_names(names));
}

glm::vec3 asked_light(Recorder& out, const PixelQuestion& question, int samples, Random& random)
{
    Random own = own_random(random);
    return ask<pixel_light>(out, question.scene, question.camera, question.size, question.pixel, samples, own);
}

/// The questions with their scenes in other light, if inputs are to vary.
std::vector<PixelQuestion> varied(Variation& vary, std::vector<PixelQuestion> questions)
{
    for (PixelQuestion& question : questions) question.scene = question.scene.varied(vary);
    return questions;
}

void record_sharp(Case& c, Recorder& out)
{
    const std::vector<PixelQuestion> questions = varied(c.vary, sharp_pixels(c.random));
    for (const PixelQuestion& question : questions) introduce(out, question.scene, "panels");
    for (std::size_t i = 0; i < questions.size(); ++i)
        out.append("light", asked_light(out, questions[i], 1 + static_cast<int>(i % 5), c.random));
}

void record_means(Case& c, Recorder& out)
{
    const std::vector<PixelQuestion> questions = varied(c.vary, mean_pixels());
    std::vector<std::string> names;
    for (const PixelQuestion& question : questions) {
        introduce(out, question.scene, "scene");
        for (const char* colour : {"red", "green", "blue"})
            names.push_back(std::string("The ") + colour + " light of " + question.name);
    }
    for (int replicate = 0; replicate < 400; ++replicate) {
        std::vector<float> row;
        for (const PixelQuestion& question : questions) {
            const glm::vec3 light = asked_light(out, question, question.samples, c.random);
            row.insert(row.end(), {light.r, light.g, light.b});
        }
        out.append("light", row);
    }
    out.text("light.names", numbered_names(names));
}

// The same numbers give the same answer; and many samples give their mean, not one of them.
void record_promises(Random& random, Recorder& out)
{
    for (const PixelQuestion& question : promised_pixels()) {
        introduce(out, question.scene, "scene");
        record_estimate(out, random, [&](int samples, Random& own) {
            return ask<pixel_light>(out, question.scene, question.camera, question.size, question.pixel, samples, own)
                .r;
        });
    }
    const StillLife scene = penumbra_scene();
    introduce(out, scene, "penumbra_scene");
    const PenumbraQuestion lit = penumbra_questions().front();
    record_estimate(out, random, [&](int samples, Random& own) {
        return ask<lamp_light>(out, scene, lit.at, lit.lamp, lit.time, samples, own);
    });
}

void record_picture(Random& random, Recorder& out, const StillLife& scene, const LensCamera& camera, int side,
                    int samples)
{
    introduce(out, scene, "still_life");
    Grid<glm::vec3> picture(side, side, glm::vec3(0));
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            Random own = own_random(random);
            picture.at(x, y) =
                ask<pixel_light>(out, scene, camera, PictureSize{side, side}, glm::ivec2(x, y), samples, own);
        }
    out.image("still life", picture);
}

void record_secret(Random& random, Recorder& out)
{
    const StillLife scene = random_still_life(random);
    const LensCamera camera = random_still_life_camera(random);
    record_picture(random, out, scene, camera, 64, 16);
}

}

const Driver driver = {
    {"by hand", [](Case& c, Recorder& out) { record_lenses(out, lenses_by_hand(c.vary)); }},
    {"random", [](Case& c, Recorder& out) { record_random_lenses(c.random, out); }},
    {"disc", [](Case& c, Recorder& out) { record_disc(c.random, out); }},
    {"penumbra", [](Case& c, Recorder& out) { record_penumbra(c, out); }},
    {"sharp", [](Case& c, Recorder& out) { record_sharp(c, out); }},
    {"means", [](Case& c, Recorder& out) { record_means(c, out); }},
    {"promises", [](Case& c, Recorder& out) { record_promises(c.random, out); }},
    {"secret", [](Case& c, Recorder& out) { record_secret(c.random, out); }},
    {"picture",
     [](Case& c, Recorder& out) {
         record_picture(c.random, out, goal_still_life().varied(c.vary), goal_camera(), 96, 16);
     }},
    {"goal", [](Case& c, Recorder& out) { record_picture(c.random, out, goal_still_life(), goal_camera(), 240, 64); }},
};

}
