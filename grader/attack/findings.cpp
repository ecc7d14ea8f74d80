#include "attack/findings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/stat.h>

#include <algorithm>

namespace umbral::grader::attack {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// Raw in a page, this tag means that a submission wrote markup into it.
constexpr const char* markup = "<x-umbral";

/// What the reports say of a unit that is missing: its checks, in four files.
constexpr double kib_of_another_unit = 24;

const Json* unit_in(const Json& report, const std::string& id)
{
    const auto units = report.find("units");
    if (units == report.end() || !units->is_array()) return nullptr;
    for (const Json& unit : *units)
        if (unit.value("id", "") == id) return &unit;
    return nullptr;
}

/// The first control character, as a number; -1 if there is none. Also what turns the direction of writing, is not
/// seen, or towers over the lines above, in UTF-8.
int control_character(const std::string& text)
{
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto c = static_cast<unsigned char>(text[i]);
        if ((c < 0x20 && c != '\n' && c != '\t') || c == 0x7f) return c;
        if (c == 0xc2 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xa0)
            return static_cast<unsigned char>(text[i + 1]);
    }
    for (const char* const turn : {"\u061c",     "\u200e",     "\u200f", "\u202a", "\u202b",
                                   "\u202c",     "\u202d",     "\u202e", "\u2066", "\u2067",
                                   "\u2068",     "\u2069",     "\u206a", "\u180e", "\ufff9",
                                   "\U000e0041", "\U000e0148", "\u3164", "\ufe01", "\u0301\u0301\u0301\u0301\u0301"})
        if (text.find(turn) != std::string::npos) return 0x202e;
    return -1;
}

/// Reads what lies in a report folder and looks for what no report may hold.
class Folder {
public:
    Folder(const Attack& attack, const Graded& graded, const fs::path& folder, std::vector<std::string>& found)
        : attack_(attack), graded_(graded), folder_(folder), found_(found)
    {
    }

    void look() const
    {
        for (const char* const name : {"report.json", "report.student.json", "report.html"}) {
            const std::string text = bytes_of_file(folder_ / name);
            if (text.empty()) found_.push_back(fmt::format("there is no {}", name));
            look_at(name, text);
            const bool for_student = std::string_view(name) != "report.json";
            for (const std::string& leak : attack_.student_lacks)
                if (for_student && text.find(leak) != std::string::npos)
                    found_.push_back(fmt::format("{} holds '{}'", name, leak));
            struct stat status {};
            if (stat((folder_ / name).c_str(), &status) == 0 && (status.st_mode & S_IROTH) != 0 && others_enter())
                found_.push_back(fmt::format("every user of this machine can read {}", name));
        }
        const double most = attack_.bounds.report_kib + kib_of_another_unit * other_units();
        if (const double kib = disk_kib(folder_); kib > most)
            found_.push_back(fmt::format("its reports take {:.0f} KiB; at most {:.0f} were expected", kib, most));
    }

private:
    /// Units that others of the class attack, and this one did not hand in.
    [[nodiscard]] double other_units() const
    {
        const Json& report = graded_.reports.at(attack_.id());
        const auto units = report.find("units");
        return units == report.end() ? 0
                                     : static_cast<double>(units->size()) - static_cast<double>(attack_.units.size());
    }

    void look_at(const std::string& name, const std::string& text) const
    {
        if (const int c = control_character(text); c >= 0)
            found_.push_back(fmt::format("{} holds the control character {:#x}", name, c));
        if (name.ends_with(".html") && text.find(markup) != std::string::npos)
            found_.push_back(fmt::format("{} holds markup of the submission's", name));
        const fs::path scratch = graded_.out.parent_path();
        for (const std::string& path : {fs::path(scratch / "cache").string(), graded_.source.string() + "/"})
            if (!attack_.knows_paths && text.find(path) != std::string::npos)
                found_.push_back(fmt::format("{} names the path {} of this machine", name, path));
        for (const std::string& leak : attack_.lacks)
            if (text.find(leak) != std::string::npos) found_.push_back(fmt::format("{} holds '{}'", name, leak));
        if (text.find(graded_.secret) != std::string::npos) found_.push_back(fmt::format("{} holds the secret", name));
    }

    [[nodiscard]] bool others_enter() const
    {
        for (const fs::path& folder : {folder_, graded_.out}) {
            struct stat status {};
            if (stat(folder.c_str(), &status) == 0 && (status.st_mode & S_IXOTH) == 0) return false;
        }
        return true;
    }

    const Attack& attack_;
    const Graded& graded_;
    const fs::path& folder_;
    std::vector<std::string>& found_;
};

