#include "unit/curve.hpp"

#include <algorithm>
#include <fstream>

#include "judge/judge.hpp"
#include "unit/evidence.hpp"
#include "worker/packaged_unit.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

/// The libraries of solutions that are settings of the unit's knob, as the build lists them: "mistakes/in_float". An
/// installation may lack some, or the list.
std::vector<std::string> settings_of(const Toolchain& tools, const Exercise& exercise)
{
    const fs::path folder = unit_folder(tools, exercise.id);
    std::vector<std::string> names;
    std::ifstream list(folder / "settings.txt");
    for (std::string name; std::getline(list, name);)
        if (fs::exists(folder / (name + ".so")) || is_veiled(tools, exercise, name)) names.push_back(name);
    return names;
}

/// "mistakes/in_float" as people read it: "in float".
std::string shown_name(const std::string& library)
{
    std::string name = fs::path(library).filename().string();
    std::ranges::replace(name, '_', ' ');
    return name;
}

/// The errors and the time of solutions on the inputs that the student met.
class Settings {
public:
    Settings(Worker& worker, const Exercise& exercise, const Check& check, const CaseResults& cases)
        : worker_(worker),
          exercise_(exercise),
          check_(check),
          judged_(cases.at(check.case_name)),
          timed_(cases.at(exercise.knob->case_name)),
          expected_(worker.trusted(exercise, judged_against(check), check.case_name, judged_.seed))
    {
    }

    [[nodiscard]] std::optional<CurvePoint> trusted(const char* name, Answers answers)
    {
        return point(name, [&](const std::string& case_name, std::uint64_t seed) -> const RunOutcome& {
            return worker_.trusted(exercise_, answers, case_name, seed);
        });
    }
    [[nodiscard]] std::optional<CurvePoint> setting(const std::string& name)
    {
        return point(shown_name(name), [&](const std::string& case_name, std::uint64_t seed) -> const RunOutcome& {
            return worker_.run_known(exercise_, name, {}, case_name, seed);
        });
    }

private:
    template <class Run>
    std::optional<CurvePoint> point(std::string name, const Run& run)
    {
        const RunOutcome& judged = run(check_.case_name, judged_.seed);
        const Tensor* const value = tensor_of(judged, check_.value);
        if (judged.verdict != Verdict::ok || value == nullptr) return std::nullopt;
        const auto [expected, margin, names] = expected_of(check_, expected_);
        const std::optional<double> error = error_on_curve(judge(check_, *value, *expected, margin, names).metrics);
        const RunOutcome& timed = run(exercise_.knob->case_name, timed_.seed);
        CurvePoint found{std::move(name), error.value_or(-1), timed.cpu_seconds};
        return timed.verdict == Verdict::ok && is_drawable(found) ? std::optional(std::move(found)) : std::nullopt;
    }

    Worker& worker_;
    const Exercise& exercise_;
    const Check& check_;
    const CaseResult& judged_;
    const CaseResult& timed_;
    const RunOutcome& expected_;
};

}

std::optional<double> error_on_curve(const std::map<std::string, double>& metrics)
{
    const auto value = [&](const char* name) {
        const auto found = metrics.find(name);
        return found == metrics.end() ? 0 : found->second;
    };
    const auto error = metrics.find("p95_error");
    const double without = value("missing_hits") + value("false_hits") + value("not_finite");
    if (error == metrics.end() || without * 2 > value("rows")) return std::nullopt;
    return error->second;
}

std::optional<UnitCurve> curve_of(Worker& worker, const Exercise& exercise, const UnitResult& result,
                                  const CaseResults& cases)
{
    // Of work that is wrong where nothing is hard, nobody asks yet how accurate it is.
    const auto is_wrong = [](const CheckResult& check) { return !check.hard && fails(check); };
    if (!exercise.knob || 2 * result.score < result.max_score || std::ranges::any_of(result.checks, is_wrong))
        return std::nullopt;
    const UnitKnob& knob = *exercise.knob;
    const auto place = std::ranges::find(exercise.checks, knob.check, &Check::name) - exercise.checks.begin();
    const Check& check = exercise.checks[static_cast<std::size_t>(place)];
    const CaseResult& timed = cases.at(knob.case_name);
    if (!cases.at(check.case_name).cause().empty() || !timed.cause().empty()) return std::nullopt;
    const std::optional<double> error = error_on_curve(result.checks[static_cast<std::size_t>(place)].metrics);
    UnitCurve curve{knob.name, knob.check, knob.case_name, describe(check).unit, {}, {}};
    curve.yours = {"", error.value_or(-1), timed.student.cpu_seconds};
    if (!is_drawable(curve.yours)) return std::nullopt;

    Settings settings(worker, exercise, check, cases);
    const auto add = [&](std::optional<CurvePoint> point) {
        if (point) curve.others.push_back(std::move(*point));
    };
    add(settings.trusted("reference", Answers::reference));
    if (check.hard) add(settings.trusted("oracle", Answers::oracle));
    for (const std::string& name : settings_of(worker.tools(), exercise)) add(settings.setting(name));
    return curve.others.empty() ? std::nullopt : std::optional(std::move(curve));
}

}
