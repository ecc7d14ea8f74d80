#pragma once

namespace umbral::grader {

/// Makes good what whoever started this program may have left it with, and what it and its children cannot work with:
/// standard streams that are closed become /dev/null (else files that are opened later would be taken for them), the
/// end of a child is told again, and no signal is blocked. Called before anything else.
void settle_process() noexcept;

}
