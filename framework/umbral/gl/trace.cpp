#include <stdexcept>
#include <umbral/gl/client_memory.hpp>
#include <umbral/gl/display_lists.hpp>
#include <umbral/gl/draw_watch.hpp>
#include <umbral/gl/effects.hpp>
#include <umbral/gl/forward.hpp>
#include <umbral/gl/shared_buffers.hpp>
#include <umbral/gl/trace.hpp>
#include <utility>

namespace umbral::gl {

bool watching = false;

namespace {

// Hidden, as `watching` is: only the marks below and the forwarders reach them.
bool tracing = false;
Trace running;
SharedBuffers shared;
DisplayLists known_lists;
std::function<void()> look;  // of the watch; empty without one
bool looking = false;        // it runs at this moment
bool between_begin_and_end = false;

void update_watching() { watching = tracing || known_lists.recording() || look; }

/// What the table of rules says of the function in a slot, looked up once.
struct Known {
    bool looked_up = false;
    bool always_seen = false;
    bool held_by_lists = false;
    const FunctionRule* rule = nullptr;
};

const Known& known(std::size_t slot)
{
    static std::vector<Known> all(entry_count);
    Known& one = all[slot];
    const std::string_view name = entry_names[slot];
    if (!one.looked_up) one = {true, is_always_seen(name), DisplayLists::holds(name), rule_of(name)};
    return one;
}

/// As deep as OpenGL does lists within lists.
constexpr int deepest_list = 64;

void append(TracedCall call)
{
    running.uploaded_bytes += call.bytes;
    ++running.counts[std::string(call.name)];
    if (running.calls.size() < Trace::maximum_calls)
        running.calls.push_back(std::move(call));
    else
        running.truncated = true;
}

/// What a list does, as if it were called: its data was counted when the list was made.
void append_list(unsigned list, int depth)
{
    const std::vector<DisplayLists::Recorded>* const content = known_lists.content_of(list);
    if (content == nullptr || depth > deepest_list) return;
    for (const DisplayLists::Recorded& each : *content) {
        if (running.truncated) return;
        append({each.call.name, each.call.arguments, 0});
        for (const unsigned inner : each.lists) append_list(inner, depth + 1);
    }
}

/// Bytes that a call copies from the application. Asks the context only where that is allowed in the middle of glBegin
/// and glEnd, or where the call itself is not.
std::uint64_t bytes_moved_by(const TracedCall& call, const FunctionRule* rule, const CallArguments& arguments)
{
    if (rule == nullptr) return 0;
    if (rule->effect != Effect::draws && rule->effect != Effect::uploads && rule->effect != Effect::array) return 0;
    if (rule->effect == Effect::draws && call.name != "glArrayElement" && !call.name.starts_with("glCallList") &&
        !call.name.starts_with("glEval"))
        return client_bytes(call.name, arguments) + shared.moved_before_a_draw();
    const bool pixels = rule->size.kind == Size::Kind::picture || rule->size.kind == Size::Kind::bits;
    if (!pixels || arguments.pointer(rule->size.pointer) != nullptr || !unpacks_from_a_buffer())
        return upload_size(call.name, call.arguments);
    std::vector<double> from_the_beginning = call.arguments;
    from_the_beginning[rule->size.pointer] = 1;
    return upload_size(call.name, from_the_beginning);
}

/// Lets the watch look, if this call begins to draw.
void look_before(std::string_view name, const FunctionRule* rule)
{
    const bool begins = name == "glBegin";
    const bool draws = begins || (rule != nullptr && rule->effect == Effect::draws);
    if (draws && !between_begin_and_end && !known_lists.only_recording()) {
        looking = true;
        look();
        looking = false;
    }
    if (begins || name == "glEnd") between_begin_and_end = begins;
}

}

void trace_call(std::size_t slot, const CallArguments& arguments)
{
    if (looking) return;
    const std::string_view name = entry_names[slot];
    const auto& [looked_up, always_seen, held_by_lists, rule] = known(slot);
    const std::uint64_t moved = always_seen ? shared.moved_by(name, arguments) : 0;
    if (rule != nullptr && rule->effect == Effect::lists) {
        known_lists.note(name, arguments);
        update_watching();
    }
    if (look) look_before(name, rule);
    if (!tracing && !known_lists.recording()) return;
    TracedCall call{name, {arguments.numbers.begin(), arguments.numbers.end()}, 0};
    if (tracing) call.bytes = moved + bytes_moved_by(call, rule, arguments);
    const std::vector<unsigned> called = known_lists.called_by(name, arguments);
    const bool held = known_lists.recording() && held_by_lists;
    if (held) known_lists.add({call, called});
    if (!tracing || (held && known_lists.only_recording() && call.bytes == 0)) return;
    append(std::move(call));
    for (const unsigned list : called) append_list(list, 1);
}

void begin_trace()
{
    if (tracing) throw std::logic_error("gl::begin_trace: a trace is already running; call gl::end_trace first");
    running = {};
    shared.begin_trace();
    tracing = watching = true;
}

Trace end_trace()
{
    if (!tracing) throw std::logic_error("gl::end_trace: no trace is running; call gl::begin_trace first");
    tracing = false;
    update_watching();
    return std::exchange(running, {});
}

DrawWatch::DrawWatch(std::function<void()> function)
{
    if (look) throw std::logic_error("gl::DrawWatch: there is one already");
    look = std::move(function);
    between_begin_and_end = false;
    update_watching();
}

DrawWatch::~DrawWatch()
{
    look = nullptr;
    update_watching();
}

}
