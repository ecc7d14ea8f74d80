#pragma once

#include <gtest/gtest.h>

#include "support/workbench.hpp"
#include "unit/grade_unit.hpp"
#include "worker/known_solutions.hpp"

namespace umbral::grader::test {

/// Grades the reference of a unit, raytracing/sphere if none is named, with a bug in it.
class SpoiltReference : public testing::Test {
protected:
    explicit SpoiltReference(const std::string& unit = "raytracing/sphere") : exercise(bench.exercise(unit)) {}

    /// With one text in place of another, which it must hold. A fault of the grader's fails the test.
    UnitResult grade(const std::string& from, const std::string& to, const GradeOptions& options = {})
    {
        UnitResult result = grade_unit(worker, exercise, {spoilt(from, to), {}, ""}, options);
        EXPECT_NE(result.verdict, Verdict::grader_fault) << result.message;
        return result;
    }

    [[nodiscard]] Built build_spoilt(const std::string& from, const std::string& to) const
    {
        return build(bench.tools(), exercise, spoilt(from, to));
    }

    static const CheckResult& check(const UnitResult& result, const std::string& name)
    {
        return *std::ranges::find(result.checks, name, &CheckResult::name);
    }

    Workbench bench;
    Exercise exercise;
    Worker worker{bench.tools()};

private:
    [[nodiscard]] Sources spoilt(const std::string& from, const std::string& to) const
    {
        Sources sources = reference_sources(bench.tools().reference, exercise);
        std::string& text = sources.begin()->second;
        const std::size_t place = text.find(from);
        EXPECT_NE(place, std::string::npos) << from;
        text.replace(place, from.size(), to);
        return sources;
    }
};

}
