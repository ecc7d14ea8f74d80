#include "store/mark.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "model/recording.hpp"
#include "store/refused_folder.hpp"
#include "store/temporaries.hpp"
#include "text/field.hpp"
#include "text/json_file.hpp"
#include "text/printable.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

constexpr const char* mark_format = "umbral-reports";
constexpr std::size_t longest = 4096;

}

std::string to_text(const Mark& mark)
{
    nlohmann::json json{{"format", mark_format},
                        {"version", 1},
                        {"about", "Umbral made this folder, and may replace or delete what lies in it."},
                        {"course", printable(mark.grading.course, longest)},
                        {"attempt", mark.grading.attempt},
                        {"secret", mark.grading.secret},
                        {"submission", mark.submission},
                        {"shown", printable(mark.shown, longest)},
                        {"reports", mark.reports}};
    if (!mark.source.empty()) json["source"] = printable(mark.source, longest);
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::optional<Mark> read_mark(const fs::path& folder)
{
    const fs::path file = folder / mark_name;
    if (!fs::exists(fs::symlink_status(file))) return std::nullopt;
    try {
        if (fs::is_symlink(fs::symlink_status(file))) throw std::runtime_error(file.string() + ": it is a link");
        const nlohmann::json json = read_json(file);
        const Field field(json, file.string());
        if (field.member("format").any_text(longest) != mark_format)
            field.member("format").refuse(fmt::format("\"{}\"", mark_format));
        (void)field.member("version").integer(1, 1);
        field.allow_only(
            {"format", "version", "about", "course", "attempt", "secret", "submission", "shown", "source", "reports"});
        Mark mark;
        mark.grading.course = field.member("course").any_text(longest);
        mark.grading.attempt =
            static_cast<unsigned>(field.member("attempt").number(0, std::numeric_limits<unsigned>::max()));
        mark.grading.secret = field.member("secret").any_text(longest);
        mark.submission = field.member("submission").any_text(longest);
        mark.shown = field.member("shown").any_text(longest);
        if (const Field source = field.member("source"); source.given()) mark.source = source.any_text(longest);
        mark.reports = field.member("reports").any_text(longest);
        return mark;
    } catch (const std::exception& error) {
        throw RefusedFolder(
            fmt::format("{}; this file should say that Umbral made the folder. Move the folder away, or name another",
                        error.what()));
    }
}

bool is_untouched(const fs::path& folder)
{
    return std::ranges::all_of(fs::directory_iterator(folder), [](const fs::directory_entry& entry) {
        return fs::is_regular_file(entry.symlink_status()) && is_temporary(entry.path().filename().string(), mark_name);
    });
}

}
