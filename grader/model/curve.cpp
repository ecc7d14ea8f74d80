#include "model/curve.hpp"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "text/printable.hpp"

namespace umbral::grader {
namespace {

using nlohmann::json;

constexpr std::size_t most_points = 64;
constexpr std::size_t most_shown_bytes = 4096;

std::string text(std::string_view value) { return printable(value, most_shown_bytes); }

json point_json(const CurvePoint& point) { return {{"error", point.error}, {"seconds", point.seconds}}; }

CurvePoint read_point(const Field& field)
{
    constexpr double largest = std::numeric_limits<double>::max();
    CurvePoint point;
    point.error = field.member("error").number(0, largest);
    point.seconds = field.member("seconds").number(0, largest);
    if (!is_drawable(point)) field.refuse("an error of 0 or more, and a time above 0");
    return point;
}

}

bool is_drawable(const CurvePoint& point)
{
    return std::isfinite(point.error) && point.error >= 0 && std::isfinite(point.seconds) && point.seconds > 0;
}

json to_json(const UnitCurve& curve)
{
    json others = json::array();
    for (const CurvePoint& point : curve.others) {
        others.push_back(point_json(point));
        others.back()["name"] = text(point.name);
    }
    return {{"knob", text(curve.knob)}, {"check", text(curve.check)},       {"case", text(curve.case_name)},
            {"unit", text(curve.unit)}, {"yours", point_json(curve.yours)}, {"others", others}};
}

UnitCurve curve_from_json(const Field& field)
{
    field.allow_only({"knob", "check", "case", "unit", "yours", "others"});
    const auto words = [&](const char* name) { return field.member(name).any_text(most_shown_bytes); };
    UnitCurve curve{words("knob"), words("check"), words("case"), words("unit"), {}, {}};
    field.member("yours").allow_only({"error", "seconds"});
    curve.yours = read_point(field.member("yours"));
    for (const Field& one : field.member("others").items(1, most_points)) {
        one.allow_only({"name", "error", "seconds"});
        curve.others.push_back(read_point(one));
        curve.others.back().name = one.member("name").any_text(most_shown_bytes);
    }
    return curve;
}

}
