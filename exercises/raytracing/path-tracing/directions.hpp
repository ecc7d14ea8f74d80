#pragma once

#include <array>
#include <cmath>
#include <string>
#include <umbral/record/variation.hpp>
#include <vector>

#include "../painted_solids.hpp"

/// What directions that are drawn about a normal are like.
namespace umbral::raytracing {

/// Along the axes, both ways, and across, once equally far from all axes; each asks for another way to find vectors
/// across.
inline std::vector<glm::vec3> normals_of_directions()
{
    return {
        {0, 1, 0}, {0, 0, -1}, {-1, 0, 0}, {0.48F, -0.6F, 0.64F}, {0, 0, 1}, {-0.57735027F, 0.57735027F, -0.57735027F}};
}
/// The same about other axes, if inputs are to vary.
inline std::vector<glm::vec3> normals_of_directions(Variation& vary)
{
    std::vector<glm::vec3> normals = normals_of_directions();
    const ExactMap map = vary.exact_map(0);
    for (glm::vec3& normal : normals) normal = map.place(normal);
    return normals;
}

/// Means over some directions round a normal n, with x and y across it.
class DirectionMoments {
public:
    explicit DirectionMoments(const glm::vec3& normal) : n_(normal)
    {
        const glm::vec3 other = std::abs(n_.x) > 0.5F ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
        x_ = normalize(cross(other, n_));
        y_ = cross(n_, x_);
    }
    void add(const glm::vec3& direction)
    {
        const float n = dot(direction, n_);
        const float x = dot(direction, x_);
        const float y = dot(direction, y_);
        const auto share = [](bool counts) { return counts ? 1.0F : 0.0F; };
        const std::array<float, 10> values{n,
                                           x,
                                           y,
                                           x * x,
                                           x * y,
                                           (x + y) * (n - 0.6F),
                                           share(n < 0.5F),
                                           share(n < 0.26F),
                                           share(n > 0.95F),
                                           share(n > 0.985F)};
        for (std::size_t i = 0; i < values.size(); ++i) sums_[i] += values[i];
        // Of successive directions that are independent, the mean of these products is 0.
        const glm::vec3 centred(n - 2.0F / 3, x, y);
        if (count_ > 0) products_ += centred * last_;
        last_ = centred;
        ++count_;
    }
    void append_to(std::vector<float>& row) const
    {
        for (const float sum : sums_) row.push_back(sum / static_cast<float>(count_));
        for (int i = 0; i < 3; ++i) row.push_back(products_[i] / static_cast<float>(count_ - 1));
    }

private:
    glm::vec3 n_;
    glm::vec3 x_;
    glm::vec3 y_;
    std::array<float, 10> sums_{};
    glm::vec3 products_{0};
    glm::vec3 last_{0};
    int count_ = 0;
};

inline std::string names_of_moments(std::size_t normals)
{
    constexpr std::array names{"The part along the normal",
                               "The part along x",
                               "The part along y",
                               "The square of the part along x",
                               "The product of the parts along x and y",
                               "The part across, weighted by the height",
                               "The share of directions beyond 60 degrees from the normal",
                               "The share of directions beyond 75 degrees from the normal",
                               "The share of directions within 18 degrees of the normal",
                               "The share of directions within 10 degrees of the normal",
                               "The product of two successive parts along the normal, less their means",
                               "The product of two successive parts along x",
                               "The product of two successive parts along y"};
    std::vector<std::string> all;
    for (std::size_t n = 0; n < normals; ++n)
        for (const char* name : names) all.push_back(std::string(name) + " (normal " + std::to_string(n) + ')');
    return numbered_names(all);
}

}
