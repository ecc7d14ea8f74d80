#pragma once

#include <stdexcept>
#include <string>

namespace umbral {

/// Something that a driver found wrong with the student's work before it could be observed, a shader that does not
/// compile, an interface that does not match, or while it was: a library that is used as it must not be.
///
/// It ends the case; `what()` is shown to the student as it stands, so it says what was expected, what came and where.
class StudentError : public std::runtime_error {
public:
    enum class Kind : unsigned { compile_error = 1, interface_mismatch = 2, misuse = 3 };

    StudentError(Kind kind, const std::string& text) : std::runtime_error(text), kind_(kind) {}
    [[nodiscard]] Kind kind() const noexcept { return kind_; }

private:
    Kind kind_;
};

}
