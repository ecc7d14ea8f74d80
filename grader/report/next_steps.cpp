#include "report/next_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace umbral::grader {
namespace {

/// What makes `umbral debug` stop at the call behind a check's first wrong value.
std::string row_option(const UnitResult& unit, const CheckResult& failing)
{
    const auto& first = failing.first_difference;
    if (!first || !first->cell || first->question.empty()) return "";
    const std::string case_name = failing.name.substr(0, failing.name.rfind('/') + 1);
    const auto same_case =
        std::ranges::find_if(unit.checks, [&](const CheckResult& one) { return one.name.starts_with(case_name); });
    const std::string value = failing.name.substr(case_name.size());
    return fmt::format(" --row {}{}", *first->cell,
                       same_case->name == failing.name ? "" : " --value " + shell_word(value));
}

}

std::vector<std::string> next_steps(const UnitResult& unit, const CheckResult* failing, const std::string& folder,
                                    const Paint& paint)
{
    const std::string id = shell_word(unit.id);
    const std::string in_folder = folder_option(folder);
    std::vector<std::string> steps;
    switch (unit.verdict) {
        case Verdict::grader_fault:
            return {"This is the grader's fault, not yours: please show this report to your instructor."};
        case Verdict::missing:
            return {fmt::format("umbral reset {}{}   puts the file to write back in its place", paint.safe(id),
                                paint.safe(in_folder))};
        case Verdict::compile_error:
        case Verdict::interface_mismatch:
        case Verdict::forbidden: steps.push_back(fmt::format("umbral check {}{}", id, in_folder)); break;
        case Verdict::not_implemented: break;
        default: {
            // To stop at a call that is answered rightly leads nowhere.
            if (failing == nullptr ? std::ranges::any_of(unit.checks, fails) : failing->beside) break;
            const std::string name =
                failing != nullptr ? shell_word(failing->name.substr(0, failing->name.rfind('/'))) : "";
            steps.push_back(fmt::format("umbral debug {}{}{}{}{}", id, name.empty() ? "" : " ", name,
                                        failing == nullptr ? "" : row_option(unit, *failing), in_folder));
        }
    }
    steps.push_back(fmt::format("umbral hint {}{}", id, in_folder));
    for (std::string& step : steps) step = paint(Tone::strong, paint.safe(step));
    return steps;
}

std::string shell_word(std::string_view text)
{
    const auto plain = [](unsigned char c) {
        return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.' || c == '/';
    };
    if (!text.empty() && std::ranges::all_of(text, plain)) return std::string(text);
    std::string word = "'";
    for (const char c : text) c == '\'' ? word += "'\\''" : word += c;
    return fmt::format("{}'", word);
}

std::string folder_option(const std::string& folder)
{
    return folder.empty() || folder == "." ? "" : " --dir " + shell_word(folder);
}

}
