#pragma once

#include <string>
#include <string_view>

namespace umbral::grader {

/// Is this a name for a submission ([A-Za-z0-9._-]+, at most 128 bytes, not "." or "..")?
[[nodiscard]] bool is_submission_id(std::string_view name);

/// Could a file that reports write have this name (.json, .html, .csv in any case), would a program misread it (it
/// begins with '.' or '-'), or could another system not hold a folder of this name (it ends with '.', or is a device's
/// there: NUL, com1.ana)? Such a name is nobody's id.
[[nodiscard]] bool is_reserved_id(std::string_view name);

/// An id that people recognise, for a folder whose name is none: Latin letters lose their accents, all else becomes
/// '-'. The same name always gives the same id; different names may give the same. Empty if nothing of the name is
/// left.
[[nodiscard]] std::string derived_id(std::string_view name);

/// Eight hexadecimal digits that follow from the bytes of `name`.
[[nodiscard]] std::string short_hash(std::string_view name);

}
