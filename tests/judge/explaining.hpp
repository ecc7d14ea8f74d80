#pragma once

#include <gtest/gtest.h>

#include "judge/explain/explain.hpp"
#include "make.hpp"

namespace umbral::grader::test {

inline std::vector<Explanation> explain(const Check& check, const Tensor& student, const Tensor& expected)
{
    return explain_by_transform({FailingCheck{&check, &student, &expected, nullptr}});
}

/// The name of the first explanation, or "none".
inline std::string first(const Check& check, const Tensor& student, const Tensor& expected)
{
    const auto found = explain(check, student, expected);
    return found.empty() ? "none" : found.front().name;
}

}
