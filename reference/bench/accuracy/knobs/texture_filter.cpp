#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <umbral/core/random.hpp>
#include <umbral/texturing/mipmap.hpp>

#include "../samples.hpp"
#include "../study.hpp"

namespace umbral::bench {
namespace {

constexpr int size = 512;
constexpr int footprint = 32;  // texels along a pixel's side

using Texture = Grid<glm::vec4>;

/// The mean over a pixel whose lower left corner is uv, in double: whole texels, and parts of those on the border.
double exact_mean(const Texture& texture, const glm::dvec2& uv)
{
    const glm::dvec2 low = uv * double{size};
    double sum = 0;
    for (int y = static_cast<int>(low.y); y <= static_cast<int>(low.y) + footprint; ++y)
        for (int x = static_cast<int>(low.x); x <= static_cast<int>(low.x) + footprint; ++x) {
            const double wide = std::min(x + 1.0, low.x + footprint) - std::max(double(x), low.x);
            const double high = std::min(y + 1.0, low.y + footprint) - std::max(double(y), low.y);
            sum += wide * high * double{texture.at(x % size, size - 1 - y % size).x};
        }
    return sum / (footprint * footprint);
}

}

Knob measure_texture_filter(Means& means)
{
    using namespace texturing;
    constexpr std::uint64_t seed = 18;
    Random random(seed);
    const auto texture = std::make_shared<Texture>(size, size);
    for (glm::vec4& texel : texture->cells) texel = glm::vec4(random.uniform());
    const auto mipmap = std::make_shared<const Mipmap>(build_mipmap(*texture));
    std::vector<glm::dvec2> corners;
    for (int i = 0; i < (means.quick ? 500 : 5000); ++i) {
        const double u = random.uniform_double();
        corners.emplace_back(u, random.uniform_double());
    }
    Study study = study_of("texture-filter", "Minified textures: filters",
                           fmt::format("A texture of noise under pixels of {0} × {0} texels, in {1} random places, "
                                       "looked up by Umbral's references, against the exact mean; seed {2}.",
                                       footprint, corners.size(), seed),
                           "ns per pixel", {{"rms", "error of the colour, RMS", "of white"}});
    constexpr double side = double{footprint} / size;
    const auto add = [&](const std::string& name, const std::string& family, double amount, auto filter) {
        std::vector<double> errors;
        errors.reserve(corners.size());
        for (const glm::dvec2& corner : corners) errors.push_back(filter(corner) - exact_mean(*texture, corner));
        study.trials.push_back({name, family, amount, {{"rms", root_mean_square(errors)}}, 200, [corners, filter] {
                                    for (std::size_t i = 0; i < 200; ++i) keep(filter(corners[i]));
                                }});
    };
    const Sampler nearest{Filter::nearest, Wrap::repeat, Wrap::repeat};
    const Sampler bilinear{Filter::bilinear, Wrap::repeat, Wrap::repeat};
    for (const auto& [name, sampler] : {std::pair{"nearest", nearest}, std::pair{"bilinear", bilinear}})
        add(name, name, 0, [texture, sampler = sampler](const glm::dvec2& corner) {
            return double{lookup(*texture, sampler, glm::vec2(corner + side / 2)).x};
        });
    add("mipmap", "mipmap", 0, [mipmap](const glm::dvec2& corner) {
        return double{trilinear(*mipmap, glm::vec2(corner + side / 2), std::log2(float{footprint})).x};
    });
    for (const int count : {4, 16, 64, 256})
        add(fmt::format("{} samples", count), "samples", count,
            [texture, nearest, points = cells(count, nullptr)](const glm::dvec2& corner) {
                double sum = 0;
                for (const glm::dvec2& point : points)
                    sum += double{lookup(*texture, nearest, glm::vec2(corner + side * point)).x};
                return sum / static_cast<double>(points.size());
            });
    study.laws = {{"samples", "rms", "samples", -0.5,
                   "Texels of noise are independent, so a mean of N of them errs by 1/√N.",
                   "Of 1024 texels, 256 samples see a quarter: what is known no longer errs."}};
    return finish(std::move(study), means);
}

}
