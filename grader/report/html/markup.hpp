#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "text/escape.hpp"

namespace umbral::grader::html {

/// HTML that is safe to put into a page. There are three ways to make one: from a literal of ours, by markup(…) below,
/// and by joining others; text from outside cannot get in unescaped, because it would not compile.
class Markup {
public:
    Markup() = default;
    /// A literal: the compiler must know its characters.
    consteval Markup(const char* literal) : literal_(literal) {}

    [[nodiscard]] std::string_view view() const noexcept { return text_ ? std::string_view(*text_) : literal_; }
    [[nodiscard]] bool empty() const noexcept { return view().empty(); }
    Markup& operator+=(const Markup& other)
    {
        if (!text_) text_ = literal_;
        *text_ += other.view();
        return *this;
    }

private:
    template <class... Arguments>
    friend Markup format_markup(std::string_view form, const Arguments&... arguments);
    friend Markup escaped(std::string_view text);
    friend Markup of_our_own(std::string text);

    std::string_view literal_;
    std::optional<std::string>
        text_;  ///< where it is no literal; optional, since a constant expression cannot hold a string
};

/// Text from outside, escaped.
[[nodiscard]] inline Markup escaped(std::string_view text)
{
    Markup result;
    result.text_ = escape_html(text);
    return result;
}

/// Files of this folder (styles, scripts), encoded bytes, and markup that was turned into text before: what holds
/// nothing to escape. Never for text from outside.
[[nodiscard]] inline Markup of_our_own(std::string text)
{
    Markup result;
    result.text_ = std::move(text);
    return result;
}

template <class... Arguments>
[[nodiscard]] Markup format_markup(std::string_view form, const Arguments&... arguments)
{
    Markup result;
    result.text_ = fmt::vformat(form, fmt::make_format_args(arguments...));
    return result;
}

/// What an argument of markup(…) becomes: markup and numbers stay, everything else is escaped.
[[nodiscard]] inline std::string_view argument(const Markup& value) { return value.view(); }
[[nodiscard]] inline std::string argument(std::string_view value) { return escape_html(value); }
[[nodiscard]] inline std::string argument(const char* value) { return escape_html(value); }
template <class Number>
requires std::is_arithmetic_v<Number>
[[nodiscard]] Number argument(Number value) { return value; }

/// A template of ours, checked when it is compiled, with its {} filled in: `markup("<td class=\"{}\">{}</td>", kind,
/// name)`.
template <class... Arguments>
[[nodiscard]] Markup markup(fmt::format_string<decltype(argument(std::declval<const Arguments&>()))...> form,
                            const Arguments&... arguments)
{
    const fmt::string_view text = form;
    return format_markup({text.data(), text.size()}, argument(arguments)...);
}

}
