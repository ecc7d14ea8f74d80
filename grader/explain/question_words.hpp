#pragma once

#include <string>
#include <vector>

#include <umbral/record/changes.hpp>

namespace umbral::grader {

/// The functions whose calls are changed; one without a name means all.
[[nodiscard]] std::vector<std::string> functions_of(const OtherQuestion& question);

/// "turn.angle negated", "box.bottom taken as box.left", "right and up doubled"
[[nodiscard]] std::string in_words(const OtherQuestion& question, const std::string& headers);

/// "Your results are the right ones for another question: …"; `words` are its own.
[[nodiscard]] std::string sentence(const OtherQuestion& question, const std::string& words);

}
