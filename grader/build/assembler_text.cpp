#include "build/assembler_text.hpp"

#include <algorithm>
#include <array>

namespace umbral::grader {
namespace {

/// All that compilers write for C++ and its debug information, beside `.section` and those that begin with ".cfi_".
constexpr std::array<std::string_view, 55> directives{
    ".2byte",       ".4byte",       ".8byte",   ".addrsig", ".addrsig_sym", ".align",   ".arch",       ".ascii",
    ".asciz",       ".balign",      ".bss",     ".byte",    ".comm",        ".cpu",     ".data",       ".dword",
    ".file",        ".globl",       ".half",    ".hidden",  ".hword",       ".ident",   ".inst",       ".int",
    ".internal",    ".local",       ".loc",     ".long",    ".octa",        ".p2align", ".popsection", ".previous",
    ".protected",   ".pushsection", ".quad",    ".rodata",  ".set",         ".short",   ".size",       ".sleb128",
    ".string",      ".tbss",        ".tdata",   ".text",    ".tlsdesccall", ".type",    ".uleb128",    ".value",
    ".variant_pcs", ".weak",        ".weakref", ".word",    ".xword",       ".zero",    ".zerofill"};

/// Sections of C++, with those of functions and variables of their own (".text._Z1fv").
constexpr std::array<std::string_view, 11> sections{".text",
                                                    ".data",
                                                    ".rodata",
                                                    ".bss",
                                                    ".tdata",
                                                    ".tbss",
                                                    ".init_array",
                                                    ".fini_array",
                                                    ".gcc_except_table",
                                                    ".note.GNU-stack",
                                                    ".note.gnu.property"};
constexpr std::string_view debug_sections = ".debug_";

bool is_blank(char c) { return c == ' ' || c == '\t'; }

std::string_view without_blanks(std::string_view line)
{
    while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
    while (!line.empty() && (is_blank(line.back()) || line.back() == '\r')) line.remove_suffix(1);
    return line;
}

std::string_view operation_of(std::string_view line)
{
    return line.substr(0, static_cast<std::size_t>(std::ranges::find_if(line, is_blank) - line.begin()));
}

/// One statement, whose strings are closed, perhaps with a comment behind it?
bool is_one_statement(std::string_view line)
{
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (quoted && c == '\\') {
            ++i;
        } else if (c == '"') {
            quoted = !quoted;
        } else if (!quoted) {
            if (c == '#') return true;
            if (c == ';' || (c == '/' && line.substr(i + 1).starts_with('*'))) return false;
        }
    }
    return !quoted;
}

/// Identifiers may hold any letter of UTF-8, whose bytes beyond ASCII separate nothing for an assembler.
bool is_label(std::string_view line)
{
    return line.ends_with(':') && std::ranges::all_of(line.substr(0, line.size() - 1), [](char c) {
               return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
                      c == '.' || c == '$' || c == '@' || static_cast<unsigned char>(c) >= 0x80;
           });
}

bool is_instruction(std::string_view line)
{
    // How the instruction that follows is to be written.
    for (const std::string_view encoding : {"{vex} ", "{evex} "})
        if (line.starts_with(encoding)) line.remove_prefix(encoding.size());
    const std::string_view name = operation_of(line);
    return name.front() >= 'a' && name.front() <= 'z' && std::ranges::all_of(name, [](char c) {
               return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '.';
           });
}

/// `.section .rodata.str1.1,"aMS",@progbits,1`: of C++, or of debug information, which no program sees in memory.
bool is_known_section(std::string_view line)
{
    const std::string_view arguments = without_blanks(line.substr(operation_of(line).size()));
    const std::size_t comma = std::min(arguments.find(','), arguments.size());
    const std::string_view name = arguments.substr(0, comma);
    const std::string_view rest = arguments.substr(comma);
    if (name.starts_with(debug_sections)) {
        const std::string_view flags = rest.substr(0, rest.find('"', 2));
        return flags.find_first_of("awx") == std::string_view::npos;
    }
    return std::ranges::any_of(sections, [&](std::string_view known) {
        return name.starts_with(known) && (name.size() == known.size() || name[known.size()] == '.');
    });
}

bool is_known_directive(std::string_view line)
{
    const std::string_view name = operation_of(line);
    if (name == ".section" || name == ".pushsection") return is_known_section(line);
    return name.starts_with(".cfi_") || std::ranges::find(directives, name) != directives.end();
}

bool is_of_compilers(std::string_view line)
{
    if (line.empty() || line.front() == '#') return true;
    if (!is_one_statement(line)) return false;
    if (is_label(line)) return true;
    return line.front() == '.' ? is_known_directive(line) : is_instruction(line);
}

/// "a.cpp:12: " of `# 12 "a.cpp" 1`, which g++ writes behind "#APP".
std::string place_of(std::string_view marker)
{
    const std::size_t open = marker.find('"');
    if (open == std::string_view::npos) return {};
    const std::size_t close = std::min(marker.find('"', open + 1), marker.size());
    const std::string_view line = without_blanks(marker.substr(1, open - 1));
    return std::string(marker.substr(open + 1, close - open - 1)) + ":" + std::string(line) + ": ";
}

}

std::optional<std::string> find_foreign_assembler(std::string_view text)
{
    bool by_hand = false;
    std::string place;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = without_blanks(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line == "#APP")
            by_hand = true;
        else if (by_hand && line.starts_with("# "))
            place = place_of(line);
        else if (by_hand || !is_of_compilers(line))
            return place + std::string(line.substr(0, 80));
    }
    return by_hand ? std::optional<std::string>(place) : std::nullopt;
}

}
