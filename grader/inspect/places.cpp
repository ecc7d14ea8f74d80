#include "inspect/places.hpp"

#include <dwarf.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string_view>

#include "inspect/units.hpp"
#include "model/caps.hpp"

namespace umbral::grader {
namespace {

/// A file of the student's own: those lie where the compiler worked, and no other does.
bool is_own(Dwarf_Die* unit, const char* file)
{
    Dwarf_Attribute attribute;
    const char* const folder = dwarf_formstring(dwarf_attr(unit, DW_AT_comp_dir, &attribute));
    const std::string_view path(file);
    const std::size_t slash = path.rfind('/');
    if (slash == std::string_view::npos || path.substr(0, slash) == ".") return true;
    return folder != nullptr && path.substr(0, slash) == folder;
}

OwnPlace place(const char* file, std::uint64_t line, std::uint64_t column)
{
    const std::string_view path(file, strnlen(file, caps::symbol));
    const std::size_t slash = path.rfind('/');
    return {std::string(path.substr(slash == std::string_view::npos ? 0 : slash + 1).substr(0, caps::name)), line,
            column};
}

std::optional<std::uint64_t> number_in(Dwarf_Die* die, unsigned name)
{
    Dwarf_Attribute attribute;
    Dwarf_Word number = 0;
    if (dwarf_attr(die, name, &attribute) == nullptr || dwarf_formudata(&attribute, &number) != 0) return std::nullopt;
    return number;
}

/// Where a function that was inlined at `address`, as one of a library's header, was called by the student's own code.
std::optional<OwnPlace> place_of_call(Dwarf_Die* unit, Dwarf_Addr address)
{
    Dwarf_Die* scopes = nullptr;
    const int count = dwarf_getscopes(unit, address, &scopes);
    const std::unique_ptr<Dwarf_Die, decltype(&std::free)> owner(scopes, &std::free);
    Dwarf_Files* files = nullptr;
    if (count <= 0 || dwarf_getsrcfiles(unit, &files, nullptr) != 0) return {};
    for (int i = 0; i < count; ++i) {
        if (dwarf_tag(&scopes[i]) != DW_TAG_inlined_subroutine) continue;
        const auto file = number_in(&scopes[i], DW_AT_call_file);
        const auto line = number_in(&scopes[i], DW_AT_call_line);
        const char* name = file && line ? dwarf_filesrc(files, *file, nullptr, nullptr) : nullptr;
        if (name == nullptr || !is_own(unit, name)) continue;
        return place(name, *line, number_in(&scopes[i], DW_AT_call_column).value_or(0));
    }
    return {};
}

/// The line, or another at the same address: where no instruction is left of a line, the next one begins there too.
std::optional<OwnPlace> own_line(Dwarf_Die* unit, Dwarf_Line* line)
{
    Dwarf_Lines* lines = nullptr;
    std::size_t count = 0;
    Dwarf_Addr wanted = 0;
    if (dwarf_getsrclines(unit, &lines, &count) != 0 || dwarf_lineaddr(line, &wanted) != 0) return {};
    std::optional<OwnPlace> found;
    for (std::size_t i = 0; i < count; ++i) {
        Dwarf_Line* const one = dwarf_onesrcline(lines, i);
        Dwarf_Addr address = 0;
        int number = 0;
        int column = 0;
        if (dwarf_lineaddr(one, &address) != 0 || address != wanted || dwarf_lineno(one, &number) != 0) continue;
        const char* const file = dwarf_linesrc(one, nullptr, nullptr);
        if (file == nullptr || !is_own(unit, file)) continue;
        if (dwarf_linecol(one, &column) != 0) column = 0;
        found = place(file, static_cast<std::uint64_t>(number), static_cast<std::uint64_t>(column));
    }
    return found;
}

}

std::optional<OwnPlace> place_in_own_files(Dwarf* dwarf, Dwarf_Addr address)
{
    std::optional<OwnPlace> found;
    (void)for_each_unit(dwarf, [&](Dwarf_Die* unit) {
        Dwarf_Line* line = dwarf_getsrc_die(unit, address);
        if (line == nullptr) return false;
        found = own_line(unit, line);
        if (!found) found = place_of_call(unit, address);
        return found.has_value();
    });
    return found;
}

}
