#pragma once

#include <algorithm>
#include <array>
#include <string>

namespace umbral::grader {

/// A language of statements: the file's name, and the headings that commands look for.
struct Language {
    std::string code;  ///< as in --language
    std::string statement;
    std::string interface;
    std::string hints;
};

inline const std::array languages{Language{"en", "README.md", "## Interface", "## Hints"},
                                  Language{"es", "README.es.md", "## Interfaz", "## Pistas"}};

/// The language with this code; English if there is none.
[[nodiscard]] inline const Language& language_of(const std::string& code)
{
    const auto* const found = std::ranges::find(languages, code, &Language::code);
    return found == languages.end() ? languages.front() : *found;
}

}
