#include "run/run_text.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

namespace umbral::grader {
namespace {

bool within_name(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '.';
}

/// How much of `text` is taken away at its start, where a path begins: a root and the slash behind it.
std::size_t root_at(std::string_view text, std::span<const std::string> roots)
{
    std::size_t longest = 0;
    for (const std::string& root : roots) {
        if (root.size() <= 1 || !text.starts_with(root)) continue;
        const bool whole = text.size() == root.size() || root.back() == '/' || !within_name(text[root.size()]);
        if (!whole) continue;
        const bool slash = root.back() != '/' && text.size() > root.size() && text[root.size()] == '/';
        longest = std::max(longest, root.size() + (slash ? 1 : 0));
    }
    return longest;
}

}

std::string without_roots(std::string_view text, std::span<const std::string> roots)
{
    std::string result;
    result.reserve(text.size());
    for (std::size_t i = 0; i < text.size();) {
        // A root counts at the beginning of a path only: "/mnt/work" does not begin with "/work".
        const bool begins = text[i] == '/' && (i == 0 || !within_name(text[i - 1]));
        const std::size_t taken = begins ? root_at(text.substr(i), roots) : 0;
        if (taken == 0) result += text[i];
        i += std::max<std::size_t>(taken, 1);
    }
    return result;
}

}
