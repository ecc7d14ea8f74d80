#include "store/temporaries.hpp"

#include <algorithm>

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

bool all_digits(std::string_view text)
{
    return !text.empty() && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

}

bool is_temporary(std::string_view name, std::string_view target)
{
    constexpr std::string_view sign = ".tmp-";  // "class.json.tmp-4711-0": the process, and a number of its own
    const std::size_t at = name.rfind(sign);
    if (at == std::string_view::npos || at == 0 || (!target.empty() && name.substr(0, at) != target)) return false;
    const std::string_view numbers = name.substr(at + sign.size());
    const std::size_t dash = numbers.find('-');
    return dash != std::string_view::npos && all_digits(numbers.substr(0, dash)) &&
           all_digits(numbers.substr(dash + 1));
}

void remove_temporaries(const fs::path& folder, std::string_view target) noexcept
{
    try {
        for (const auto& entry : fs::directory_iterator(folder))
            if (fs::is_regular_file(entry.symlink_status()) && is_temporary(entry.path().filename().string(), target))
                fs::remove(entry.path());
    } catch (const std::exception&) {  // they disturb nobody
    }
}

}
