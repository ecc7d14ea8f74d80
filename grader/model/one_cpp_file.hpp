#pragma once

#include "model/exercise.hpp"

namespace umbral::grader {

/// Small changes are tried in one C++ file, by `validate --mutants` and `umbral locate`: is the unit one?
[[nodiscard]] inline bool is_one_cpp_file(const Exercise& exercise)
{
    return exercise.is_cpp() && exercise.files.size() == 1;
}

}
