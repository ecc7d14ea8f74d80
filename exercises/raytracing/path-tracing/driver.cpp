#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "../cast.hpp"
#include "../estimates.hpp"
#include "../rays.hpp"
#include "extremes.hpp"
#include "furnaces.hpp"

namespace umbral {
namespace {

using namespace raytracing;

/// Reports call a scene by its name.
void introduce(Recorder& out, const DiffuseScene& room, const char* name)
{
    if (Questions* const questions = out.questions()) questions->set_object(&room, name, "");
}

void record_densities(Recorder& out, const std::vector<LampView>& views)
{
    for (const LampView& view : views) out.append("lamp", ask<lamp_density>(out, view.point, view.lamp, view.on_lamp));
}

void record_by_hand(Variation& vary, Recorder& out)
{
    for (const auto& [normal, direction] : cosines_by_hand(vary))
        out.append("cosine", ask<cosine_density>(out, normal, direction));
    record_densities(out, lamps_by_hand(vary));
}

void record_random(Random& random, Recorder& out)
{
    for (int i = 0; i < 300; ++i) {
        const glm::vec3 normal = random.unit_vector();
        out.append("cosine", ask<cosine_density>(out, normal, random.unit_vector()));
    }
    for (const auto& [normal, direction] : cosines_changed(random))
        out.append("cosine", ask<cosine_density>(out, normal, direction));
    record_densities(out, random_lamps(random, 300));
    for (const LampView& view : random_lamps(random, 20)) record_densities(out, changed_views(random, view));
}

// Where no reflection takes part, all estimates are the same: what shines there, or the sky.
void record_seen(Case& c, Recorder& out)
{
    const DiffuseRoom open = open_room().varied(c.vary);
    introduce(out, open, "open_room");
    const DiffuseRoom black = black_room().varied(c.vary);
    introduce(out, black, "black_room");
    for (const SeenRay& seen : seen_rays(c.random)) {
        const DiffuseRoom& room = seen.black ? black : open;
        Random own = own_random(c.random);
        out.append("light", ask<path_light>(out, room, seen.ray, seen.bounces, seen.samples, own));
    }
}

// Moments of directions along the normal n and two vectors x and y across it, and shares of cones round it.
void record_directions(Case& c, Recorder& out)
{
    const std::vector<glm::vec3> normals = normals_of_directions(c.vary);
    for (int replicate = 0; replicate < 300; ++replicate) {
        std::vector<float> row;
        for (const glm::vec3& normal : normals) {
            Random own = own_random(c.random);
            DirectionMoments moments(normal);
            for (int i = 0; i < 64; ++i) moments.add(ask<cosine_direction>(out, normal, own));
            moments.append_to(row);
        }
        out.append("moments", row);
    }
    out.text("moments.names", names_of_moments(normals.size()));
}

/// A row of estimates for each replicate: three colours for each question.
void record_views(Random& random, Recorder& out, const std::vector<RoomView>& views, int replicates)
{
    for (const RoomView& view : views) introduce(out, view.room, view.name);
    DiffuseRoom shown;
    for (int replicate = 0; replicate < replicates; ++replicate) {
        std::vector<float> row;
        for (const RoomView& view : views) {
            Random own = own_random(random);
            if (view.takes_turns) {
                shown = view.room;
                introduce(out, shown, view.name);
            }
            const DiffuseRoom& room = view.takes_turns ? shown : view.room;
            const glm::vec3 light = ask<path_light>(out, room, view.ray, view.bounces, view.samples, own);
            row.insert(row.end(), {light.r, light.g, light.b});
        }
        out.append("light", row);
    }
    out.text("light.names", names_of_views(views));
}

/// The mean of each pixel's estimates through four places in it: edges without steps.
Grid<glm::vec3> rendered(Random& random, Recorder& out, const DiffuseRoom& room, const Camera& camera, int size,
                         int bounces, int samples)
{
    Grid<glm::vec3> picture(size, size, glm::vec3(0));
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            Random own = own_random(random);
            for (int place = 0; place < 4; ++place) {
                const float right = static_cast<float>(place % 2) + own.uniform();
                const float down = static_cast<float>(place / 2) + own.uniform();
                const Ray ray = camera_ray(camera, size, size, glm::vec2(x, y) + 0.5F * glm::vec2(right, down));
                picture.at(x, y) += 0.25F * ask<path_light>(out, room, ray, bounces, samples / 4, own);
            }
        }
    return picture;
}

// The same numbers give the same answer; many samples give their mean, not one of them; and "far" is 1 where any light
// is found: however paths end, some are so long that they find the one that only they can.
void record_promises(Case& c, Recorder& out)
{
    for (const RoomView& view : promised_views()) {
        introduce(out, view.room, view.name);
        record_estimate(out, c.random, [&](int samples, Random& own) {
            return ask<path_light>(out, view.room, view.ray, view.bounces, samples, own).g;
        });
    }
    for (const CorridorQuestion& question : corridors(c)) {
        introduce(out, question.corridor, question.name);
        Random own = own_random(c.random);
        const glm::vec3 light =
            ask<path_light>(out, question.corridor, Corridor::entrance(), question.bounces, question.samples, own);
        out.append("far", light.r + light.g + light.b > 0 ? 1.0F : 0.0F);
    }
}

void record_secret(Random& random, Recorder& out)
{
    for (const auto& [name, bounces] : {std::pair{"two bounces", 2}, {"all bounces", all_bounces}}) {
        const DiffuseRoom room = random_room(random);
        introduce(out, room, "random_room");
        const Camera camera{{random.uniform(-0.4F, 0.4F), random.uniform(0.6F, 1.4F), 3.4F}, {0, 1, 0}, 0.47F};
        out.image(name, rendered(random, out, room, camera, 64, bounces, 16));
    }
}

void record_picture(Case& c, Recorder& out, int size, int samples)
{
    const DiffuseRoom room = cornell_room().varied(c.vary);
    introduce(out, room, "cornell_room");
    const Camera camera{{0, 1, 3.9F}, {0, 1, 0}, 0.33F};
    out.image("box", rendered(c.random, out, room, camera, size, all_bounces, samples));
}

}

const Driver driver = {
    {"by hand", [](Case& c, Recorder& out) { record_by_hand(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { record_random(c.random, out); }},
    {"seen", [](Case& c, Recorder& out) { record_seen(c, out); }},
    {"directions", [](Case& c, Recorder& out) { record_directions(c, out); }},
    {"one bounce", [](Case& c, Recorder& out) { record_views(c.random, out, varied(c.vary, one_bounce()), 256); }},
    {"furnace", [](Case& c, Recorder& out) { record_views(c.random, out, varied(c.vary, furnaces()), 256); }},
    {"long paths", [](Case& c, Recorder& out) { record_views(c.random, out, long_paths(c.vary), 256); }},
    {"near and dark",
     [](Case& c, Recorder& out) { record_views(c.random, out, varied(c.vary, near_and_dark()), 256); }},
    {"switched lamps",
     [](Case& c, Recorder& out) { record_views(c.random, out, varied(c.vary, switched_lamps()), 256); }},
    {"promises", [](Case& c, Recorder& out) { record_promises(c, out); }},
    {"secret", [](Case& c, Recorder& out) { record_secret(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { record_picture(c, out, 96, 16); }},
    {"goal", [](Case& c, Recorder& out) { record_picture(c, out, 240, 64); }},
};

}
