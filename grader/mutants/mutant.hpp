#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace umbral::grader {

/// What kind of changes are looked for.
enum class MutantFamily {
    syntax,   ///< one sign of the language after the other
    slips,    ///< what students write instead
    repairs,  ///< what may mend a student's own work
    idle,     ///< functions that return at once, with nothing
    echo      ///< … with what they were given
};

/// A small change of a source, a reference's or a student's, made at run time where the run is given its number.
struct Mutant {
    /// How the change is written into the source.
    enum class Form {
        expression,  ///< the expression from `begin` to `end` becomes `replacement`
        statement,   ///< the statement from `begin` to `end` is left out
        inserted,    ///< `replacement`, a statement, comes in at `begin`
        instead      ///< the statements from `begin` to `end` become `replacement`
    };
    unsigned number = 0;  ///< from 1 in each source; 0 is the reference itself
    Form form = Form::expression;
    std::size_t begin = 0;  ///< offsets in the source, the end behind the last character
    std::size_t end = 0;
    std::size_t line = 0;        ///< from 1
    std::string replacement;     ///< C++
    std::string kind;            ///< "comparison", "sign" …: the operator of the mutation
    std::string change;          ///< for people: "a < b → a <= b"
    bool gives_nothing = false;  ///< an expression of type void
};

}
