#pragma once

#include <string>

#include "report/html/pages.hpp"
#include "results.hpp"

namespace umbral::grader::html {

/// A unit with a text from outside wherever one can stand.
inline SubmissionResult hostile_submission(const std::string& text)
{
    CheckResult check = check_result(text, 0, 1000);
    check.message = text;
    check.first_difference = Difference{text, text, text};
    check.sketch = text;
    check.common = check.about = text;
    check.simplest = Difference{text, text, text, {}, text};
    check.code_place = CodePlace{text, 1, 2, text, text};
    UnitResult unit = unit_result(text, Verdict::partial, {check, check_result(text + "2", 500, 500)});
    unit.message = text;
    unit.output = text;
    unit.curve = UnitCurve{text, text, text, text, {text, 1, 0.001}, {{text, 1e300, 1e-300}, {"reference", 0, 1e300}}};
    unit.explanations = {{text, text, 1}, {text, text, 0.5}};
    return submission_result(text, {unit});
}

inline UnitDetails hostile_details(const std::string& text)
{
    CheckDetail detail;
    detail.why = detail.bound = detail.unit = text;
    RowsEvidence rows;
    rows.headings = {text};
    rows.first = {{text, {text}, {text}, {true}, text}};
    LinesEvidence lines;
    lines.what = text;
    lines.lines = {{LineKind::changed, 1, 1, text, text, 0}, {LineKind::missing, 0, 2, "", text, 0}};
    PictureEvidence picture;
    picture.problem = text;
    picture.pixels = {{1, 2, text, text, 3}};
    picture.yours = picture.reference.emplace(Image(2, 2));
    FragmentsEvidence fragments;
    fragments.sketch = text;
    fragments.rows = rows;
    UnitDetails details;
    UnitDetail& unit = details[text];
    unit.title = text;
    unit.checks[text] = detail;
    int number = 0;
    for (const Evidence& evidence : {Evidence(rows), Evidence(lines), Evidence(picture), Evidence(fragments)}) {
        unit.checks[text + std::to_string(++number)] = detail;
        unit.checks[text + std::to_string(number)].evidence = evidence;
    }
    return details;
}

inline std::string hostile_page(const std::string& text)
{
    SubmissionResult submission = hostile_submission(text);
    for (int i = 1; i <= 4; ++i) submission.units[0].checks.push_back(check_result(text + std::to_string(i), 0, 1000));
    return report_html(submission, {text, text, text, text, text, text, {text}}, hostile_details(text));
}

}
