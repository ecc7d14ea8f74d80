#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "text/field.hpp"

namespace umbral::grader {

/// What one solution of a unit leaves of error, and takes of time.
struct CurvePoint {
    std::string name;    ///< "reference", "oracle", "school formula"; of a student's own empty
    double error = 0;    ///< 0 or above; finite
    double seconds = 0;  ///< of the processor, for a whole run of the case, loading included; above 0
};

/// Where on the curve of the unit's knob the student's choice lies: error against time, beside those of other
/// solutions on the same inputs. Gives no points.
struct UnitCurve {
    std::string knob;       ///< of `umbral bench accuracy`: "ray-sphere"
    std::string check;      ///< whose error it is: "far away/t"
    std::string case_name;  ///< whose time it is: "picture"
    std::string unit;       ///< of the errors: "ulp", "relative", or nothing
    CurvePoint yours;
    std::vector<CurvePoint> others;  ///< at least one, each of another name, in an order that no time decides
};

/// Are all numbers such as a curve can be drawn from?
[[nodiscard]] bool is_drawable(const CurvePoint& point);

/// A part of report.json, and the same read back. Throws std::runtime_error that names the field for anything that
/// cannot be drawn.
[[nodiscard]] nlohmann::json to_json(const UnitCurve& curve);
[[nodiscard]] UnitCurve curve_from_json(const Field& field);

}
