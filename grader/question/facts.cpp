#include "question/facts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "question/names.hpp"
#include "question/size_facts.hpp"
#include "question/told_fact.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t most_vectors = 12;  ///< pairs of more would be facts that nobody thinks of

/// Of a place with a fourth coordinate that is not 1, as of a direction, it is no number.
double distance(const std::vector<double>& row, const VectorColumns& a, const VectorColumns& b)
{
    constexpr std::size_t most = 3;
    for (const VectorColumns* const one : {&a, &b})
        if (a.size != b.size && one->size > most && row[one->first + most] != 1) return std::nan("");
    double sum = 0;
    for (std::size_t i = 0; i < std::min(a.size, b.size); ++i) {
        const double difference = row[a.first + i] - row[b.first + i];
        sum += difference * difference;
    }
    return std::sqrt(sum);
}

/// The sine of the angle between two vectors; NaN if one is zero.
double sine(const std::vector<double>& row, const VectorColumns& a, const VectorColumns& b)
{
    const double aa = dot(row, a, a);
    const double bb = dot(row, b, b);
    const double ab = dot(row, a, b);
    return std::sqrt(std::max(0.0, 1 - ab * ab / (aa * bb)));
}

/// Of a matrix with two to four columns, one after the other.
double determinant(const double* matrix, std::size_t side)
{
    switch (side) {
        case 2: return glm::determinant(glm::make_mat2(matrix));
        case 3: return glm::determinant(glm::make_mat3(matrix));
        default: return glm::determinant(glm::make_mat4(matrix));
    }
}

/// Twice the area of a triangle in the plane, negative where its corners go clockwise.
double signed_area(const std::vector<double>& row, const VectorColumns& a, const VectorColumns& b,
                   const VectorColumns& c)
{
    const auto across = [&](const VectorColumns& from, std::size_t axis) {
        return row[from.first + axis] - row[a.first + axis];
    };
    return across(b, 0) * across(c, 1) - across(b, 1) * across(c, 0);
}

/// Is it a place as four numbers, of which products say nothing, and no quaternion?
bool is_homogeneous(const QuestionTable& table, const VectorColumns& a)
{
    constexpr double nearly = 1e-3;
    return a.size == 4 &&
           !std::ranges::all_of(table.numbers, [&](const auto& row) { return std::abs(dot(row, a, a) - 1) <= nearly; });
}

/// The least or the largest coordinate of a vector; NaN if one is no number.
template <class Best>
double extreme(const std::vector<double>& row, const VectorColumns& a, const Best& best)
{
    double found = row[a.first];
    for (std::size_t i = 0; i < a.size; ++i) {
        const double one = row[a.first + i];
        if (std::isnan(one)) return one;
        found = best(found, one);
    }
    return found;
}

/// How many coordinates of a vector that is not zero are as large as its largest, beside that one, without their signs.
double ties_in(const std::vector<double>& row, const VectorColumns& a)
{
    double largest = 0;
    for (std::size_t i = 0; i < a.size; ++i) largest = std::max(largest, std::abs(row[a.first + i]));
    double as_large = 0;
    for (std::size_t i = 0; i < a.size; ++i) as_large += std::abs(row[a.first + i]) == largest ? 1 : 0;
    return largest > 0 && std::isfinite(largest) ? std::max(0.0, as_large - 1) : 0;
}

/// A product, and how large it is without its sign: what is small is taken for nothing by who compares with a bound.
template <class Value>
void add_product(std::string words, const QuestionTable& table, const Value& value, std::vector<Fact>& facts)
{
    facts.push_back(told_fact("the size of " + words, Fact::Kind::product, table,
                              [&](const auto& row) { return std::abs(value(row)); }));
    facts.push_back(told_fact(std::move(words), Fact::Kind::product, table, value));
}

/// Of three vectors that are all of a struct or an array; and of any three where there are few.
void add_triples(const QuestionTable& table, const std::vector<VectorColumns>& vectors, std::vector<Fact>& facts)
{
    const auto add_determinant = [&](const VectorColumns& a, const VectorColumns& b, const VectorColumns& c) {
        add_product(
            fmt::format("the determinant of {}, {} and {}", a.words, b.words, c.words), table,
            [&](const auto& row) {
                const auto column = [&row](const VectorColumns& one) { return glm::make_vec3(&row[one.first]); };
                return glm::determinant(glm::dmat3(column(a), column(b), column(c)));
            },
            facts);
    };
    for (std::size_t i = 0; i + 2 < vectors.size(); ++i) {
        const VectorColumns& a = vectors[i];
        const VectorColumns& b = vectors[i + 1];
        const VectorColumns& c = vectors[i + 2];
        const std::string_view of = owner_of(a.words);
        const bool together = !of.empty() && owner_of(b.words) == of && owner_of(c.words) == of && a.size == b.size &&
                              b.size == c.size && (i == 0 || owner_of(vectors[i - 1].words) != of);
        if (!together || a.first >= table.answers || a.size > 3) continue;
        if (a.size == 3)
            add_determinant(a, b, c);
        else
            add_product(
                fmt::format("the signed area of {}, {} and {}", a.words, b.words, c.words), table,
                [&](const auto& row) { return signed_area(row, a, b, c); }, facts);
    }
    std::vector<VectorColumns> in_space;
    std::ranges::copy_if(vectors, std::back_inserter(in_space), [&](const VectorColumns& one) {
        return one.size == 3 && one.first < table.answers && quantity_of(one.words) != Quantity::light;
    });
    constexpr std::size_t few = 4;
    if (in_space.size() > few) return;
    for (auto a = in_space.begin(); a != in_space.end(); ++a)
        for (auto b = a + 1; b < in_space.end(); ++b)
            for (auto c = b + 1; c < in_space.end(); ++c) {
                const std::string_view of = owner_of(a->words);
                if (owner_of(b->words) != of || owner_of(c->words) != of) add_determinant(*a, *b, *c);
            }
}

