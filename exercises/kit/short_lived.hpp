#pragma once

#include <memory>
#include <string_view>
#include <tuple>
#include <umbral/record/ask.hpp>

namespace umbral {

/// As ask_new, with arguments that are gone once the object is made, as a caller's may be: whoever keeps references to
/// them reads what cannot be right.
template <auto Factory, class... Arguments>
[[nodiscard]] auto ask_new_of_short_lived(Recorder& out, std::string_view name, const Arguments&... arguments)
{
    const auto copies = std::make_unique<std::tuple<Arguments...>>(arguments...);
    return std::apply([&](const auto&... each) { return ask_new<Factory>(out, name, each...); }, *copies);
}

}
