#pragma once

#include <functional>
#include <vector>

#include "question/dependence.hpp"
#include "question/error_dependence.hpp"

namespace umbral::grader::moved_test {

/// Arguments of a function "f" of three numbers and a vector.
struct Asked {
    double left = 1;
    double top = 2;
    double size = 3;
    double x = 4;
    double y = 5;
    double z = 6;
};

using Answer = std::function<std::vector<double>(const Asked&)>;

/// Five questions, answered as they are and with each argument moved; all are said to be wrong.
inline AnswersToMoves answers(const Answer& yours, const Answer& right)
{
    AnswersToMoves all;
    const auto asked = [](int i) {
        const double k = 1 + 0.3 * i;
        return Asked{k, 2 * k + 1, 3 + k, 4 - k, 5 + k * k, 6 - k};
    };
    const auto ask = [&](const Answer& answer, const std::function<void(Asked&)>& move) {
        std::vector<double> table;
        for (int i = 0; i < 5; ++i) {
            Asked one = asked(i);
            move(one);
            const std::vector<double> row = answer(one);
            table.insert(table.end(), row.begin(), row.end());
        }
        return table;
    };
    const auto as_it_is = [](Asked&) {};
    all.components = right({}).size();
    all.yours = ask(yours, as_it_is);
    all.right = ask(right, as_it_is);
    all.wrong = {0, 1, 2, 3, 4};
    const auto add = [&](const char* place, const char* change, const std::function<void(Asked&)>& move) {
        all.moved.push_back({{"f", place, change, ""}, ask(yours, move), ask(right, move)});
    };
    constexpr double factor = 17.0 / 16;
    add("0.left", "moved", [](Asked& a) { a.left *= factor; });
    add("0.top", "moved", [](Asked& a) { a.top *= factor; });
    add("1", "moved", [](Asked& a) { a.size *= factor; });
    add("2", "moved .x", [](Asked& a) { a.x *= factor; });
    add("2", "moved .y", [](Asked& a) { a.y *= factor; });
    add("2", "moved .z", [](Asked& a) { a.z *= factor; });
    add("2", "moved length", [](Asked& a) { a.x *= factor, a.y *= factor, a.z *= factor; });
    return all;
}

inline std::vector<Dependence> dependences(const AnswersToMoves& all) { return grader::dependences(reactions(all)); }

inline std::vector<ErrorDependence> error_dependences(const AnswersToMoves& all)
{
    return grader::error_dependences(reactions(all));
}

}
