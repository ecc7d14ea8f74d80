#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <umbral/gl/dispatch.hpp>
#include <umbral/gl/forward.hpp>

namespace umbral::gl {

void connect(EntryAddress (*address_of)(const char* name))
{
    for (std::size_t slot = 0; slot < entry_count; ++slot) entries[slot] = address_of(entry_names[slot]);
}

Entry entry_of(std::string_view name)
{
    const auto found = std::find(entry_names, entry_names + entry_count, name);
    return found == entry_names + entry_count ? nullptr : entries[found - entry_names];
}

void disconnect() { std::fill_n(entries, entry_count, nullptr); }

void no_context(std::size_t slot)
{
    (void)std::fprintf(
        stderr,
        "umbral-gl: %s was called while no OpenGL context is current (or the context's driver lacks it). "
        "OpenGL can only be called once a context exists: not from the constructor of a static object, nor after the "
        "window is closed.\n",
        entry_names[slot]);
    std::abort();
}

}
