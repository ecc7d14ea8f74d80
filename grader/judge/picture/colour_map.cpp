#include "judge/picture/colour_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace umbral::grader {

glm::u8vec4 magma(double share)
{
    static constexpr std::array<std::array<double, 3>, 7> coefficients = {{{-0.002136485053939582, -0.000749655052795221, -0.005386127855323933},
                                                                           {0.2516605407371642, 0.6775232436837668, 2.494026599312351},
                                                                           {8.353717279216625, -3.577719514958484, 0.3144679030132573},
                                                                           {-27.66873308576866, 14.26473078096533, -13.64921318813922},
                                                                           {52.17613981234068, -27.94360607168351, 12.94416944238394},
                                                                           {-50.76852536473588, 29.04658282127291, 4.23415299384598},
                                                                           {18.65570506591883, -11.48977351997711, -5.601961508734096}}};
    const double t = std::isnan(share) ? 1 : std::clamp(share, 0.0, 1.0);
    glm::u8vec4 colour(0, 0, 0, 255);
    for (int channel = 0; channel < 3; ++channel) {
        double value = 0;
        for (std::size_t power = coefficients.size(); power-- > 0;) value = value * t + coefficients[power][static_cast<std::size_t>(channel)];
        colour[channel] = static_cast<glm::u8>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
    }
    return colour;
}

}
