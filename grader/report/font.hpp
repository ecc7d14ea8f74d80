#pragma once

#include <string_view>
#include <umbral/core/grid.hpp>

namespace umbral::grader {

/// Size of a letter of the built-in font, and from one letter to the next, in pixels at scale 1.
inline constexpr int letter_width = 5;
inline constexpr int letter_height = 7;
inline constexpr int letter_advance = 6;

/// Width in pixels of `text` drawn at `scale`.
[[nodiscard]] int text_width(std::string_view text, int scale);

/// Draws `text` with its upper left corner at (x, y); what lies outside the picture is left out.
///
/// The font has letters (small ones look like capitals), digits and . , : + - / % ( ) = *; another character becomes a
/// box.
void draw_text(Image& image, int x, int y, std::string_view text, glm::u8vec4 colour, int scale = 1);

}
