#include "manifest/with.hpp"

#include <algorithm>

namespace umbral::grader {

void expect_known_with(const Field& checks, const Exercise& exercise)
{
    const std::vector<Field> items = checks.items(1, exercise.checks.size());
    for (std::size_t i = 0; i < exercise.checks.size(); ++i) {
        const std::string& with = exercise.checks[i].with;
        if (with.empty()) continue;
        const auto other = std::ranges::find(exercise.checks, with, &Check::name);
        if (other == exercise.checks.end() || other->hidden || !other->with.empty())
            items[i].member("with").refuse("\"case/value\" of a visible check that has no \"with\" itself");
    }
}

}
