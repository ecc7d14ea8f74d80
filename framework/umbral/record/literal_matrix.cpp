#include <array>
#include <cmath>
#include <optional>

#include "umbral/record/literal.hpp"

namespace umbral::literal {
namespace {

/// A square matrix, column by column.
template <class Number>
struct Square {
    std::span<const Number> numbers;
    std::size_t side;

    [[nodiscard]] Number at(std::size_t column, std::size_t row) const { return numbers[column * side + row]; }
};

/// 0 with the sign of positive numbers: what GLM's functions leave where nothing is put.
template <class Number>
bool is_plain_zero(Number number)
{
    return number == 0 && !std::signbit(number);
}

/// Is all 0 but the diagonal and the last column?
template <class Number>
bool is_empty_elsewhere(const Square<Number>& m)
{
    for (std::size_t column = 0; column + 1 < m.side; ++column)
        for (std::size_t row = 0; row < m.side; ++row)
            if (row != column && !is_plain_zero(m.at(column, row))) return false;
    return true;
}

template <class Number>
using Three = std::array<Number, 3>;

/// The factors of which glm::scale makes exactly this: it multiplies zeros by them.
template <class Number>
std::optional<Three<Number>> factors_of(const Square<Number>& m)
{
    Three<Number> factors{};
    for (std::size_t i = 0; i < 3; ++i) {
        factors[i] = m.at(i, i);
        if (!is_plain_zero(m.at(3, i)) || std::signbit(factors[i]) || !std::isfinite(factors[i])) return std::nullopt;
    }
    return factors;
}

/// The step of which glm::translate makes exactly this: it adds zeros to it.
template <class Number>
std::optional<Three<Number>> step_of(const Square<Number>& m)
{
    Three<Number> step{};
    for (std::size_t i = 0; i < 3; ++i) {
        step[i] = m.at(3, i);
        const bool negative_zero = step[i] == 0 && std::signbit(step[i]);
        if (m.at(i, i) != 1 || negative_zero || !std::isfinite(step[i])) return std::nullopt;
    }
    return step;
}

template <class Number>
std::string call(const char* function, std::string_view type, const Three<Number>& argument)
{
    const char* const vector = sizeof(Number) == sizeof(double) ? "glm::dvec3" : "glm::vec3";
    return std::string(function) + "(" + std::string(type) + "(1), " + vector + "{" + of(argument[0]) + ", " +
           of(argument[1]) + ", " + of(argument[2]) + "})";
}

template <class Number>
std::string simple(const Square<Number>& m, std::string_view type)
{
    if (!is_empty_elsewhere(m)) return "";
    const Number diagonal = m.at(0, 0);
    bool is_multiple = std::isfinite(diagonal) && !(diagonal == 0 && std::signbit(diagonal));
    for (std::size_t i = 1; i < m.side; ++i)
        is_multiple = is_multiple && m.at(i, i) == diagonal && is_plain_zero(m.at(m.side - 1, i - 1));
    if (is_multiple) return std::string(type) + "(" + of(diagonal) + ")";
    if (m.side != 4 || m.at(3, 3) != 1) return "";
    if (const auto step = step_of(m)) return call("glm::translate", type, *step);
    if (const auto factors = factors_of(m)) return call("glm::scale", type, *factors);
    return "";
}

}

std::string of_simple_matrix(std::span<const float> numbers, std::size_t side, std::string_view type)
{
    return simple(Square<float>{numbers, side}, type);
}

std::string of_simple_matrix(std::span<const double> numbers, std::size_t side, std::string_view type)
{
    return simple(Square<double>{numbers, side}, type);
}

}
