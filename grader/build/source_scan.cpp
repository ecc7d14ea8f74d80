#include "build/source_scan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "build/cpp_tokens.hpp"
#include "model/caps.hpp"

namespace umbral::grader {
namespace {

using Kind = CppToken::Kind;

template <std::size_t Size>
bool contains(const std::array<std::string_view, Size>& words, std::string_view word)
{
    return std::ranges::find(words, word) != words.end();
}

constexpr std::array<std::string_view, 3> asm_words{"asm", "__asm", "__asm__"};
constexpr std::array<std::string_view, 7> asm_qualifiers{"volatile",   "__volatile", "__volatile__", "inline",
                                                         "__inline__", "goto",       "const"};

/// Instructions that <immintrin.h> of GCC 12 writes as assembler, for lack of builtins; and two with what they read or
/// write.
constexpr std::array<std::string_view, 5> compilers_own{"pconfig", "encls", "enclu", "enclv", "tilerelease"};
constexpr std::array<std::string_view, 2> compilers_own_texts{"ldtilecfg\\t%X0", "sttilecfg\\t%X0"};

/// Attributes whose arguments or effects no unit needs: text for the assembler, code without its instrumentation,
/// variables that are left unfilled.
constexpr std::array<std::string_view, 9> attributes{"section",
                                                     "uninitialized",
                                                     "symver",
                                                     "naked",
                                                     "no_sanitize",
                                                     "no_sanitize_coverage",
                                                     "no_instrument_function",
                                                     "patchable_function_entry",
                                                     "no_profile_instrument_function"};
/// Attributes that name another symbol: a plain name is harmless, since every symbol is inspected.
constexpr std::array<std::string_view, 3> naming_attributes{"alias", "ifunc", "weakref"};

/// What the linker makes: from these, a program that walks its own tables finds all libraries and what they define.
constexpr std::array<std::string_view, 5> linkers_own{"_GLOBAL_OFFSET_TABLE_", "_PROCEDURE_LINKAGE_TABLE_", "_DYNAMIC",
                                                      "__ehdr_start", "__executable_start"};

constexpr const char* left_unfilled = "variables may not be left unfilled";

/// Options with which g++ leaves variables unfilled, some or all.
constexpr std::array<std::string_view, 5> unfilling{"auto-var-init", "tree-fre", "tree-sra", "lifetime-dse",
                                                    "elide-constructors"};

/// Does a text for the optimiser, of an attribute or a pragma, leave variables unfilled? What is spelt with escapes
/// may.
bool unfills(std::string_view options)
{
    std::string plain(options);
    std::erase_if(plain, [](char c) { return c == '"' || c == ' ' || c == '\t'; });
    return plain.find('\\') != plain.npos ||
           std::ranges::any_of(unfilling, [&](std::string_view option) { return plain.find(option) != plain.npos; });
}

/// What the strings in a line say, one behind the other, raw ones too; and the line as it is.
std::string strings_of(std::string_view line)
{
    std::string text;
    CppTokens tokens(line);
    for (CppToken token = tokens.next(); token.kind != Kind::end; token = tokens.next())
        if (token.kind == Kind::string) text += token.content();
    return text + '\n' + std::string(line);
}

/// Names that may stand before an assembler statement: before a label there is a declaration, with other names.
constexpr std::array<std::string_view, 13> before_statements{
    "if",        "else",   "do",     "while",         "for",           "switch",     "constexpr",
    "consteval", "extern", "export", "__extension__", "__attribute__", "__attribute"};

/// A name as assemblers take it, which can hold no directive and no version.
bool is_plain_name(std::string_view text)
{
    const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
    return !text.empty() && letter(text.front()) && std::ranges::all_of(text, [&](char c) {
        return letter(c) || (c >= '0' && c <= '9') || c == '.' || c == '$';
    });
}

/// "pconfig" of "pconfig\n\t" as written.
std::string_view first_word(std::string_view text)
{
    const std::size_t end = text.find_first_not_of("abcdefghijklmnopqrstuvwxyz");
    const std::string_view rest = end == std::string_view::npos ? std::string_view{} : text.substr(end);
    return rest.empty() || rest == "\\n\\t" ? text.substr(0, end) : std::string_view{};
}

/// "section" of "__section__".
std::string_view bare(std::string_view name)
{
    if (name.size() > 4 && name.starts_with("__") && name.ends_with("__")) return name.substr(2, name.size() - 4);
    return name;
}

class Scan {
public:
    Scan(std::string_view text, std::string_view header) : tokens_(text), header_(header) {}

    std::optional<std::string> run()
    {
        for (advance(); current_.kind != Kind::end && !found_;) step();
        return found_;
    }

private:
    void advance()
    {
        // Directives may stand between any two tokens.
        if (current_.kind != Kind::directive) {
            before_ = current_;
            follow(before_);
        }
        current_ = tokens_.next();
    }

    /// Keeps in mind whether a declaration has begun: whether, since the statement began, there was a name outside of
    /// brackets that begins one.
    void follow(const CppToken& token)
    {
        const std::string_view text = token.text;
        if (text == "{" || text == "}") {
            declares_ = false;
            if (text == "{") {
                outer_depths_.push_back(depth_);
                depth_ = 0;
            } else if (!outer_depths_.empty()) {
                depth_ = outer_depths_.back();
                outer_depths_.pop_back();
            }
        } else if (text == "(" || text == "[") {
            ++depth_;
        } else if (text == ")" || text == "]") {
            depth_ = std::max(0, depth_ - 1);
        } else if (depth_ == 0 && (text == ";" || text == ":")) {
            declares_ = false;
        } else if (depth_ == 0 && token.kind == Kind::name && text != "alignas" && !contains(before_statements, text)) {
            declares_ = true;
        }
    }

