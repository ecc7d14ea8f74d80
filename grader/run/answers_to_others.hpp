#pragma once

#include <vector>

#include <umbral/record/driver.hpp>
#include <umbral/record/questions.hpp>
#include <umbral/record/recorder.hpp>

namespace umbral::grader {

/// What the case records if others are asked in place of its questions, once for each of them; nothing for those that
/// the solution refuses by an exception.
[[nodiscard]] Recorder::Tensors answers_to_others(const DriverCase& one, const Case& what,
                                                  const std::vector<OtherQuestion>& others);

}
