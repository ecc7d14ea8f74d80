#include <algorithm>

#include "run/path_gate.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

/// Is `path` the folder `above` or below it?
bool is_below(std::string_view path, std::string_view above)
{
    return path.starts_with(above) && (path.size() == above.size() || path[above.size()] == '/' || above == "/");
}

/// Debian's /lib is a link to /usr/lib, and so on: one name for both.
std::string without_old_roots(std::string path)
{
    for (const std::string_view old : {"/lib64", "/lib", "/bin", "/sbin"})
        if (is_below(path, old)) return "/usr" + path;
    return path;
}

/// Without `..`, as the kernel takes it out: behind a link it is the folder above the one that the link leads to.
fs::path without_parents(const fs::path& path)
{
    fs::path result;
    for (const fs::path& part : path) {
        if (part == "." || part.empty()) continue;
        if (part != "..") {
            result /= part;
            continue;
        }
        std::error_code unknown;
        if (fs::is_symlink(result, unknown)) {
            fs::path target = fs::canonical(result, unknown);
            // Of one that leads nowhere there is nothing above.
            if (!unknown) result = std::move(target);
        }
        result = result.parent_path();
    }
    return result;
}

std::string normal(const fs::path& path)
{
    std::string text = without_parents(path).lexically_normal().string();
    while (text.size() > 1 && text.back() == '/') text.pop_back();
    return without_old_roots(std::move(text));
}

}

PathRules::PathRules(fs::path directory, std::span<const std::string> rules) : directory_(std::move(directory))
{
    trees_.push_back(normal(directory_));
    for (const std::string& rule : rules) {
        if (rule.ends_with("/*"))
            folders_.push_back(normal(rule.substr(0, rule.size() - 2)));
        else
            trees_.push_back(normal(rule));
    }
}

bool PathRules::admits(std::string_view asked) const
{
    const std::string path = normal(fs::path(asked).is_absolute() ? fs::path(asked) : directory_ / asked);
    const auto above_or_in = [&](const std::string& tree) { return is_below(path, tree) || is_below(tree, path); };
    if (std::ranges::any_of(trees_, above_or_in)) return true;
    return std::ranges::any_of(folders_, [&](const std::string& folder) {
        return is_below(folder, path) ||
               (is_below(path, folder) && path.find('/', folder.size() + 1) == std::string::npos);
    });
}

}
