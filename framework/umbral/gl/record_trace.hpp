#pragma once

#include <string_view>
#include <umbral/gl/trace.hpp>
#include <umbral/record/recorder.hpp>

namespace umbral::gl {

/// Records a trace as the text `name`, for the judge "trace": a call a line, "glDrawArrays 4 0 3", its arguments as in
/// TracedCall, with " | 128" behind it if it uploads 128 bytes; last a line "..." if the trace is truncated. Throws
/// std::logic_error as Recorder::text does.
void record_trace(Recorder& out, std::string_view name, const Trace& trace);

}
