// Prints the tables of the statements of vectors, frames, rotation-identities, about-a-point and normal-matrix: what
// their school formulas lose in float, measured against the references.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/gtc/matrix_transform.hpp>
#include <umbral/core/random.hpp>
#include <umbral/transforms/about_a_point.hpp>
#include <umbral/transforms/frames.hpp>
#include <umbral/transforms/normal_matrix.hpp>
#include <umbral/transforms/rotation_identities.hpp>
#include <umbral/transforms/vectors.hpp>
#include <vector>

using namespace umbral;
using namespace umbral::transforms;

namespace {

constexpr int samples = 20'000;

template <class Sample>
double worst(Sample sample)
{
    double result = 0;
    for (int i = 0; i < samples; ++i) result = std::max(result, sample());
    return result;
}

glm::vec3 nearly(const glm::vec3& v, float angle, Random& random)
{
    return v + angle * normalize(cross(v, random.unit_vector()));
}

glm::mat4 any_rotation(Random& random)
{
    const glm::vec3 axis = random.unit_vector();
    return glm::rotate(glm::mat4(1), random.uniform(-3, 3), axis);
}

double distance_between(const glm::vec4& a, const glm::vec4& b) { return double{length(a - b)}; }

template <class Vector>
double angle_by_arc_cosine(const Vector& a, const Vector& b)
{
    using Number = typename Vector::value_type;
    return double{std::acos(std::clamp(dot(normalize(a), normalize(b)), Number{-1}, Number{1}))};
}

void print_vectors()
{
    Random random(1);
    std::printf("vectors: worst relative errors at an angle\n%8s %22s %22s %22s\n", "angle", "arc cosine, float",
                "arc cosine, double", "cross, float");
    for (const float angle : {1e-1F, 1e-2F, 1e-3F, 1e-4F, 1e-5F, 1e-6F}) {
        double in_float = 0;
        double in_double = 0;
        const double crossed = worst([&] {
            const glm::vec3 u = random.unit_vector();
            const glm::vec3 v = nearly(u, angle, random);
            const double exact = double{angle_between(u, v)};
            in_float = std::max(in_float, std::abs(angle_by_arc_cosine(u, v) - exact) / exact);
            in_double =
                std::max(in_double, std::abs(angle_by_arc_cosine(glm::dvec3(u), glm::dvec3(v)) - exact) / exact);
            return double{length(cross_product(u, v) - cross(u, v)) / length(cross_product(u, v))};
        });
        std::printf("%8.0e %22.1e %22.1e %22.1e\n", double{angle}, in_float, in_double, crossed);
    }
}

void print_frames()
{
    Random random(2);
    std::printf(
        "frames: worst error of the last column, two Cartesian frames 8 from each other, by way of the world in "
        "float\n");
    for (const float far : {1e4F, 1e5F, 1e6F, 1e7F}) {
        const double error = worst([&] {
            const glm::mat4 a = any_rotation(random);
            const glm::mat4 b = any_rotation(random);
            const glm::vec3 here = far * random.unit_vector();
            const Frame from{glm::vec3(a[0]), glm::vec3(a[1]), glm::vec3(a[2]), here};
            const Frame to{glm::vec3(b[0]), glm::vec3(b[1]), glm::vec3(b[2]), here + 8.0F * random.unit_vector()};
            const glm::mat4 by_the_world = glm::inverse(frame_matrix(to)) * frame_matrix(from);
            return distance_between(between_frames(from, to)[3], by_the_world[3]);
        });
        std::printf("%8.0e %10.1e\n", double{far}, error);
    }
}

void print_rotations()
{
    Random random(3);
    std::printf("rotation-identities: worst error of a unit vector turned by so many degrees\n%8s %12s %12s\n",
                "degrees", "float", "double");
    for (const float degrees : {1e3F, 1e5F, 1e7F, 1e9F}) {
        double in_double = 0;
        const double in_float = worst([&] {
            const float turn = degrees * random.uniform(0.3F, 1);
            const glm::vec3 exact = elementary_rotation({1, 0, 0}, {WorldAxis::z, turn});
            const double wide = glm::radians(double{turn});
            in_double = std::max(in_double, length(glm::dvec3(std::cos(wide), std::sin(wide), 0) - glm::dvec3(exact)));
            return double{length(glm::vec3(std::cos(glm::radians(turn)), std::sin(glm::radians(turn)), 0) - exact)};
        });
        std::printf("%8.0e %12.1e %12.1e\n", double{degrees}, in_float, in_double);
    }
    std::printf(
        "and of (1,2,3), brought to length 1, turned by a thousandth of a degree about x, y, z, x, … so often, rounded "
        "to float after each\n%8s %12s %12s\n",
        "turns", "direction", "length");
    for (const std::size_t count : {std::size_t{6'000}, std::size_t{60'000}, std::size_t{600'000}}) {
        const glm::vec3 start = normalize(glm::vec3(1, 2, 3));
        std::vector<ElementaryTurn> turns(count);
        glm::vec3 v = start;
        for (std::size_t i = 0; i < count; ++i) {
            turns[i] = {static_cast<WorldAxis>(i % 3), 1e-3F};
            v = elementary_rotation(v, turns[i]);
        }
        const glm::dvec3 exact(after_turns(start, turns));
        std::printf("%8zu %12.1e %12.1e\n", count, length(glm::dvec3(v) - exact),
                    std::abs(length(glm::dvec3(v)) - length(exact)));
    }
}

void print_about_a_point()
{
    Random random(4);
    std::printf("about-a-point: worst error of the last column of Tra Rot Tra in float, a turn by 1e-5\n");
    for (const float far : {1e2F, 1e4F, 1e6F}) {
        const double error = worst([&] {
            const glm::vec3 centre = far * random.unit_vector();
            const AxisAngle turn{random.unit_vector(), 1e-5F};
            const glm::mat4 product =
                glm::translate(glm::rotate(glm::translate(glm::mat4(1), centre), turn.angle, turn.axis), -centre);
            return distance_between(rotation_about_point(centre, turn)[3], product[3]);
        });
        std::printf("%8.0e moves %8.1e %10.1e\n", double{far}, 1e-5 * double{far}, error);
    }
    std::printf("worst error of a column of the alignment, so far from opposite, in float\n%8s %16s %16s\n", "angle",
                "1 / (1 + cos)", "arc cosine");
    for (const float angle : {1e-1F, 1e-2F, 1e-3F, 1e-4F}) {
        double by_angle = 0;
        const double by_division = worst([&] {
            const glm::vec3 u = random.unit_vector();
            const glm::vec3 v = -normalize(nearly(u, angle, random));
            const glm::mat4 exact = alignment(u, v);
            const glm::vec3 w = cross(u, v);
            const glm::mat3 across(cross(w, {1, 0, 0}), cross(w, {0, 1, 0}), cross(w, {0, 0, 1}));
            const glm::mat4 divided(glm::mat3(1) + across + across * across / (1 + dot(u, v)));
            const glm::mat4 turned = glm::rotate(glm::mat4(1), std::acos(std::clamp(dot(u, v), -1.0F, 1.0F)), w);
            double error = 0;
            for (int i = 0; i < 3; ++i) {
                error = std::max(error, distance_between(exact[i], divided[i]));
                by_angle = std::max(by_angle, distance_between(exact[i], turned[i]));
            }
            return error;
        });
        std::printf("%8.0e %16.1e %16.1e\n", double{angle}, by_division, by_angle);
    }
}

void print_normals()
{
    Random random(5);
    const auto wrong_share = [&](const glm::vec3& factors) {
        int wrong = 0;
        for (int i = 0; i < samples; ++i) {
            const glm::mat4 model = glm::scale(any_rotation(random), factors) * any_rotation(random);
            const glm::vec3 n = random.unit_vector();
            const glm::vec3 in_float = normalize(transpose(inverse(glm::mat3(model))) * n);
            if (!(length(in_float - transformed_normal(model, n)) < 1e-3F)) ++wrong;
        }
        return 100.0 * wrong / samples;
    };
    std::printf("normal-matrix: normals that are off by more than 1e-3, inverse transpose in float\n");
    for (const float thickness : {1e-6F, 1e-7F, 1e-8F})
        std::printf("pressed to %.0e: %.0f %%\n", double{thickness}, wrong_share({1, 1, thickness}));
    for (const float size : {1e-10F, 1e-13F, 1e-20F, 1e12F, 1e13F, 1e20F})
        std::printf("size %.0e: %.0f %%\n", double{size}, wrong_share(size * glm::vec3(1, 2, 0.5F)));
}

}

int main()
{
    print_vectors();
    print_frames();
    print_rotations();
    print_about_a_point();
    print_normals();
}
