#pragma once

#include <string>

namespace umbral::grader {

/// The secret that hidden cases' seeds follow from: the bytes of the file `named`, or of umbral/secret in the user's
/// configuration folder
/// ($XDG_CONFIG_HOME or ~/.config) if `named` is empty.
///
/// A file that does not exist is made from 32 random bytes, readable by its owner only; it appears whole or not at all,
/// and never replaces one that another grading made meanwhile. The configuration folder is made with it, the folder of
/// a named file is not. Says on the standard error stream that a secret was made, and where, and warns of one that
/// other users can read or write.
///
/// Throws UsageError for what the user can mend: a folder that is missing or cannot be written, no regular file, less
/// than 16 characters or more than 4096 bytes, no permission.
[[nodiscard]] std::string secret_from(const std::string& named);

}
