// Prints how many points each way to leave a surface gets wrong: the table in the statement of raytracing/shadows.
// Usage: shadows-accuracy [SEED [PAIRS]]

#include <array>
#include <bit>
#include <cstdio>
#include <cstdlib>
#include <raytracing/shadows/scenes.hpp>

using namespace umbral;
using namespace umbral::raytracing;

namespace {

using Lift = glm::vec3 (*)(const ShadedPoint&);

glm::vec3 nowhere(const ShadedPoint& point) { return point.position; }
glm::vec3 by_a_thousandth(const ShadedPoint& point) { return point.position + 1e-3F * point.normal; }

/// C. Wächter, N. Binder. A Fast and Robust Method for Avoiding Self-Intersection. Ray Tracing Gems, chapter 6, 2019.
glm::vec3 by_integers(const ShadedPoint& point)
{
    glm::vec3 origin;
    for (int i = 0; i < 3; ++i) {
        const float p = point.position[i];
        const auto steps = static_cast<int>(256 * point.normal[i]);
        const float moved = std::bit_cast<float>(std::bit_cast<int>(p) + (p < 0 ? -steps : steps));
        origin[i] = std::abs(p) < 1.0F / 32 ? p + point.normal[i] / 65536 : moved;
    }
    return origin;
}

bool sees(Lift lift, const LightQuestion& question)
{
    const glm::vec3 origin = lift(question.point);
    const bool is_sun = question.light.w == 0;
    const glm::vec3 direction = is_sun ? glm::vec3(question.light) : glm::vec3(question.light) - origin;
    if (!(dot(question.point.normal, direction) > 0)) return false;
    return !meets_any(question.casters, Ray{origin, direction, 0, is_sun ? endless : 1});
}

}

int main(int count, char** arguments)
{
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    const int pairs = count > 2 ? std::atoi(arguments[2]) : 2000;
    Random random(seed);
    std::printf("seed %llu, %d pairs a column: wrong pairs in %%\n", static_cast<unsigned long long>(seed), pairs);
    std::printf("%-16s%10s%10s%10s%10s%10s%10s%10s\n", "", "size 1e-4", "1e-2", "1", "1e4", "1e7 away", "contact",
                "contact*");
    const std::array<std::vector<LightQuestion>, 7> columns = {
        light_pairs(random, 1e-4, 4e-4, pairs), light_pairs(random, 1e-2, 4e-2, pairs),
        light_pairs(random, 1, 4, pairs),       light_pairs(random, 1e4, 4e4, pairs),
        light_pairs(random, 1e4, 1e7, pairs),   contact_pairs(random, 1, 4, pairs),
        contact_pairs(random, 1e4, 1e7, pairs)};
    const auto print = [&](const char* name, const auto& is_seen) {
        std::printf("%-16s", name);
        for (const std::vector<LightQuestion>& questions : columns) {
            int wrong = 0;
            for (std::size_t i = 0; i < questions.size(); i += 2)
                wrong += is_seen(questions[i]) == is_seen(questions[i + 1]) ? 1 : 0;
            std::printf("%10.1f", 100.0 * wrong / pairs);
        }
        std::printf("\n");
    };
    for (const auto& [name, lift] :
         {std::pair<const char*, Lift>{"not at all", nowhere}, {"0.001", by_a_thousandth}, {"integers", by_integers}})
        print(name, [lift = lift](const LightQuestion& question) { return sees(lift, question); });
    print("reference", [](const LightQuestion& q) { return sees_light(q.point, q.light, q.casters); });
}
