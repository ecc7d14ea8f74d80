#include "build/cpp_tokens.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "model/caps.hpp"

namespace umbral::grader {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Bytes of UTF-8 count as letters, as the compiler takes most of them.
bool is_name_start(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '$' ||
           static_cast<unsigned char>(c) >= 0x80;
}

bool is_name(char c) { return is_name_start(c) || is_digit(c); }

/// What a ' between digits may stand before: of names only letters of ASCII, and no $.
bool is_behind_separator(char c) { return is_name(c) && c != '$' && static_cast<unsigned char>(c) < 0x80; }

/// "\U0001F600" with its first quote; what is longer is none.
constexpr std::size_t longest_character = 12;

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\r'; }

/// Is this what may stand before a string's first quote: L, u, U, u8, each with an R for a raw one?
bool is_string_prefix(std::string_view name)
{
    if (name.ends_with('R')) name.remove_suffix(1);
    return name.empty() || name == "L" || name == "u" || name == "U" || name == "u8";
}

}

std::string_view CppToken::content() const
{
    const std::size_t open = text.find('"');
    const std::size_t close = text.rfind('"');
    if (kind != Kind::string || open == std::string_view::npos || close <= open) return {};
    std::string_view inside = text.substr(open + 1, close - open - 1);
    if (open == 0 || text[open - 1] != 'R') return inside;
    const std::size_t from = inside.find('(');
    const std::size_t to = inside.rfind(')');
    return from == std::string_view::npos || to == std::string_view::npos || to < from
               ? std::string_view{}
               : inside.substr(from + 1, to - from - 1);
}

CppToken CppTokens::next()
{
    while (!text_.empty()) {
        const char c = text_.front();
        if (c == '\n') {
            ++line_;
            at_line_start_ = true;
            text_.remove_prefix(1);
        } else if (is_space(c)) {
            text_.remove_prefix(1);
        } else {
            break;
        }
    }
    if (text_.empty()) return {};
    const bool first = std::exchange(at_line_start_, false);
    const char c = text_.front();
    if (first && c == '#') return take_directive();
    if (is_name_start(c)) {
        const auto end = std::ranges::find_if_not(text_, is_name);
        const auto size = static_cast<std::size_t>(end - text_.begin());
        if (at(size) == '"' && is_string_prefix(text_.substr(0, size)))
            return text_[size - 1] == 'R' ? take_raw_string(size) : take_string(size);
        return take(CppToken::Kind::name, size);
    }
    if (is_digit(c) || (c == '.' && is_digit(at(1)))) {
        // A number goes on over letters, points, ' between digits, and a sign behind an exponent.
        std::size_t size = 1;
        const auto goes_on = [&] {
            const char before = at(size - 1);
            const bool exponent = before == 'e' || before == 'E' || before == 'p' || before == 'P';
            return is_name(at(size)) || at(size) == '.' || (at(size) == '\'' && is_behind_separator(at(size + 1))) ||
                   (exponent && (at(size) == '+' || at(size) == '-'));
        };
        while (size < text_.size() && goes_on()) ++size;
        return take(CppToken::Kind::number, size);
    }
    if (c == '"' || c == '\'') return take_string(0);
    return take_other();
}

CppToken CppTokens::take_other()
{
    struct Digraph {
        std::string_view written;
        std::string_view meant;
    };
    constexpr std::array<Digraph, 4> digraphs{{{"<:", "["}, {":>", "]"}, {"<%", "{"}, {"%>", "}"}}};
    // As the language has it: "<::" begins with no digraph, unless another : or > follows.
    const bool scope = text_.starts_with("<::") && at(3) != ':' && at(3) != '>';
    for (const Digraph& one : digraphs) {
        if (scope || !text_.starts_with(one.written)) continue;
        text_.remove_prefix(one.written.size());
        return {CppToken::Kind::other, one.meant};
    }
    return take(CppToken::Kind::other, 1);
}

CppToken CppTokens::take(CppToken::Kind kind, std::size_t size)
{
    const CppToken token{kind, text_.substr(0, size)};
    line_ += static_cast<std::size_t>(std::ranges::count(token.text, '\n'));
    text_.remove_prefix(token.text.size());
    return token;
}

CppToken CppTokens::take_directive()
{
    const CppToken token = take(CppToken::Kind::directive, std::min(text_.find('\n'), text_.size()));
    follow_marker(token.text);
    return token;
}

CppToken CppTokens::take_string(std::size_t prefix)
{
    const char quote = text_[prefix];
    std::size_t end = prefix + 1;
    while (end < text_.size() && text_[end] != quote && text_[end] != '\n')
        end += text_[end] == '\\' && at(end + 1) != '\n' ? 2U : 1U;
    const bool closed = at(end) == quote;
    // A character is one, an escape, or up to four that make a number.
    const bool fits = quote == '"' || end - prefix <= longest_character;
    if (closed) ++end;
    if (!closed || !fits) return take(CppToken::Kind::broken, end);
    return take(quote == '"' ? CppToken::Kind::string : CppToken::Kind::other, end);
}

CppToken CppTokens::take_raw_string(std::size_t prefix)
{
    const std::size_t parenthesis = text_.substr(0, prefix + 18).find('(', prefix);
    // The mark between quote and parenthesis has at most 16 characters.
    if (parenthesis == std::string_view::npos || parenthesis > prefix + 17) return take_string(prefix);
    const std::string closing = fmt::format("){}\"", text_.substr(prefix + 1, parenthesis - prefix - 1));
    const std::size_t end = text_.find(closing, parenthesis);
    return end == std::string_view::npos ? take(CppToken::Kind::broken, text_.size())
                                         : take(CppToken::Kind::string, end + closing.size());
}

void CppTokens::follow_marker(std::string_view line)
{
    line.remove_prefix(1);
    while (!line.empty() && is_space(line.front())) line.remove_prefix(1);
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), number);
    if (error != std::errc{}) return;
    const std::size_t open = line.find('"');
    const std::size_t close = line.find('"', open + 1);
    if (open == std::string_view::npos || close == std::string_view::npos) return;
    file_ = line.substr(open + 1, close - open - 1);
    // The marker names the line behind its own.
    line_ = number - std::min<std::size_t>(number, 1);
}

std::string CppTokens::place() const
{
    const std::size_t slash = file_.rfind('/');
    return fmt::format("{}:{}", one_line(slash == std::string_view::npos ? file_ : file_.substr(slash + 1)), line_);
}

}
