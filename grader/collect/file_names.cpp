#include "collect/file_names.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace umbral::grader {
namespace {

using Words = std::span<const std::string_view>;

constexpr std::array<std::string_view, 4> source_suffixes{".cpp", ".cc", ".cxx", ".c++"};
constexpr std::array<std::string_view, 4> header_suffixes{".hpp", ".h", ".hh", ".hxx"};
constexpr std::array<std::string_view, 5> shader_suffixes{".glsl", ".vert", ".frag", ".geom", ".comp"};
/// A .rar is none that can be opened, and is told so.
constexpr std::array<std::string_view, 10> archive_suffixes{".tar.gz", ".tar.bz2", ".tar.xz", ".tgz", ".tbz2",
                                                            ".txz",    ".tar",     ".zip",    ".7z",  ".rar"};
constexpr std::array<std::string_view, 7> junk{"__macosx", "cmakefiles",      "node_modules", "deriveddata",
                                               "_deps",    "umbral-pictures", "__pycache__"};
/// What downloads, file managers and people put behind the name of a copy, after the separators were taken out, with
/// any number behind …
constexpr std::array<std::string_view, 3> copy_endings{"copy", "copia", "copie"};
/// … and in front.
constexpr std::array<std::string_view, 3> copy_beginnings{"copyof", "copiade", "copiede"};

std::string lower(std::string_view text)
{
    std::string result(text);
    std::ranges::transform(result, result.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return result;
}

/// The suffix among `suffixes` that `name` (in lower case) has behind at least one character; empty if none.
std::string_view suffix_among(std::string_view name, Words suffixes)
{
    const auto found = std::ranges::find_if(
        suffixes, [&](std::string_view suffix) { return name.size() > suffix.size() && name.ends_with(suffix); });
    return found == suffixes.end() ? std::string_view() : *found;
}

/// "C" in upper case alone is C++; in lower case it is C.
bool is_capital_c(std::string_view name) { return name.size() > 2 && name.ends_with(".C"); }

bool is_digit(char c) { return c >= '0' && c <= '9'; }

FileKind kind_by_suffix(std::string_view name)
{
    if (is_capital_c(name)) return FileKind::source;
    const std::string low = lower(name);
    if (!suffix_among(low, source_suffixes).empty()) return FileKind::source;
    if (!suffix_among(low, header_suffixes).empty()) return FileKind::header;
    if (!suffix_among(low, shader_suffixes).empty()) return FileKind::shader;
    if (!suffix_among(low, archive_suffixes).empty()) return FileKind::archive;
    return FileKind::other;
}

/// Mail programs and editors put ".txt" behind suffixes that they do not know: "sphere.cpp.txt".
std::string_view without_txt(std::string_view name)
{
    if (!lower(name).ends_with(".txt")) return name;
    const std::string_view rest = name.substr(0, name.size() - 4);
    return is_code(kind_by_suffix(rest)) ? rest : name;
}

/// Takes one "(12)" off the end.
bool strip_number_in_brackets(std::string& stem)
{
    if (!stem.ends_with(')')) return false;
    const std::size_t open = stem.rfind('(');
    if (open == std::string::npos || open == 0 || open + 2 >= stem.size()) return false;
    if (!std::all_of(stem.begin() + static_cast<std::ptrdiff_t>(open) + 1, stem.end() - 1, is_digit)) return false;
    stem.resize(open);
    return true;
}

/// Takes one "copy" or "copy2" off the end.
bool strip_copy_ending(std::string& stem)
{
    std::string_view rest = stem;
    while (!rest.empty() && is_digit(rest.back())) rest.remove_suffix(1);
    const std::string_view ending = suffix_among(rest, copy_endings);
    if (ending.empty()) return false;
    stem.resize(rest.size() - ending.size());
    return true;
}

bool strip_copy_beginning(std::string& stem)
{
    for (const std::string_view word : copy_beginnings) {
        if (stem.size() <= word.size() || !stem.starts_with(word)) continue;
        stem.erase(0, word.size());
        return true;
    }
    return false;
}

/// The part of a name before its suffix, as file_key() compares it.
std::string stem_key(std::string_view stem)
{
    std::string key = lower(stem);
    std::erase_if(key, [](char c) { return c == ' ' || c == '-' || c == '_'; });
    while (strip_number_in_brackets(key) || strip_copy_ending(key) || strip_copy_beginning(key)) {
    }
    return key;
}

}

FileKind kind_of(std::string_view name) { return kind_by_suffix(without_txt(name)); }

bool is_junk(std::string_view name)
{
    return name.starts_with('.') || std::ranges::find(junk, lower(name)) != junk.end();
}

bool is_framework_copy(std::string_view folder)
{
    return folder == "include/umbral" || folder.ends_with("/include/umbral");
}

std::string_view last_part(std::string_view path)
{
    const std::size_t slash = path.rfind('/');
    return slash == std::string_view::npos ? path : path.substr(slash + 1);
}

std::string_view parent_part(std::string_view path)
{
    const std::size_t slash = path.rfind('/');
    return slash == std::string_view::npos ? std::string_view() : path.substr(0, slash);
}

std::string_view without_archive_suffix(std::string_view name)
{
    const std::string low = lower(name);
    return name.substr(0, name.size() - suffix_among(low, archive_suffixes).size());
}

std::string file_key(std::string_view name)
{
    name = without_txt(name);
    const std::string low = lower(name);
    const std::string_view source = is_capital_c(name) ? std::string_view(".C") : suffix_among(low, source_suffixes);
    if (!source.empty()) return stem_key(name.substr(0, name.size() - source.size())) + ".cpp";
    const std::size_t dot = std::min(low.rfind('.'), low.size());
    return stem_key(std::string_view(low).substr(0, dot)) + low.substr(dot);
}

std::string folder_key(std::string_view name) { return stem_key(name); }

}