    void object(std::string what) { found_ = fmt::format("{}: {}", tokens_.place(), std::move(what)); }

    void object_to_table(std::string_view name) { object(fmt::format("the linker's {} is not allowed", name)); }

    void step()
    {
        if (current_.kind == Kind::directive) return check_directive();
        if (current_.kind == Kind::name && contains(asm_words, current_.text)) return check_asm();
        if (current_.kind == Kind::name && (current_.text == "__attribute__" || current_.text == "__attribute"))
            return check_attributes("(", ")");
        if (current_.text == "[" && before_.text == "[") return check_attributes("[", "]");
        if (current_.kind == Kind::name && contains(linkers_own, current_.text)) return object_to_table(current_.text);
        advance();
    }

    /// `asm qualifiers ( "text" …`: a label with a plain name, or the compiler's own.
    void check_asm()
    {
        // A label stands behind the name of what it labels, or its brackets.
        const bool behind_a_name =
            declares_ && (before_.text == ")" || before_.text == "]" ||
                          (before_.kind == Kind::name && !contains(before_statements, before_.text)));
        advance();
        while (current_.kind == Kind::name && contains(asm_qualifiers, current_.text)) advance();
        if (current_.text != "(") return object("assembler is not allowed");
        std::string text;
        for (advance(); current_.kind == Kind::string; advance()) text += current_.content();
        const bool label = behind_a_name && current_.text == ")" && is_plain_name(text);
        const bool is_own = contains(compilers_own, first_word(text)) || contains(compilers_own_texts, text);
        if (!label && !is_own) object("assembler is not allowed");
        if (label && contains(linkers_own, text)) object_to_table(text);
    }

    void check_attribute_text(std::string_view attribute, const std::string& text)
    {
        if (contains(linkers_own, text)) return object_to_table(text);
        if (attribute == "optimize" && unfills(text)) object(left_unfilled);
    }

    /// Everything up to the bracket that closes what is open.
    void check_attributes(std::string_view open, std::string_view close)
    {
        if (open == "(") advance();
        int depth = 0;
        std::string_view named;
        std::string text;  // strings behind each other are one
        for (; current_.kind != Kind::end && !found_; advance()) {
            if (current_.text == open) ++depth;
            if (current_.text == close && --depth <= 0) break;
            if (current_.kind == Kind::name && contains(attributes, bare(current_.text)))
                return object(fmt::format("the attribute {} is not allowed", bare(current_.text)));
            if (current_.kind == Kind::name && contains(asm_words, current_.text))
                return object("assembler is not allowed");
            if (current_.kind == Kind::string) {
                text += current_.content();
                if (contains(naming_attributes, named) && !is_plain_name(current_.content()))
                    return object(fmt::format("the attribute {} takes a plain name", named));
            } else if (current_.kind != Kind::directive) {
                // Looked at once, when it is whole: there may be a million strings behind each other.
                check_attribute_text(named, text);
                text.clear();
            }
            if (current_.kind == Kind::name) named = bare(current_.text);
        }
        if (!found_) check_attribute_text(named, text);
        if (!found_) advance();
    }

    /// Line markers and what the compiler is told; `#ident` and its like are written out as they are.
    void check_directive()
    {
        std::string_view line = current_.text.substr(1);
        const auto word = [&] {
            line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
            const std::string_view first = line.substr(0, line.find_first_of(" \t\""));
            line.remove_prefix(first.size());
            return first;
        };
        const std::string_view kind = word();
        const bool marker = !kind.empty() && kind.front() >= '0' && kind.front() <= '9';
        if (kind == "pragma") {
            const std::string_view whose = word();
            const std::string_view what = word();
            if (whose == "GCC" && what.starts_with("optimize") && unfills(strings_of(line)))
                return object(left_unfilled);
            if (whose == "GCC" && what == "pch_preprocess" && line != fmt::format(" \"{}\"", header_))
                return object("a precompiled header of your own is not allowed");
        } else if (!marker && kind != "line" && !kind.empty()) {
            return object(fmt::format("the directive #{} is not allowed", one_line(kind, 32)));
        }
        advance();
    }

    CppTokens tokens_;
    std::string_view header_;
    CppToken before_;
    CppToken current_;
    bool declares_ = false;
    int depth_ = 0;                  ///< of brackets that are open, within the innermost braces
    std::vector<int> outer_depths_;  ///< and within those around them
    std::optional<std::string> found_;
};

}

std::optional<std::string> find_unclosed(std::string_view text)
{
    CppTokens tokens(text);
    for (CppToken token = tokens.next(); token.kind != Kind::end; token = tokens.next())
        if (token.kind == Kind::broken)
            return fmt::format("{}: error: a character or a string that is not closed in its line", tokens.place());
    return std::nullopt;
}

std::optional<std::string> find_assembler(std::string_view text, std::string_view header)
{
    return Scan(text, header).run();
}

}
