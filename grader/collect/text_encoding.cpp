#include "collect/text_encoding.hpp"

#include <cstdint>
#include <optional>
#include <string_view>

namespace umbral::grader {
namespace {

enum class Order { little, big };

/// Program text is nearly all ASCII: in UTF-16 nearly every second byte is zero, and no two in a row are.
std::optional<Order> order_without_mark(std::string_view bytes)
{
    if (bytes.size() < 8 || bytes.size() % 2 != 0) return std::nullopt;
    std::size_t even = 0;
    std::size_t odd = 0;
    for (std::size_t i = 0; i < bytes.size(); i += 2) {
        even += bytes[i] == '\0' ? 1 : 0;
        odd += bytes[i + 1] == '\0' ? 1 : 0;
    }
    const std::size_t most = bytes.size() / 2 - bytes.size() / 16;
    if (even == 0 && odd >= most) return Order::little;
    if (odd == 0 && even >= most) return Order::big;
    return std::nullopt;
}

char32_t unit_at(std::string_view bytes, std::size_t at, Order order)
{
    const auto first = static_cast<unsigned char>(bytes[at]);
    const auto second = static_cast<unsigned char>(bytes[at + 1]);
    return order == Order::little ? static_cast<char32_t>(first | second << 8U)
                                  : static_cast<char32_t>(second | first << 8U);
}

void append(std::string& text, char32_t code)
{
    const auto byte = [&](char32_t value) { text += static_cast<char>(value); };
    if (code < 0x80) return byte(code);
    if (code < 0x800) {
        byte(0xC0U | code >> 6U);
    } else {
        if (code < 0x10000) {
            byte(0xE0U | code >> 12U);
        } else {
            byte(0xF0U | code >> 18U);
            byte(0x80U | (code >> 12U & 0x3FU));
        }
        byte(0x80U | (code >> 6U & 0x3FU));
    }
    byte(0x80U | (code & 0x3FU));
}

std::string from_utf16(std::string_view bytes, Order order)
{
    constexpr char32_t replacement = 0xFFFD;
    std::string text;
    text.reserve(bytes.size() / 2);
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
        char32_t code = unit_at(bytes, i, order);
        if (code >= 0xD800 && code < 0xE000) {
            const char32_t low = i + 3 < bytes.size() ? unit_at(bytes, i + 2, order) : 0;
            const bool pair = code < 0xDC00 && low >= 0xDC00 && low < 0xE000;
            code = pair ? 0x10000 + ((code - 0xD800) << 10U) + (low - 0xDC00) : replacement;
            if (pair) i += 2;
        }
        append(text, code);
    }
    if (bytes.size() % 2 != 0) append(text, replacement);
    return text;
}

}

std::string as_utf8(std::string bytes)
{
    const std::string_view view = bytes;
    if (view.starts_with("\xEF\xBB\xBF")) return bytes.substr(3);
    if (view.starts_with("\xFF\xFE")) return from_utf16(view.substr(2), Order::little);
    if (view.starts_with("\xFE\xFF")) return from_utf16(view.substr(2), Order::big);
    if (const auto order = order_without_mark(view)) return from_utf16(view, *order);
    return bytes;
}

}
