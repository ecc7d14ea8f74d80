// Prints the table in the statement of transforms/gram-matrix: how far areas of nearly parallel vectors are off.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <umbral/core/random.hpp>
#include <umbral/transforms/gram_matrix.hpp>

using namespace umbral;
using namespace umbral::transforms;

namespace {

#ifdef __SIZEOF_FLOAT128__
using Exact = __float128;
#else
using Exact = long double;
#endif

/// |a|²|b|² - (a·b)², computed in `Number`.
template <class Number>
Number square_of_area(const glm::mat3& gram, const glm::vec3& a, const glm::vec3& b)
{
    const auto dot = [&](const glm::vec3& u, const glm::vec3& v) {
        Number sum = 0;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) sum += Number(u[i]) * Number(v[j]) * Number(gram[i][j]);
        return sum;
    };
    return dot(a, a) * dot(b, b) - dot(a, b) * dot(a, b);
}

template <class Area>
void print_line(const char* name, Area area)
{
    std::printf("%-22s", name);
    for (const float apart : {1e-1F, 1e-2F, 1e-3F, 1e-4F, 1e-5F, 1e-6F}) {
        Random random(20281);
        double worst = 0;
        for (int i = 0; i < 20'000; ++i) {
            glm::mat3 basis;
            for (int k = 0; k < 3; ++k) basis[k] = random.uniform(0.5F, 2) * random.unit_vector();
            // Leaning vectors, none of them near the plane of the others.
            basis = basis * 0.25F + glm::mat3(1);
            const glm::vec3 a = random.unit_vector();
            const glm::vec3 b = a + apart * random.unit_vector();
            const glm::mat3 gram = gram_matrix(basis);
            const double exact = std::sqrt(static_cast<double>(square_of_area<Exact>(gram, a, b)));
            if (exact < 0.1 * double{apart}) continue;
            worst = std::max(worst, std::abs(static_cast<double>(area(gram, a, b)) / exact - 1));
        }
        std::printf(" %9.1e", worst);
    }
    std::printf("\n");
}

template <class Number>
Number subtracted(const glm::mat3& gram, const glm::vec3& a, const glm::vec3& b)
{
    return std::sqrt(std::max(Number{0}, square_of_area<Number>(gram, a, b)));
}

}

int main()
{
    print_line("squares, in float", subtracted<float>);
    print_line("squares, in double", subtracted<double>);
    print_line("reference", area_from_gram);
}
