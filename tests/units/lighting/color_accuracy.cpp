// Prints how far common substitutes for the sRGB curve are off, and what float loses: the tables in the statement of
// lighting/color. Usage: color-accuracy [SEED]

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <umbral/core/random.hpp>
#include <vector>

#include "../solution.hpp"
#include "color_functions.hpp"

using namespace umbral;
using namespace umbral::lighting;

namespace {

// Encodes the light of each code by another curve.
template <class Encode>
void print_codes(const char* name, const ColorFunctions& oracle, Encode encode)
{
    int wrong = 0;
    double worst = 0;
    for (int code = 0; code < 256; ++code) {
        const double got =
            std::floor(encode(double{oracle.to_light(glm::u8vec3(static_cast<std::uint8_t>(code))).x}) + 0.5);
        wrong += got != code ? 1 : 0;
        worst = std::max(worst, std::abs(got - code));
    }
    std::printf("%-20s %3d of 256 codes wrong, by up to %g\n", name, wrong, worst);
}

}

int main(int count, char** arguments)
{
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    const auto& oracle = *tests::solution<ColorFunctions>(ORACLE_MODULE);
    const auto standard = [](double x) { return 1.055 * std::pow(x, 1 / 2.4) - 0.055; };
    const auto curve = [&](double x) { return x <= 0.0031308 ? 12.92 * x : standard(x); };
    print_codes("x^(1/2.2)", oracle, [](double x) { return 255 * std::pow(x, 1 / 2.2); });
    print_codes("no line", oracle, [&](double x) { return 255 * std::max(0.0, standard(x)); });
    print_codes("256 for 255", oracle, [&](double x) { return std::min(255.0, 256 * curve(x)); });

    std::printf("seed %llu\n", static_cast<unsigned long long>(seed));
    for (const auto& [name, module] : {std::pair{"reference", REFERENCE_MODULE}, {"float", IN_FLOAT_MODULE}}) {
        const auto& unit = *tests::solution<ColorFunctions>(module);
        int wrong = 0;
        for (int code = 0; code < 255; ++code) {
            const float border = oracle.decode_srgb(static_cast<float>((code + 0.5) / 255));
            for (const float light : {std::nextafter(border, 0.0F), std::nextafter(border, 1.0F)})
                wrong += unit.to_pixel(glm::vec3(light)) != oracle.to_pixel(glm::vec3(light)) ? 1 : 0;
        }
        Random random(seed);
        std::vector<Lamp> lamps(3000);
        for (Lamp& lamp : lamps) lamp = {glm::vec3(random.uniform()), 1e-4F * random.uniform(0, 3)};
        const float dim = oracle.add_lights(std::span(lamps).subspan(1)).x;
        lamps.front() = {glm::vec3(8000), 1};
        const float lost = oracle.add_lights(lamps).x - unit.add_lights(lamps).x;
        std::printf("%-20s %3d of 510 floats beside borders wrong, %5.1f %% of the dim light lost\n", name, wrong,
                    100 * double{lost} / dim);
    }
}
