#include <stdexcept>

#include "state.hpp"

namespace umbral::input {

Headless::Headless(EventScript script, const HeadlessSettings& settings)
{
    headless::State& now = headless::state();
    if (now.session)
        throw std::logic_error("Headless: expected no session, but one is running; end it before the next begins");
    now = headless::State();
    now.session = true;
    now.script = std::move(script);
    now.settings = settings;
}

Headless::~Headless() { headless::state() = headless::State(); }

const Usage& Headless::usage() const noexcept { return headless::state().usage; }

bool Headless::script_is_over() const noexcept
{
    return headless::state().next_event == headless::state().script.size();
}

}
