#include "row.hpp"

#include <cmath>

namespace stability {

std::vector<Row> all_rows()
{
    std::vector<Row> all;
    for (const auto& topic :
         {transforms_rows(), projections_rows(), lighting_rows(), raytracing_rows(), texturing_rows()})
        all.insert(all.end(), topic.begin(), topic.end());
    return all;
}

float between_powers(umbral::Random& random, float low, float high)
{
    return std::pow(10.0F, random.uniform(low, high));
}

void make_unit(std::vector<float>& x, std::size_t at, std::size_t count)
{
    double length = 0;
    for (std::size_t i = at; i < at + count; ++i) length += double{x[i]} * x[i];
    if (length == 0) {
        x[at] = 1;
        return;
    }
    for (std::size_t i = at; i < at + count; ++i) x[i] = static_cast<float>(x[i] / std::sqrt(length));
}

}
