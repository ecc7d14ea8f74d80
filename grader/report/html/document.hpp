#pragma once

#include <string>

#include "report/html/markup.hpp"

namespace umbral::grader::html {

struct Document {
    std::string title;
    Markup bar;   ///< what stays at the top of the window
    Markup main;  ///< sections; the first holds the page's only h1
    Markup footer;
};

/// The whole file: the skeleton of page.html with styles and scripts, whose hashes are all that its
/// Content-Security-Policy allows.
[[nodiscard]] std::string document_html(const Document& document);

/// Buttons that every page has at its top: the colour theme, and on pages with checks the previous and the next one.
[[nodiscard]] Markup theme_button();
[[nodiscard]] Markup step_buttons();

}
