#include <stdexcept>
#include <umbral/gl/forward.hpp>
#include <umbral/gl/trace.hpp>
#include <utility>

namespace umbral::gl {

bool tracing = false;

namespace {
Trace running;  // hidden, as `tracing` is: only the marks below reach it
}

void trace_call(std::size_t slot, std::span<const double> arguments)
{
    TracedCall call{entry_names[slot], {arguments.begin(), arguments.end()}, 0};
    call.bytes = upload_size(call.name, call.arguments);
    running.uploaded_bytes += call.bytes;
    ++running.counts[std::string(call.name)];
    if (running.calls.size() < Trace::maximum_calls)
        running.calls.push_back(std::move(call));
    else
        running.truncated = true;
}

void begin_trace()
{
    if (tracing) throw std::logic_error("gl::begin_trace: a trace is already running; call gl::end_trace first");
    running = {};
    tracing = true;
}

Trace end_trace()
{
    if (!tracing) throw std::logic_error("gl::end_trace: no trace is running; call gl::begin_trace first");
    tracing = false;
    return std::exchange(running, {});
}

}