void look_at_unit(const std::string& id, const ExpectedUnit& expected, const Json& unit,
                  std::vector<std::string>& found)
{
    const std::string verdict = unit.value("verdict", "");
    const std::string message = unit.value("message", "");
    const double points = unit.value("score", 0.0) / 1000;
    const auto is = [&](Verdict one) { return to_string(one) == verdict; };
    if (!expected.verdicts.empty() && std::ranges::none_of(expected.verdicts, is)) {
        std::vector<std::string_view> names;
        for (const Verdict one : expected.verdicts) names.push_back(to_string(one));
        found.push_back(fmt::format("{}: the verdict is {}, expected was {}: {}", id, verdict, fmt::join(names, " or "),
                                    message.substr(0, 200)));
    }
    if (points > expected.most_points)
        found.push_back(
            fmt::format("{}: it earned {} points, at most {} were expected", id, points, expected.most_points));
    if (points < expected.least_points)
        found.push_back(
            fmt::format("{}: it earned {} points, its work is worth {}", id, points, expected.least_points));
    for (const std::string& text : expected.message_has)
        if (message.find(text) == std::string::npos)
            found.push_back(fmt::format("{}: the message lacks '{}': {}", id, text, message.substr(0, 200)));
    for (const std::string& text : expected.message_lacks)
        if (message.find(text) != std::string::npos)
            found.push_back(fmt::format("{}: the message holds '{}'", id, text));
}

/// What the student reads of the time; of hidden cases it may tell nothing.
void look_at_times(const Attack& attack, const Json& report, std::vector<std::string>& found)
{
    for (const auto& [id, expected] : attack.units) {
        const Json* unit = unit_in(report, id);
        if (unit == nullptr || expected.most_seconds == 0) continue;
        if (const double seconds = unit->value("seconds", 0.0); seconds > expected.most_seconds)
            found.push_back(fmt::format("{}: the student's report tells of {:.1f} s, at most {} were expected", id,
                                        seconds, expected.most_seconds));
    }
}

/// Times are the only fields in which two gradings may differ.
Json without_times(Json json)
{
    if (json.is_object()) {
        json.erase("seconds");
        json.erase("reference_seconds");
    }
    if (json.is_structured())
        for (Json& part : json) part = without_times(std::move(part));
    return json;
}

}

std::vector<std::string> findings(const Attack& attack, const Graded& graded)
{
    std::vector<std::string> found;
    if (!graded.complete()) return {graded.how_it_ended()};
    if (const int c = control_character(graded.run.printed); c >= 0)
        found.push_back(fmt::format("the terminal got the control character {:#x}", c));
    for (const std::string& leak : attack.lacks)
        if (graded.run.printed.find(leak) != std::string::npos)
            found.push_back(fmt::format("the terminal shows '{}'", leak));
    if (bytes_of_file(graded.out / "index.html").find(markup) != std::string::npos)
        found.emplace_back("the class page holds markup of a submission's");

    const auto report = graded.reports.find(attack.id());
    if (report == graded.reports.end()) {
        // A generator that gives the folder another name leaves nothing under this one.
        if (!attack.make.starts_with("renamed")) found.emplace_back("there is no report of it");
        return found;
    }
    const fs::path folder = graded.out / attack.id();
    Folder(attack, graded, folder, found).look();
    const auto good = graded.reports.find(good_ids().front());
    for (const auto& [id, expected] : attack.units) {
        const Json* unit = unit_in(report->second, id);
        if (unit == nullptr) {
            found.push_back(fmt::format("{}: its report has no such unit", id));
            continue;
        }
        if (unit->value("verdict", "") == to_string(Verdict::grader_fault))
            found.push_back(
                fmt::format("{}: a fault of the grader's: {}", id, unit->value("message", "").substr(0, 200)));
        const Json* model = good == graded.reports.end() ? nullptr : unit_in(good->second, id);
        if (model != nullptr && model->value("max_score", 0) != unit->value("max_score", 0))
            found.push_back(fmt::format("{}: it counts for {} instead of {}", id, unit->value("max_score", 0),
                                        model->value("max_score", 0)));
        look_at_unit(id, expected, *unit, found);
    }
    const Json for_student = Json::parse(bytes_of_file(folder / "report.student.json"), nullptr, false);
    if (for_student.is_object()) look_at_times(attack, for_student.value("submission", Json::object()), found);
    return found;
}

std::vector<std::string> changes_of_good(const Graded& before, const Graded& after)
{
    std::vector<std::string> changes;
    for (const std::string& id : good_ids()) {
        for (const char* const name : {"report.json", "report.student.json"}) {
            const auto read = [&](const Graded& graded) {
                const Json json = Json::parse(bytes_of_file(graded.out / id / name), nullptr, false);
                return json.is_object() ? without_times(json).dump(1, ' ', false, Json::error_handler_t::replace)
                                        : std::string();
            };
            const std::string one = read(before);
            const std::string other = read(after);
            if (one.empty() || other.empty()) changes.push_back(fmt::format("{}/{}: there is none", id, name));
            const auto [at, there] = std::ranges::mismatch(one, other);
            if (one == other) continue;
            const auto from = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, at - one.begin() - 100));
            changes.push_back(fmt::format("{}/{}: …{}… became …{}…", id, name,
                                          one.substr(std::min(from, one.size()), 200),
                                          other.substr(std::min(from, other.size()), 200)));
        }
    }
    return changes;
}

std::string outcome_of(const Attack& attack, const Graded& graded)
{
    if (!graded.complete()) return "no class.json";
    const auto report = graded.reports.find(attack.id());
    if (report == graded.reports.end()) return "refused";
    std::vector<std::string> parts;
    for (const auto& [id, expected] : attack.units)
        if (const Json* unit = unit_in(report->second, id))
            parts.push_back(fmt::format("{} {}", unit->value("verdict", ""), unit->value("score", 0.0) / 1000));
    return fmt::format("{}", fmt::join(parts, ", "));
}

}
