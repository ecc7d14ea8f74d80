#pragma once

#include <clang-c/Index.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace umbral::grader {

/// A part of a source's syntax: what libclang calls a cursor, as far as mutations look at it. Casts and temporaries
/// that nobody wrote are left out.
struct Node {
    CXCursorKind kind = CXCursor_UnexposedExpr;
    std::size_t begin = 0;  ///< offsets in the source
    std::size_t end = 0;
    std::size_t line = 0;
    std::string type;        ///< of expressions, without const: "float"; of functions what they return
    std::string called;      ///< what is called or named: "operator+", "sin"
    std::string sibling;     ///< of a field that is named: the next one of its struct of the same type
    bool is_number = false;  ///< its type is one of numbers, or an enumeration
    std::vector<Node> children;
};

/// A file's text and the functions that it defines, those of its classes too.
struct Syntax {
    std::string text;
    std::vector<Node> functions;

    /// The text of a part.
    [[nodiscard]] std::string_view of(const Node& node) const
    {
        return std::string_view(text).substr(node.begin, node.end - node.begin);
    }
};

/// Parses a C++ file by libclang with the compiler's `flags`. Throws std::runtime_error with the first error.
[[nodiscard]] Syntax parse(const std::string& file, const std::vector<std::string>& flags);

}