/// Of matrices, which mirror where it is negative.
void add_determinants(const QuestionTable& table, std::vector<Fact>& facts)
{
    for (std::size_t i = 0; i < std::min(table.names.size(), table.answers); ++i) {
        const std::string& name = table.names[i];
        if (!name.ends_with("[0][0]")) continue;
        const std::string base = name.substr(0, name.size() - std::string_view("[0][0]").size());
        std::size_t side = 1;
        while (i + side < table.names.size() && table.names[i + side] == fmt::format("{}[0][{}]", base, side)) ++side;
        if (side < 2 || side > 4 || i + side * side > table.names.size()) continue;
        add_product(
            "the determinant of " + base, table, [&](const auto& row) { return determinant(&row[i], side); }, facts);
    }
}

}

std::vector<VectorColumns> vectors_in(const std::vector<std::string>& names)
{
    constexpr std::string_view letters = "xyzw";
    std::vector<VectorColumns> vectors;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string& name = names[i];
        if (!name.ends_with(".x")) continue;
        const std::string base = name.substr(0, name.size() - 2);
        std::size_t size = 1;
        while (size < letters.size() && i + size < names.size() && names[i + size] == base + "." + letters[size])
            ++size;
        if (size > 1) vectors.push_back({base, i, size});
    }
    return vectors;
}

std::vector<Fact> facts_of(const QuestionTable& table)
{
    const std::vector<VectorColumns> vectors = vectors_in(table.names);
    std::vector<Fact> facts;
    for (std::size_t i = 0; i < table.names.size(); ++i) {
        facts.push_back(told_fact(table.names[i], Fact::Kind::number, table, [&](const auto& row) { return row[i]; }));
        facts.back().first = table.first == i;
        facts.back().label = std::ranges::find(table.labels, i) != table.labels.end();
        facts.back().answer = i >= table.answers && !facts.back().label;
        if (i < table.words.size()) facts.back().value_names = table.words[i];
        const auto holds_it = [&](const VectorColumns& vector) {
            return i >= vector.first && i < vector.first + vector.size;
        };
        const auto vector = std::ranges::find_if(vectors, holds_it);
        // Of a matrix too.
        facts.back().component = table.names[i].ends_with(']') || vector != vectors.end();
        if (vector != vectors.end()) facts.back().quantity = quantity_of(vector->words);
    }
    for (std::size_t i = 0; i < std::min(vectors.size(), most_vectors); ++i) {
        const VectorColumns& a = vectors[i];
        facts.push_back(told_fact("the length of " + a.words, Fact::Kind::length, table,
                                  [&](const auto& row) { return std::sqrt(dot(row, a, a)); }));
        facts.back().answer = a.first >= table.answers;
        const auto add_coordinate = [&](const std::string& which, const auto& best) {
            facts.push_back(told_fact(fmt::format("the {} coordinate of {}", which, a.words), Fact::Kind::coordinate,
                                      table, [&](const auto& row) { return extreme(row, a, best); }));
            facts.back().answer = a.first >= table.answers;
        };
        add_coordinate("least", [](double x, double y) { return std::min(x, y); });
        add_coordinate("largest", [](double x, double y) { return std::max(x, y); });
        if (a.first < table.answers && quantity_of(a.words) != Quantity::light)
            facts.push_back(
                told_fact(a.words, Fact::Kind::tie, table, [&](const auto& row) { return ties_in(row, a); }));
        for (std::size_t j = i + 1; j < std::min(vectors.size(), most_vectors); ++j) {
            const VectorColumns& b = vectors[j];
            const bool are_in_space = std::min(a.size, b.size) == 3 && std::max(a.size, b.size) == 4;
            if ((a.size != b.size && !are_in_space) || b.first >= table.answers) continue;
            const Quantity of_a = quantity_of(a.words);
            const Quantity of_b = quantity_of(b.words);
            if (of_a == Quantity::light || of_b == Quantity::light) continue;
            if (of_a == Quantity::unknown && of_b == Quantity::unknown)
                facts.push_back(told_fact(fmt::format("the distance between {} and {}", a.words, b.words),
                                          Fact::Kind::length, table,
                                          [&](const auto& row) { return distance(row, a, b); }));
            if (a.size != b.size || is_homogeneous(table, a)) continue;
            facts.push_back(told_fact(fmt::format("dot({}, {})", a.words, b.words), Fact::Kind::product, table,
                                      [&](const auto& row) { return dot(row, a, b); }));
            facts.push_back(told_fact(fmt::format("{} and {}", a.words, b.words), Fact::Kind::parallel, table,
                                      [&](const auto& row) { return sine(row, a, b); }));
        }
    }
    add_triples(table, vectors, facts);
    add_determinants(table, facts);
    add_sizes(table, vectors, facts);
    return facts;
}

}
